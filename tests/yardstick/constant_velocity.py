"""The yardstick of object velocities: Euclidean clusters of the points above the ground, nearest centroid, one
constant-velocity Kalman filter. A method that loses to it is not finished.

    /usr/bin/python3 tests/yardstick/constant_velocity.py DRIVE TRUTH.csv [RUN]

reads a KITTI drive whose poses are the sensor's in a world with the ground at z = 0, and a truth as `ldm score` takes
it, and prints how many frames of objects faster than 3 m/s are good: found, and |dv| < max(1 m/s, 25 %), from 0.3 s
after the object came into view. With RUN, the folder of an `ldm run` on the drive, its clusters are judged instead, in the
same frames: of those whose centre is in the object's box, the one with most points.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pandas as pd
from scipy import ndimage

CELL = 0.3  # [m]: points in touching cells are one cluster
GROUND = 0.3  # [m]: what is lower is ground
RADIUS = 19.2  # [m]: as the map of the preset `road`
LEAST_POINTS = 8
GATE = 2.0  # [m] between expected and found centroid
ACCELERATION = 3.0  # [m/s^2]
CENTROID_SIGMA = 0.1  # [m]
UNKNOWN_SPEED = 10.0  # standard deviation at first [m/s]
MEMORY = 0.5  # [s]


def clusters(points: np.ndarray) -> list[np.ndarray]:
    """Groups of `points` (n, 3) [m] in touching cells, of LEAST_POINTS or more."""
    if len(points) == 0:
        return []
    cells = np.floor(points / CELL).astype(int)
    cells -= cells.min(axis=0)
    grid = np.zeros(cells.max(axis=0) + 1, dtype=bool)
    grid[tuple(cells.T)] = True
    labels = ndimage.label(grid, np.ones((3, 3, 3)))[0][tuple(cells.T)]
    order = np.argsort(labels, kind="stable")
    groups = np.split(points[order], np.flatnonzero(np.diff(labels[order])) + 1)
    return [group for group in groups if len(group) >= LEAST_POINTS]


@dataclass
class Track:
    """Centroid and velocity, horizontal: mean (4,) and covariance (4, 4) [m, m/s]."""

    mean: np.ndarray
    seen: float
    covariance: np.ndarray = field(
        default_factory=lambda: np.diag([CENTROID_SIGMA**2] * 2 + [UNKNOWN_SPEED**2] * 2))
    points: np.ndarray = field(default_factory=lambda: np.empty((0, 3)))

    def predict(self, dt: float) -> None:
        step = np.eye(4)
        step[0, 2] = step[1, 3] = dt
        gain = np.vstack([np.eye(2) * dt**2 / 2, np.eye(2) * dt])
        self.mean = step @ self.mean
        self.covariance = step @ self.covariance @ step.T + gain @ gain.T * ACCELERATION**2

    def update(self, points: np.ndarray, time: float) -> None:
        innovation = self.covariance[:2, :2] + np.eye(2) * CENTROID_SIGMA**2
        gain = self.covariance[:, :2] @ np.linalg.inv(innovation)
        self.mean = self.mean + gain @ (points[:, :2].mean(axis=0) - self.mean[:2])
        self.covariance = self.covariance - gain @ innovation @ gain.T
        self.points, self.seen = points, time


class Tracker:
    """Nearest centroids first; what none is near begins a track."""

    def __init__(self) -> None:
        self.tracks: list[Track] = []
        self.time: float | None = None

    def update(self, time: float, points: np.ndarray) -> None:
        for track in self.tracks:
            track.predict(time - (time if self.time is None else self.time))
        self.time = time
        found = clusters(points)
        centroids = [group[:, :2].mean(axis=0) for group in found]
        pairs = sorted((np.linalg.norm(track.mean[:2] - centroid), t, c)
                       for t, track in enumerate(self.tracks) for c, centroid in enumerate(centroids))
        taken: tuple[set[int], set[int]] = (set(), set())
        for distance, t, c in pairs:
            if distance < GATE and t not in taken[0] and c not in taken[1]:
                taken[0].add(t)
                taken[1].add(c)
                self.tracks[t].update(found[c], time)
        self.tracks = [track for track in self.tracks if time - track.seen <= MEMORY]
        self.tracks += [Track(np.array([*centroids[c], 0, 0]), time, points=found[c])
                        for c in range(len(found)) if c not in taken[1]]


def inside_box(p: np.ndarray, low: np.ndarray, high: np.ndarray) -> np.ndarray:
    """Which of the points (n, 2) are."""
    return ((p > low) & (p < high)).all(axis=1)


def read_drive(folder: Path) -> list[tuple[float, np.ndarray]]:
    """Time [s] and points (n, 3), world frame [m], of each scan."""
    times = np.loadtxt(folder / "times.txt")
    poses = np.loadtxt(folder / "poses.txt").reshape(-1, 3, 4)
    scans = sorted((folder / "velodyne").glob("*.bin"))
    points = (np.fromfile(scan, np.float32).reshape(-1, 4)[:, :3].astype(float) for scan in scans)
    return [(t, p @ pose[:, :3].T + pose[:, 3]) for t, p, pose in zip(times, points, poses)]


def judged(drive: list[tuple[float, np.ndarray]], truth: pd.DataFrame,
           clusters: pd.DataFrame | None = None) -> pd.DataFrame:
    """A row for each frame of a fast object: its error [m/s] (NaN: not found) and whether that is good."""
    tracker = Tracker()
    since: dict[int, float] = {}
    rows = []
    for frame, (time, points) in enumerate(drive):
        near = (np.abs(points[:, :2]) < RADIUS).all(axis=1) & (points[:, 2] > GROUND)
        tracker.update(time, points[near])
        for _, o in truth[truth.frame == frame].iterrows():
            low, high = (np.array([o.x, o.y]) + s * np.array([o.sx, o.sy]) / 2 + s * 0.2 for s in (-1, 1))

            def inside(p: np.ndarray) -> int:
                return int(inside_box(p[:, :2], low, high).sum())

            if inside(points[near]) < 3:
                continue
            since.setdefault(int(o.id), time)
            speed = np.hypot(o.vx, o.vy)
            if speed < 3 or time - since[int(o.id)] < 0.3:
                continue
            seen = [track for track in tracker.tracks if track.seen == time and inside(track.points) > 0]
            error = np.nan
            if clusters is not None:
                found = clusters[(clusters.frame == frame) & (clusters.track > 0)]
                found = found[inside_box(found[["x_m", "y_m"]].to_numpy(), low, high)]
                if len(found):
                    one = found.loc[found.points.idxmax()]
                    error = np.hypot(one.vx_mps - o.vx, one.vy_mps - o.vy)
            elif seen:
                best = max(seen, key=lambda track: inside(track.points))
                error = np.hypot(best.mean[2] - o.vx, best.mean[3] - o.vy)
            rows.append({"frame": frame, "id": int(o.id), "error": error, "good": error < max(1.0, speed / 4)})
    return pd.DataFrame(rows)


def main(drive: str, truth: str, run: str | None = None) -> None:
    clusters = pd.read_csv(Path(run) / "clusters.csv") if run else None
    rows = judged(read_drive(Path(drive)), pd.read_csv(truth), clusters)
    print(f"{len(rows)} frames of objects above 3 m/s: {100 * rows.good.mean():.1f} % good, "
          f"median error {rows.error.median():.2f} m/s, {int(rows.error.isna().sum())} not found")


if __name__ == "__main__":
    main(*sys.argv[1:])
