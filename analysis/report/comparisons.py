"""Paired comparisons of two methods of a study at one place, and what they say of a claim."""

from __future__ import annotations

import pandas as pd

from analysis.orderings import REPRODUCED, Claim, Ordering
from analysis.records import Study
from analysis.scores import SCORES
from analysis.statistics import PairedComparison, compare_pairs, interval_of_one_more

YES, PARTLY, NO, OPEN = "reproduced", "partly", "not", "open"
"""The verdicts of the ledger; open: what would decide it is missing."""


def per_seed(study: Study, scenario: str, method: str, score: str, point: str = "") -> pd.Series:
    """Replicate -> value of a score; replicates without one are left out."""
    trials = study.trials
    rows = trials[
        (trials["scenario"] == scenario)
        & (trials["method"] == method)
        & (trials["point"] == point)
    ]
    if score not in rows:
        return pd.Series(dtype=float)
    return rows.set_index("replicate")[score].dropna()


def paired(method: pd.Series, baseline: pd.Series, better: str) -> PairedComparison:
    """Compare on the replicates that both have."""
    a, b = method.align(baseline, join="inner")
    return compare_pairs(a.to_numpy(), b.to_numpy(), better)


def compare(
    study: Study, scenario: str, score: str, method: str, baseline: str, point: str = ""
) -> PairedComparison:
    """The same for a score of the records."""
    return paired(
        per_seed(study, scenario, method, score, point),
        per_seed(study, scenario, baseline, score, point),
        SCORES[score].better,
    )


def ordering(claim: Claim, found: PairedComparison) -> Ordering:
    """The claim held against a comparison; without a corrected p."""
    return Ordering(claim, found.difference, found.won, float("nan"))


def verdict_on_order(claim: Claim, found: PairedComparison, differences: pd.Series) -> str:
    """Reproduced: order and size; partly: the order alone.

    The paper shows one run. Its difference has the size of ours if it lies where, by our seeds, one
    more run would lie with a probability of 95%.
    """
    if ordering(claim, found).verdict != REPRODUCED:
        return NO
    low, high = interval_of_one_more(differences.to_numpy())
    return YES if low <= claim.published_difference <= high else PARTLY
