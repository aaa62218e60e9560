"""Wilson's interval and McNemar's exact test against published and hand-worked values."""

import math

import numpy as np
import pytest

from analysis.data.proportions import mcnemar_p, wilson


def test_wilson_of_a_published_case():
    # Newcombe, Statistics in Medicine 17 (1998), Table I: 81 of 263 and 0 of 20, method 3.
    share = wilson(81, 263)
    assert (share.mean, share.n) == (81 / 263, 263)
    assert (share.low, share.high) == pytest.approx((0.2553, 0.3662), abs=5e-5)
    none = wilson(0, 20)
    assert (none.low, none.high) == pytest.approx((0.0, 0.1611), abs=5e-5)


def test_wilson_of_nothing_is_no_interval():
    assert math.isnan(wilson(0, 0).mean)


def test_wilson_is_symmetric():
    few, many = wilson(3, 10), wilson(7, 10)
    assert (1 - many.high, 1 - many.low) == pytest.approx((few.low, few.high))


def test_mcnemar_counts_the_pairs_that_differ():
    both, neither = [(1, 1)] * 30, [(0, 0)] * 9
    pairs = np.array(both + neither + [(1, 0)] * 6 + [(0, 1)])
    # 1 or fewer of 7 fair coins, on both sides: 2 (1 + 7) / 128.
    assert mcnemar_p(pairs[:, 0], pairs[:, 1]) == pytest.approx(16 / 128)


def test_mcnemar_of_equal_arms_is_1():
    assert mcnemar_p(np.array([1, 0, 1]), np.array([1, 0, 1])) == 1
