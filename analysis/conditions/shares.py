"""In which share of the conditions a claim holds, and how much of that each unknown decides."""

from __future__ import annotations

import numpy as np
import pandas as pd
from scipy import stats

PARTS = 3
"""A number's range in parts of equally many conditions; a word is a part of its own."""
RESAMPLES = 199
SEED = 20210088


def parts_of(values: pd.Series) -> pd.Series:
    """The part of each condition: a word itself, or 0, 1, 2 for the lowest third to the highest."""
    if not pd.api.types.is_numeric_dtype(values):
        return values
    return np.minimum((values.rank(method="average", pct=True) * PARTS).astype(int), PARTS - 1)


def share(leans: pd.Series) -> tuple[float, float, float]:
    """Of conditions in which a claim leans the paper's way, with Wilson's 95% interval."""
    if not len(leans):
        return np.nan, np.nan, np.nan
    found = stats.binomtest(int(leans.sum()), len(leans)).proportion_ci(method="wilson")
    return float(leans.mean()), float(found.low), float(found.high)


def decides(leans: np.ndarray, part: np.ndarray) -> float:
    """First-order Sobol index of an unknown, by parts: the share of the variance of `leans` that
    the means of the parts explain, less what parts without a meaning would. May fall below 0."""
    total = leans.var()
    if total == 0 or len(leans) < 2 * PARTS:
        return 0.0
    names, place = np.unique(part, return_inverse=True)
    count = np.bincount(place)
    mean = np.bincount(place, weights=leans) / count
    between = float(np.sum(count * (mean - leans.mean()) ** 2) / len(leans))
    by_chance = (len(names) - 1) / (len(leans) - 1)  # expectation under a random partition
    return (between / total - by_chance) / (1 - by_chance)


def ranking(leans: pd.Series, conditions: pd.DataFrame) -> pd.DataFrame:
    """Unknowns by how much they decide, most first; 95% bootstrap interval over conditions.

    Parameters
    ----------
    leans : by condition
    conditions : a column for each unknown, by condition
    """
    conditions = conditions.loc[leans.index]
    values = leans.to_numpy(dtype=float)
    draws = np.random.default_rng(SEED).integers(len(values), size=(RESAMPLES, len(values)))
    rows = []
    for unknown in conditions:
        part = pd.factorize(parts_of(conditions[unknown]))[0]
        resampled = [decides(values[draw], part[draw]) for draw in draws]
        low, high = np.percentile(resampled, [2.5, 97.5])
        rows.append((unknown, decides(values, part), low, high))
    table = pd.DataFrame(rows, columns=["unknown", "index", "low", "high"])
    return table.sort_values("index", ascending=False, kind="stable", ignore_index=True)
