"""Scores from velocity series: constancy, direction, and the paper's bound on static errors."""

import numpy as np
import pytest

from analysis.data.series import ObjectSeries
from analysis.data.series_scores import (
    better_frames,
    direction_share,
    fluctuation,
    response,
    static_share,
)


def series(truth, estimate, dynamic=True, first=0):
    """Ten frames a second; truth and estimate are (T, 3)."""
    frame = np.arange(first, first + len(truth))
    return ObjectSeries(1, dynamic, frame, frame / 10, np.array(truth, float), np.array(estimate, float),
                        np.zeros(len(truth), bool))  # fmt: skip


def test_fluctuation_is_about_the_mean_and_leaves_the_beginning_out():
    truth = [[1, 0, 0]] * 35
    # Wrong by 5 m/s for the first 1.5 s, then 0.7 or 0.9 m/s: a constant error does not fluctuate.
    estimate = [[6, 0, 0]] * 15 + [[0.7, 0, 0], [0.9, 0, 0]] * 10
    assert fluctuation([series(truth, estimate)]) == pytest.approx(0.1)


def test_fluctuation_needs_a_constant_velocity_in_motion():
    turning = [[np.cos(t), np.sin(t), 0] for t in np.linspace(0, 3, 40)]
    still = [[0, 0, 0]] * 40
    assert np.isnan(fluctuation([series(turning, turning), series(still, still)]))


def test_fluctuation_begins_anew_after_a_change():
    truth = [[1, 0, 0]] * 22 + [[-1, 0, 0]] * 22
    estimate = [[1, 0, 0]] * 22 + [[9, 0, 0]] * 15 + [[-1, 0, 0]] * 7
    assert fluctuation([series(truth, estimate)]) == pytest.approx(0)


def test_direction_is_right_within_45_degrees_and_counts_motion_alone():
    truth = [[1, 0, 0], [1, 0, 0], [1, 0, 0], [0.1, 0, 0]]
    estimate = [[2, 1.9, 0], [2, 2.1, 0], [np.nan] * 3, [-1, 0, 0]]
    assert direction_share([series(truth, estimate)]) == pytest.approx(50)


def test_static_share_asks_for_every_axis():
    estimate = [[0.05, -0.05, 0], [0.01, 0, 0.06], [np.nan] * 3, [0, 0, 0]]
    still = series([[0, 0, 0]] * 4, estimate, dynamic=False)
    moving = series([[1, 0, 0]], [[0, 0, 0]])
    assert static_share([still, moving]) == pytest.approx(100 * 2 / 3)


def test_response_is_the_time_until_most_of_the_velocity_is_estimated():
    truth = [[0, 0, 0]] * 5 + [[0, -1, 0]] * 30
    # 79 % in the right direction is not enough; sideways motion does not count.
    estimate = [[0, 0, 0]] * 5 + [[3, -0.79, 0]] * 12 + [[0, -0.81, 0]] * 18
    assert response([series(truth, estimate)]) == pytest.approx(1.2)


def test_a_velocity_never_followed_counts_with_its_length():
    truth = [[1, 0, 0]] * 31
    assert response([series(truth, [[0.5, 0, 0]] * 31)]) == pytest.approx(3)
    assert np.isnan(response([series(truth, truth, dynamic=False)]))
    assert np.isnan(response([series(truth[:10], truth[:10])]))  # too short to say


def test_better_frames_are_those_in_which_the_first_errs_less():
    still = [[0, 0, 0]] * 4
    ours = series(still, [[0.1, 0, 0], [0.3, 0, 0], [np.nan] * 3, [0.1, 0, 0]], dynamic=False)
    theirs = series(still, [[0.2, 0, 0]] * 4, dynamic=False)
    assert better_frames([ours], [theirs]) == pytest.approx(100 * 2 / 3)
    assert np.isnan(better_frames([ours], [series(still, still)]))
