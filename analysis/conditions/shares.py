"""In which share of the conditions a claim holds, and how much of that each unknown decides."""

from __future__ import annotations

import numpy as np
import pandas as pd
from scipy import stats

PARTS = 3
"""A number's range in parts of equally many conditions; a word is a part of its own."""
FEWEST = 10
"""Conditions from which on a ranking means anything."""
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


def decides(leans: np.ndarray, part: np.ndarray) -> np.ndarray:
    """First-order Sobol index of an unknown, by parts: the share of the variance of `leans` that
    the means of the parts explain, less what parts without a meaning would. May fall below 0.

    Parameters
    ----------
    leans, part : (..., n) of the same shape, n more than parts; parts are numbered from 0

    Returns
    -------
    (...), one for each row; 0 where `leans` does not vary
    """
    n = leans.shape[-1]
    inside = part[..., None] == np.arange(part.max(initial=0) + 1)
    count = inside.sum(axis=-2)
    mean = (inside * leans[..., None]).sum(axis=-2) / np.maximum(count, 1)
    overall = leans.mean(axis=-1, keepdims=True)
    between = (count * (mean - overall) ** 2).sum(axis=-1) / n
    total = leans.var(axis=-1)
    by_chance = ((count > 0).sum(axis=-1) - 1) / (n - 1)  # expected of a random partition
    index = (between / np.where(total > 0, total, 1) - by_chance) / (1 - by_chance)
    return np.where(total > 0, index, 0.0)


def ranking(leans: pd.Series, conditions: pd.DataFrame) -> pd.DataFrame:
    """Unknowns by how much they decide, most first; 95% bootstrap interval over conditions. Of fewer
    than FEWEST conditions nothing is said: NaN.

    Parameters
    ----------
    leans : by condition
    conditions : a column for each unknown, by condition
    """
    conditions = conditions.loc[leans.index]
    values = leans.to_numpy(dtype=float)
    if len(values) < FEWEST:
        return pd.DataFrame({"unknown": conditions.columns, "index": np.nan, "low": np.nan,
                             "high": np.nan})  # fmt: skip
    draws = np.random.default_rng(SEED).integers(len(values), size=(RESAMPLES, len(values)))
    rows = []
    for unknown in conditions:
        part = pd.factorize(parts_of(conditions[unknown]))[0]
        low, high = np.percentile(decides(values[draws], part[draws]), [2.5, 97.5])
        rows.append((unknown, float(decides(values, part)), low, high))
    table = pd.DataFrame(rows, columns=["unknown", "index", "low", "high"])
    return table.sort_values("index", ascending=False, kind="stable", ignore_index=True)
