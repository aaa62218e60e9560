"""Shares of successes: Wilson's interval, and McNemar's exact test of paired successes."""

from __future__ import annotations

import math

import numpy as np
from scipy import stats

from analysis.data.statistics import CONFIDENCE, Interval


def wilson(successes: int, n: int) -> Interval:
    """Share of successes with Wilson's score interval (E. B. Wilson, 1927); NaN for n = 0."""
    if n == 0:
        return Interval(math.nan, math.nan, math.nan, 0)
    z = float(stats.norm.ppf((1 + CONFIDENCE) / 2))
    share = successes / n
    middle = (share + z * z / (2 * n)) / (1 + z * z / n)
    reach = z / (1 + z * z / n) * math.sqrt(share * (1 - share) / n + (z / (2 * n)) ** 2)
    # At 0 and 1 it touches its own end, but for rounding.
    return Interval(share, max(0.0, min(middle - reach, share)), min(1.0, max(middle + reach, share)), n)


def mcnemar_p(a: np.ndarray, b: np.ndarray) -> float:
    """Two-sided exact p of McNemar's test: the pairs in which one alone succeeds are fair coins.

    Parameters
    ----------
    a, b : (n,) 1 for a success, 0 for none, of the same seeds in the same order
    """
    a, b = np.asarray(a, dtype=bool), np.asarray(b, dtype=bool)
    only_a, only_b = int(np.sum(a & ~b)), int(np.sum(~a & b))
    if only_a + only_b == 0:
        return 1.0
    return float(stats.binomtest(only_a, only_a + only_b).pvalue)
