"""Statistics over seeds: bootstrap interval, paired difference, signed-rank test, seeds needed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import stats

CONFIDENCE = 0.95
RESAMPLES = 9999
BOOTSTRAP_SEED = 20210088
"""Any fixed number: the same records give the same table."""

LEAST_SEEDS = 5
"""With fewer an interval says little: it is drawn from the same few values again and again."""

SIGNIFICANCE = 0.05
POWER = 0.8


@dataclass(frozen=True)
class Interval:
    """A mean and its 95% interval."""

    mean: float  # NaN if n == 0
    low: float  # NaN if n < 2
    high: float  # NaN if n < 2
    n: int  # number of seeds

    @property
    def excludes_zero(self) -> bool:
        """True if the whole interval lies on one side of 0; False without an interval."""
        return self.low > 0 or self.high < 0


@dataclass(frozen=True)
class PairedComparison:
    """Method against baseline on the same seeds; the difference is method - baseline."""

    difference: Interval
    sd: float  # of the differences; NaN if n < 2
    won: float  # share of the seeds on which the method is better, ties count half; NaN if n == 0
    p: float  # two-sided Wilcoxon signed-rank test; NaN if n == 0


def mean_interval(values: np.ndarray) -> Interval:
    """Mean and BCa bootstrap interval (9999 resamples, fixed seed) over seeds.

    Parameters
    ----------
    values : (n,) one per seed; NaN are left out

    Notes
    -----
    One value has no interval. Equal values have the interval [mean, mean]: the data show no spread.
    With few seeds a bootstrap interval is too short (10 normal values: it covers about 90%).
    """
    values = np.asarray(values, dtype=float)
    values = values[~np.isnan(values)]
    n = len(values)
    if n == 0:
        return Interval(math.nan, math.nan, math.nan, 0)
    mean = float(np.mean(values))
    if n == 1:
        return Interval(mean, math.nan, math.nan, 1)
    if np.all(values == values[0]):
        return Interval(float(values[0]), float(values[0]), float(values[0]), n)
    found = stats.bootstrap(
        (values,),
        np.mean,
        n_resamples=RESAMPLES,
        confidence_level=CONFIDENCE,
        method="BCa",
        random_state=BOOTSTRAP_SEED,
    ).confidence_interval
    return Interval(mean, float(found.low), float(found.high), n)


def interval_of_one_more(values: np.ndarray) -> tuple[float, float]:
    """Where one more value would lie with a probability of 95%, if all are normal (Student's t).

    Parameters
    ----------
    values : (n,) one per seed; of fewer than two nothing is known, and the interval is everything
    """
    values = np.asarray(values, dtype=float)
    if len(values) < 2:
        return -math.inf, math.inf
    quantile = stats.t.ppf((1 + CONFIDENCE) / 2, len(values) - 1)
    reach = float(quantile * np.std(values, ddof=1) * math.sqrt(1 + 1 / len(values)))
    mean = float(np.mean(values))
    return mean - reach, mean + reach


def compare_pairs(method: np.ndarray, baseline: np.ndarray, better: str) -> PairedComparison:
    """Compare two methods on the same seeds.

    Parameters
    ----------
    method, baseline : (n,) of the same seeds in the same order; pairs with a NaN are left out
    better : "lower" or "higher"
    """
    difference = np.asarray(method, dtype=float) - np.asarray(baseline, dtype=float)
    difference = difference[~np.isnan(difference)]
    if len(difference) == 0:
        return PairedComparison(mean_interval(difference), math.nan, math.nan, math.nan)
    gain = difference if better == "higher" else -difference
    return PairedComparison(
        difference=mean_interval(difference),
        sd=float(np.std(difference, ddof=1)) if len(difference) > 1 else math.nan,
        won=float(np.mean(np.where(gain == 0, 0.5, gain > 0))),
        p=signed_rank_p(difference),
    )


def signed_rank_p(difference: np.ndarray) -> float:
    """Two-sided p of Wilcoxon's signed-rank test; zeros are dropped, all zeros give 1.

    With n seeds it cannot fall below 2 / 2**n: 6 seeds are the fewest that can reach 0.05.
    """
    difference = difference[difference != 0]
    if len(difference) == 0:
        return 1.0
    return float(stats.wilcoxon(difference).pvalue)


def holm(p: np.ndarray) -> np.ndarray:
    """Holm's step-down correction of the p-values (m,) of one table; NaN stay and do not count."""
    p = np.asarray(p, dtype=float)
    adjusted = np.full(len(p), math.nan)
    tested = np.flatnonzero(~np.isnan(p))
    order = tested[np.argsort(p[tested], kind="stable")]
    factors = np.arange(len(order), 0, -1)
    adjusted[order] = np.minimum(1.0, np.maximum.accumulate(factors * p[order]))
    return adjusted


def seeds_needed(sd: float, smallest_difference: float) -> int | None:
    """Seeds with which the smallest interesting difference would be found with a power of 80%.

    n = (z(1 - a/2) + z(power))^2 sd^2 / delta^2 * pi/3, with a = 0.05, sd of the paired differences
    and delta the smallest difference; pi/3 is what the signed-rank test costs against the t test on
    normal differences. At least 6, the fewest with which the test can reach 0.05.
    None if sd is NaN.
    """
    if math.isnan(sd):
        return None
    z = stats.norm.ppf(1 - SIGNIFICANCE / 2) + stats.norm.ppf(POWER)
    return max(6, math.ceil((z * sd / smallest_difference) ** 2 * math.pi / 3))
