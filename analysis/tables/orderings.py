"""Which of the paper's orderings of two methods reproduce."""

from __future__ import annotations

import math
from dataclasses import dataclass

import pandas as pd

from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.data.statistics import Interval
from analysis.tables.beside import scenario_name, separate
from analysis.tables.paired_table import paired_table
from analysis.tables.text_table import NOTHING, aligned, interval, p_value

REPRODUCED = "reproduced"
UNDECIDED = "not reproduced: interval includes 0"
OPPOSITE = "not reproduced: opposite"
ONE_SEED = "not reproduced: one seed has no interval"
NO_TRIALS = "not reproduced: no trials"


@dataclass(frozen=True)
class Claim:
    """The paper gives a method another value of a score than a baseline."""

    scenario: str
    score: str
    method: str
    baseline: str
    published_difference: float  # method - baseline

    @property
    def word(self) -> str:
        """`better` or `worse`: what the paper says of the method."""
        higher = self.published_difference > 0
        return "better" if higher == (SCORES[self.score].better == "higher") else "worse"


@dataclass(frozen=True)
class Ordering:
    """A claim and what we found."""

    claim: Claim
    difference: Interval  # ours: method - baseline over the same seeds
    won: float  # share of the seeds on which the method is better; NaN without trials
    p_holm: float  # NaN without trials

    @property
    def verdict(self) -> str:
        """Reproduced only if the 95% interval of our difference lies on the paper's side of 0."""
        if self.difference.n < 2:
            return ONE_SEED if self.difference.n else NO_TRIALS
        if not self.difference.excludes_zero:
            return UNDECIDED
        same = (self.difference.mean > 0) == (self.claim.published_difference > 0)
        return REPRODUCED if same else OPPOSITE


def published_claims(scenario: str, score: str, values: dict[str, float]) -> list[Claim]:
    """The claims in published values, {method: value, baseline: value, another baseline: ...}."""
    (method, value), *others = values.items()
    return [Claim(scenario, score, method, baseline, value - other) for baseline, other in others]


def judge(study: Study, claims: list[Claim]) -> list[Ordering]:
    """Hold claims against the paired differences of a study; Holm's correction runs over them."""
    pairs = list(dict.fromkeys((claim.method, claim.baseline) for claim in claims))
    scores = list(dict.fromkeys(claim.score for claim in claims))
    table = paired_table(study, pairs, [SCORES[score] for score in scores])
    table = table.set_index(["scenario", "score", "method", "baseline"])
    claimed = [(c.scenario, c.score, c.method, c.baseline) for c in claims]
    return [
        _ordering(claim, row)
        for claim, (_, row) in zip(claims, table.reindex(claimed).iterrows(), strict=True)
    ]


def orderings_text(found: list[Ordering]) -> str:
    """One line for each ordering."""
    several = len({ordering.claim.baseline for ordering in found}) > 1
    against = ["against"] if several else []
    head = ["", "", *against, "paper", "ours", "seeds won", "p (Holm)", "verdict"]
    rows = []
    for ordering in found:
        claim = ordering.claim
        score = SCORES[claim.score]
        rows.append(
            [
                scenario_name(claim.scenario),
                score.axis_label,
                *([claim.baseline] if several else []),
                claim.word,
                interval(ordering.difference, score.difference_decimals, sign=True),
                NOTHING if math.isnan(ordering.won) else f"{ordering.won:.0%}",
                p_value(ordering.p_holm),
                ordering.verdict,
            ]
        )
    return aligned(head, separate(rows), left=3 + several, last_left=True)


def orderings_frame(found: list[Ordering]) -> pd.DataFrame:
    """The orderings as a table of plain values."""
    return pd.DataFrame(
        [
            vars(o.claim)
            | {"claim": o.claim.word, "difference": o.difference.mean, "low": o.difference.low}
            | {"high": o.difference.high, "seeds": o.difference.n, "won": o.won}
            | {"p_holm": o.p_holm, "verdict": o.verdict}
            for o in found
        ]
    )


def _ordering(claim: Claim, row: pd.Series) -> Ordering:
    seeds = 0 if math.isnan(row["seeds"]) else int(row["seeds"])
    difference = Interval(row["difference"], row["low"], row["high"], seeds)
    return Ordering(claim, difference, row["won"], row["p_holm"])
