"""What measures of trials say of the paper's claims, and how far they are from its numbers.

Measures are a table with the columns scenario, method, replicate, measure, value (measures.py).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import Iterable

import numpy as np
import pandas as pd
from scipy import stats

from analysis.conditions.claims import METHOD, Claim, claims, pf_readings

LEVEL = 0.05
"""Of each one-sided test; two of them make the 90% interval."""
MOST = 3.0
"""What one number can add to the distance, in units of its scale."""

_CERTAIN = 30.0  # standard errors: no test misses that, and scipy's distribution ends not far beyond

HOLDS, FAILS, UNDECIDED, MISSING = "holds", "fails", "undecided", "missing"


@dataclass(frozen=True)
class Outcome:
    """One claim and what was found."""

    claim: Claim
    mean: float  # of x; NaN without a trial
    low: float  # 90% interval of the mean; NaN with fewer than two
    high: float
    n: int
    verdict: str
    power: float
    """Probability that the test finds the claim if the paper's number is true and worlds scatter as
    ours do; NaN where it gives none or with fewer than two worlds."""

    @property
    def leans(self) -> bool:
        """The mean itself lies where the claim wants it: all that one world can say."""
        on_zero = self.claim.kind == "order" and self.mean == 0
        return self.claim.low <= self.mean <= self.claim.high and not on_zero


def outcomes(measures: pd.DataFrame) -> list[Outcome]:
    """Every claim held against the measures of one condition."""
    table = measures.pivot_table(
        index=["scenario", "method", "measure"], columns="replicate", values="value"
    )
    return [decide(claim, samples(claim, table)) for claim in claims()]


def samples(claim: Claim, table: pd.DataFrame) -> np.ndarray:
    """x of each world, (n,); a share of the baseline's mean is linearised, so that the spread of
    the samples is that of the ratio (delta method)."""
    value = _row(table, claim.scenario, METHOD, claim.measure)
    if claim.measure == "static_better_pct":  # compares two methods by itself
        value = _row(table, claim.scenario, METHOD, f"{claim.measure}.{claim.baseline}")
    elif claim.baseline:
        baseline = _row(table, claim.scenario, claim.baseline, claim.measure)
        value, baseline = value.align(baseline, join="inner")
        difference = value - baseline
        if claim.relative and len(difference) and baseline.mean():
            share = difference.mean() / baseline.mean()
            difference = 100 * (share + (difference - share * baseline) / baseline.mean())
        value = difference
    return value.to_numpy()


def decide(claim: Claim, x: np.ndarray) -> Outcome:
    """The verdict that the file of claims defines, by the 90% interval of the mean."""
    found = partial(Outcome, claim, n=len(x))
    if not len(x):
        return found(math.nan, math.nan, math.nan, verdict=MISSING, power=math.nan)
    mean = float(np.mean(x))
    if len(x) < 2:
        return found(mean, math.nan, math.nan, verdict=UNDECIDED, power=math.nan)
    reach = _quantile(len(x)) * _error(x)
    low, high = mean - reach, mean + reach
    if claim.low < low and high < claim.high:
        verdict = HOLDS
    elif high < claim.low or claim.high < low:
        verdict = FAILS
    else:
        verdict = UNDECIDED
    return found(mean, low, high, verdict=verdict, power=_power(claim, x))


def distance(found: Iterable[Outcome]) -> tuple[float, str]:
    """To the paper over all its numbers, and the reading of "[11] with PF" that is nearer.

    NaN if a claim that counts has no trial.
    """
    found = list(found)
    by_reading = {reading: _distance(found, reading) for reading in pf_readings()}
    if any(math.isnan(value) for value in by_reading.values()):
        return math.nan, ""
    nearest = min(by_reading, key=by_reading.get)
    return by_reading[nearest], nearest


def deviation(outcome: Outcome) -> float:
    """z of the file of claims: from the paper's number, or beyond the limit, in units of the scale."""
    claim = outcome.claim
    if claim.paper is not None:
        beyond = abs(outcome.mean - claim.paper)
    else:
        beyond = max(claim.low - outcome.mean, outcome.mean - claim.high, 0.0)
    return min(beyond / claim.scale, MOST) if not math.isnan(outcome.mean) else math.nan


def of_reading(found: Iterable[Outcome], reading: str) -> list[Outcome]:
    """Without the claims against the other readings of "[11] with PF"."""
    others = set(pf_readings()) - {reading}
    return [outcome for outcome in found if outcome.claim.baseline not in others]


def _distance(found: list[Outcome], reading: str) -> float:
    squares: dict[str, list[float]] = {}
    for outcome in of_reading(found, reading):
        if outcome.claim.scale is not None:
            squares.setdefault(outcome.claim.group, []).append(deviation(outcome) ** 2)
    return math.sqrt(np.mean([np.mean(of_group) for of_group in squares.values()]))


def _power(claim: Claim, x: np.ndarray) -> float:
    """Of the test of this claim at the paper's number; at least one of its bounds is finite."""
    if claim.paper is None or claim.name == "constancy_order":
        return math.nan
    error = _error(x)
    if error == 0:
        return 1.0
    bounds = [bound for bound in (claim.low, claim.high) if math.isfinite(bound)]
    reach = [min(abs(bound - claim.paper) / error, _CERTAIN) for bound in bounds]
    with np.errstate(divide="ignore", invalid="ignore"):  # scipy 1.10 raises flags beside right values
        missed = sum(stats.nct.cdf(_quantile(len(x)), len(x) - 1, shift) for shift in reach)
    return max(0.0, float(1 - missed))


def _row(table: pd.DataFrame, scenario: str, method: str, measure: str) -> pd.Series:
    key = (scenario, method, measure)
    return table.loc[key].dropna() if key in table.index else pd.Series(dtype=float)


def _error(x: np.ndarray) -> float:
    """Standard error of the mean."""
    return float(np.std(x, ddof=1) / math.sqrt(len(x)))


def _quantile(n: int) -> float:
    return float(stats.t.ppf(1 - LEVEL, n - 1))
