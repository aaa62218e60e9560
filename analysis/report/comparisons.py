"""Paired comparisons of two methods of a study at one place, and what they say of a claim."""

from __future__ import annotations

import pandas as pd

from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.data.statistics import PairedComparison, compare_pairs, interval_of_one_more
from analysis.tables.orderings import REPRODUCED, Claim, Ordering

YES, PARTLY, NO, OPEN = "reproduced", "partly", "not", "open"
"""The verdicts of the ledger; open: what would decide it is missing."""


def paired(method: pd.Series, baseline: pd.Series, better: str) -> PairedComparison:
    """Compare on the replicates that both have."""
    a, b = method.align(baseline, join="inner")
    return compare_pairs(a.to_numpy(), b.to_numpy(), better)


def compare(
    study: Study, scenario: str, score: str, method: str, baseline: str, point: str = ""
) -> PairedComparison:
    """The same for a score of the records."""
    return paired(
        study.per_seed(scenario, method, score, point),
        study.per_seed(scenario, baseline, score, point),
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
