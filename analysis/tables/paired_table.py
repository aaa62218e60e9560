"""The paired comparisons of one table: differences, seeds won, tests corrected together."""

from __future__ import annotations

import math
from typing import Iterable

import pandas as pd

from analysis.data.errors import InputError
from analysis.data.records import Study
from analysis.data.scores import Score
from analysis.data.statistics import compare_pairs, holm, seeds_needed

COLUMNS = [
    "scenario", "point", "score", "method", "baseline", "seeds", "mean_method", "mean_baseline",
    "difference", "low", "high", "won", "p", "p_holm", "seeds_needed",
]  # fmt: skip


def paired_table(
    study: Study, pairs: Iterable[tuple[str, str]], scores: Iterable[Score]
) -> pd.DataFrame:
    """One row for each scenario, point, score and pair (method, baseline).

    The difference is method - baseline over the replicates that both have; `won` is the share of
    them on which the method is better. Holm's correction runs over all rows of the table. A score
    that one of the two does not have gives no row.
    """
    scores = [score for score in scores if score.name in study.trials]
    rows = []
    for (scenario, point), trials in study.trials.groupby(["scenario", "point"], sort=False):
        by_method = {m: t.set_index("replicate") for m, t in trials.groupby("method")}
        for score in scores:
            for method, baseline in pairs:
                if method in by_method and baseline in by_method:
                    row = _compare(by_method[method], by_method[baseline], score, study.frames)
                    names = (scenario, point, score.name, method, baseline)
                    if row:
                        rows.append(names + row)
    table = pd.DataFrame(rows, columns=COLUMNS)
    table["p_holm"] = holm(table["p"].to_numpy(dtype=float))
    table["seeds_needed"] = table["seeds_needed"].astype("Int64")
    return table


def all_pairs(study: Study, methods: list[str]) -> list[tuple[str, str]]:
    """Each of `methods` against every other method of the study, no pair twice.

    Raises
    ------
    InputError
        If the study has no such method.
    """
    for method in methods:
        if method not in study.methods:
            raise InputError(
                f"{study.folder}: has no method {method!r}; it has {', '.join(study.methods)}"
            )
    pairs: list[tuple[str, str]] = []
    for method in methods:
        for other in study.methods:
            if other != method and (other, method) not in pairs:
                pairs.append((method, other))
    return pairs


def _compare(
    method: pd.DataFrame, baseline: pd.DataFrame, score: Score, frames: int
) -> tuple | None:
    """The columns from `seeds` to `seeds_needed`, `p_holm` still empty; None without a pair."""
    a, b = method[score.name].dropna().align(baseline[score.name].dropna(), join="inner")
    if a.empty:
        return None
    found = compare_pairs(a.to_numpy(), b.to_numpy(), score.better)
    difference = found.difference
    needed = seeds_needed(found.sd, score.interesting(frames))
    return (
        difference.n, a.mean(), b.mean(), difference.mean, difference.low, difference.high,
        found.won, found.p, math.nan, needed,
    )  # fmt: skip
