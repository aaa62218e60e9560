"""Statistics against hand-computed values and closed forms."""

import math

import numpy as np
import pytest

from analysis.data.statistics import (
    compare_pairs,
    holm,
    interval_of_one_more,
    mean_interval,
    seeds_needed,
    signed_rank_p,
)


def test_interval_of_many_normal_values_is_the_normal_one():
    values = np.random.default_rng(3).normal(10, 2, 400)
    found = mean_interval(values)
    half = 1.96 * values.std(ddof=1) / math.sqrt(400)
    assert found.mean == pytest.approx(values.mean())
    assert found.low == pytest.approx(values.mean() - half, abs=0.05 * half)
    assert found.high == pytest.approx(values.mean() + half, abs=0.05 * half)


def test_interval_of_a_skewed_sample_reaches_further_on_the_long_side():
    found = mean_interval([1, 1, 1, 1, 1, 1, 1, 1, 2, 9])
    assert found.high - found.mean > found.mean - found.low


def test_interval_is_the_same_every_time():
    values = [3.0, 1.0, 4.0, 1.0, 5.0]
    assert mean_interval(values) == mean_interval(values)


def test_one_value_has_no_interval():
    found = mean_interval([7.0])
    assert (found.mean, found.n) == (7.0, 1)
    assert math.isnan(found.low) and math.isnan(found.high)
    assert not found.excludes_zero


def test_equal_values_have_an_interval_of_length_zero():
    found = mean_interval([0.1] * 10)
    assert (found.mean, found.low, found.high, found.n) == (0.1, 0.1, 0.1, 10)


def test_nan_is_left_out_and_nothing_gives_nothing():
    assert mean_interval([2.0, math.nan, 2.0]).n == 2
    empty = mean_interval([math.nan])
    assert empty.n == 0 and math.isnan(empty.mean)


def test_paired_comparison_by_hand():
    # Differences -1, -2, +3, 0: two wins and half a win of four where lower is better.
    method, baseline = np.array([1.0, 2, 6, 4]), np.array([2.0, 4, 3, 4])
    found = compare_pairs(method, baseline, "lower")
    assert found.difference.mean == 0
    assert found.won == (2 + 0.5) / 4
    assert compare_pairs(method, baseline, "higher").won == (1 + 0.5) / 4
    assert found.sd == pytest.approx(math.sqrt(14 / 3))


def test_pairs_with_a_gap_do_not_count():
    found = compare_pairs(np.array([1.0, math.nan, 3]), np.array([0.0, 5, math.nan]), "higher")
    assert found.difference.n == 1 and found.won == 1 and math.isnan(found.sd)


def test_no_pairs_at_all():
    found = compare_pairs(np.array([]), np.array([]), "lower")
    assert found.difference.n == 0 and math.isnan(found.won) and math.isnan(found.p)


def test_signed_rank_by_hand():
    # All six on one side: 2 of 2**6 sign patterns are as extreme.
    assert signed_rank_p(np.array([1.0, 2, 3, 4, 5, 6])) == pytest.approx(2 / 64)
    # Ranks 1 to 4, the 4 negative: of 16 patterns 7 have a rank sum of 4 or less.
    assert signed_rank_p(np.array([1.0, 2, 3, -4])) == pytest.approx(2 * 7 / 16)
    # Zeros are dropped before ranking.
    assert signed_rank_p(np.array([0.0, 1, 2, 3, -4, 0])) == pytest.approx(2 * 7 / 16)
    assert signed_rank_p(np.zeros(5)) == 1


def test_holm_by_hand():
    # In order .01, .03, .04: times 3, 2, 1, and never less than the one before; 1 at most.
    found = holm([0.01, 0.04, 0.03, math.nan])
    assert found[:3] == pytest.approx([0.03, 0.06, 0.06])
    assert math.isnan(found[3])
    assert holm([0.6, 0.9]) == pytest.approx([1.0, 1.0])
    assert len(holm([])) == 0


def test_seeds_needed_by_hand():
    # (1.95996 + 0.84162)^2 = 7.8489; times pi/3 = 8.2193 for sd = delta.
    assert seeds_needed(1.0, 1.0) == 9
    assert seeds_needed(2.0, 1.0) == 33
    assert seeds_needed(0.0, 1.0) == 6
    assert seeds_needed(math.nan, 1.0) is None


def test_one_more_value_of_a_normal_sample():
    # By hand: mean 2, sd 1, t(0.975, 2) = 4.303, reach 4.303 * sqrt(4 / 3) = 4.968.
    assert interval_of_one_more([1.0, 2.0, 3.0]) == pytest.approx((-2.968, 6.968), abs=1e-3)
    assert interval_of_one_more([1.0]) == (-np.inf, np.inf)
