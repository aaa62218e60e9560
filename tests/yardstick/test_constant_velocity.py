"""The yardstick is right where that is known: a cloud that goes straight, and two that stay apart."""

from __future__ import annotations

import numpy as np
import pandas as pd

from constant_velocity import Tracker, clusters, judged

EXPECTED = [[5.00073, 6.7015], [0, 0.10002]]  # [m/s]
EXPECTED_VARIANCE = 0.19235  # [m^2/s^2]


def cloud(x: float, y: float) -> np.ndarray:
    """125 points, 0.2 m apart."""
    steps = np.arange(5) * 0.2 - 0.4
    grid = np.stack(np.meshgrid(steps, steps, steps + 1), axis=-1).reshape(-1, 3)
    return grid + [x, y, 0]


def test_clusters_are_what_touches() -> None:
    assert clusters(np.empty((0, 3))) == []
    found = clusters(np.vstack([cloud(0, 0), cloud(3, 0), [[10, 10, 1]]]))
    assert sorted(len(group) for group in found) == [125, 125]  # the single point is too few


def test_velocity_of_what_goes_straight() -> None:
    tracker = Tracker()
    for k in range(20):
        tracker.update(k / 10, np.vstack([cloud(-5 + 0.8 * k, 2), cloud(0, -3)]))
    assert len(tracker.tracks) == 2
    velocities = sorted(float(track.mean[2]) for track in tracker.tracks)
    np.testing.assert_allclose(velocities, [0, 8], atol=0.05)


def test_frames_are_good_if_the_error_is_small() -> None:
    drive = [(k / 10, cloud(-5 + 0.8 * k, 2)) for k in range(12)]
    truth = pd.DataFrame([{"frame": k, "id": 1, "x": -5 + 0.8 * k, "y": 2, "vx": v, "vy": 0, "sx": 1, "sy": 1}
                          for k in range(12) for v in [8 if k < 8 else 20]])
    rows = judged(drive, truth)
    assert list(rows.frame) == list(range(3, 12))
    assert list(rows.good) == [True] * 5 + [False] * 4


def test_clusters_of_a_run_are_judged_in_the_same_frames() -> None:
    drive = [(k / 10, cloud(-5 + 0.8 * k, 2)) for k in range(6)]
    truth = pd.DataFrame([{"frame": k, "id": 1, "x": -5 + 0.8 * k, "y": 2, "vx": 8, "vy": 0, "sx": 1, "sy": 1}
                          for k in range(6)])
    row = {"frame": 4, "track": 3, "x_m": -1.8, "y_m": 2, "vx_mps": 7, "vy_mps": 0, "points": 90}
    clusters = pd.DataFrame([row, row | {"vx_mps": 0, "points": 5}, row | {"frame": 5},
                             row | {"frame": 3, "x_m": -2.6, "track": 0}])
    rows = judged(drive, truth, clusters)
    assert list(rows.frame) == [3, 4, 5]
    assert list(rows.good) == [False, True, False]  # not followed; 1 m/s off; not there
    assert rows.error.tolist()[1] == 1


def test_velocities_are_those_of_the_method_centroid_kalman() -> None:
    """The same clouds and numbers as in tests/baselines/centroid_kalman_test.cpp."""
    tracker = Tracker()
    for k in range(10):
        there = [cloud(-3 + 0.5 * k, 2 + 0.05 * k * k)] + ([cloud(0, -3 + 0.01 * k)] if k >= 3 else [])
        tracker.update(k / 10, np.vstack(there))
    np.testing.assert_allclose([track.mean[2:] for track in tracker.tracks], EXPECTED, atol=1e-4)
    np.testing.assert_allclose(tracker.tracks[0].covariance[2, 2], EXPECTED_VARIANCE, atol=1e-5)
