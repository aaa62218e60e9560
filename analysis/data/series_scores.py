"""Scores that the paper states in words and the records do not hold: from the velocity series."""

from __future__ import annotations

from typing import Callable

import numpy as np
import pandas as pd

from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.series import ObjectSeries, read_series

SETTLED_S = 1.5
"""Time after a change of the true velocity, or after entering the map, that is left out [s]; the
same as in the steady velocity errors of experiments/RECORD.md."""
LEAST_S = 0.5
"""Shortest stretch of constant true velocity that counts [s]."""
MOVING_MPS = 0.2
"""A slower object has no direction worth a score [m/s]; the LDM's own threshold velocity."""
REACHED = 0.8
"""The estimate has followed when it has this share of the true velocity."""
RIGHT_WITHIN_DEG = 45
"""A direction is right if it is off by no more [deg]."""

TrialScore = Callable[[list[ObjectSeries]], float]


def fluctuation(series: list[ObjectSeries]) -> float:
    """Root-mean-square deviation of the estimate from its own mean while the truth is constant
    [m/s]; dynamic objects in motion. NaN without such a stretch."""
    squares = [np.zeros(0)]
    for found in series:
        if found.dynamic:
            for rows in _constant_stretches(found):
                estimate = found.estimate[rows]
                deviation = estimate - np.nanmean(estimate, axis=0)
                squares.append(np.sum(deviation**2, axis=1))
    return _root_mean(np.concatenate(squares))


def response(series: list[ObjectSeries]) -> float:
    """Mean time from when a true velocity became constant until REACHED of it are estimated in its
    direction [s]; dynamic objects in motion. A stretch in which that never happens counts with its
    length. NaN without a stretch."""
    times = []
    for found in series:
        for rows in _constant_runs(found) if found.dynamic else ():
            truth, time = found.truth[rows.start], found.time[rows]
            share = found.estimate[rows] @ truth / (truth @ truth)
            reached = np.flatnonzero(share >= REACHED)
            times.append(time[reached[0] if len(reached) else -1] - time[0])
    return _mean(np.array(times))


def direction_share(series: list[ObjectSeries]) -> float:
    """Share of the frames of dynamic objects in motion with the right direction [%]."""
    right = [np.zeros(0)]
    for found in series:
        speed = np.linalg.norm(found.truth, axis=1)
        estimated = np.linalg.norm(found.estimate, axis=1)
        rows = (speed > MOVING_MPS) & (estimated > 0) & found.dynamic
        cosine = np.sum(found.truth[rows] * found.estimate[rows], axis=1)
        cosine /= speed[rows] * estimated[rows]
        right.append(cosine >= np.cos(np.radians(RIGHT_WITHIN_DEG)))
    return 100 * _mean(np.concatenate(right))


def static_share(series: list[ObjectSeries]) -> float:
    """Share of the frames of static objects whose error stays within the paper's bound in x, y and
    z [%]."""
    bound = published()["outdoor"]["static"]["largest_error_mps"]
    within = [np.zeros(0)]
    for found in series:
        if not found.dynamic:
            error = np.abs(found.estimate - found.truth)
            within.append(np.all(error <= bound, axis=1)[~np.isnan(error).any(axis=1)])
    return 100 * _mean(np.concatenate(within))


def largest_static_error(series: list[ObjectSeries]) -> float:
    """Largest error of a static object in any direction, from SETTLED_S after it entered the map
    [m/s]; NaN without a static object."""
    errors = [
        np.abs(found.estimate - found.truth)[found.time - found.time[0] >= SETTLED_S]
        for found in series
        if not found.dynamic
    ]
    values = np.concatenate([error.ravel() for error in errors] or [np.zeros(0)])
    return float(np.nanmax(values)) if np.isfinite(values).any() else float("nan")


def hidden_frames(series: list[ObjectSeries]) -> float:
    """Mean length of a time in hiding [frames]; NaN without one."""
    return _mean(np.concatenate([np.diff(found.hidden_runs()).ravel() for found in series]))


def score_trials(study: Study, scenario: str, method: str, score: TrialScore) -> pd.Series:
    """Replicate -> score of the trial; those without a value are left out."""
    rows = study.trials[
        (study.trials["scenario"] == scenario) & (study.trials["method"] == method)
    ]
    found = {row.replicate: score(read_series(row.file)) for row in rows.itertuples()}
    return pd.Series(found, dtype=float).dropna()


def better_frames(ours: list[ObjectSeries], theirs: list[ObjectSeries]) -> float:
    """Share of the frames of static objects, of those both have an estimate in, in which the first
    errs less [%]."""
    first, second = ({s.object: s for s in series if not s.dynamic} for series in (ours, theirs))
    less = [np.zeros(0)]
    for number in sorted(first.keys() & second.keys()):
        a, b = _at_common_frames(first[number], second[number])
        less.append((a < b)[~np.isnan(a + b)])
    return 100 * _mean(np.concatenate(less))


def better_share(study: Study, scenario: str, pair: tuple[str, str]) -> pd.Series:
    """Replicate -> share of the frames of static objects in which the first errs less [%]."""
    files = {m: study.trials[(study.trials["scenario"] == scenario)
                             & (study.trials["method"] == m)].set_index("replicate")["file"]
             for m in pair}  # fmt: skip
    shares = {}
    for replicate in sorted(set(files[pair[0]].index) & set(files[pair[1]].index)):
        shares[replicate] = better_frames(*(read_series(files[m][replicate]) for m in pair))
    return pd.Series(shares, dtype=float).dropna()


def _at_common_frames(a: ObjectSeries, b: ObjectSeries) -> tuple[np.ndarray, np.ndarray]:
    _, in_a, in_b = np.intersect1d(a.frame, b.frame, assume_unique=True, return_indices=True)
    return a.error()[in_a], b.error()[in_b]


def _constant_stretches(found: ObjectSeries) -> list[slice]:
    """Rows of constant true velocity in motion, without their first SETTLED_S."""
    stretches = []
    for whole in _constant_runs(found):
        time = found.time[whole]
        settled = whole.start + int(np.searchsorted(time - time[0], SETTLED_S))
        if not np.isnan(found.estimate[settled : whole.stop]).all():
            stretches.append(slice(settled, whole.stop))
    return stretches


def _constant_runs(found: ObjectSeries) -> list[slice]:
    """Rows of constant true velocity in motion, of at least SETTLED_S + LEAST_S."""
    begins = np.ones(len(found.frame), dtype=bool)
    steps = np.linalg.norm(np.diff(found.truth, axis=0), axis=1)
    begins[1:] = (np.diff(found.frame) != 1) | (steps > 1e-6)
    edges = [*np.flatnonzero(begins), len(found.frame)]
    return [
        slice(int(begin), int(end))
        for begin, end in zip(edges, edges[1:])
        if np.linalg.norm(found.truth[begin]) > MOVING_MPS
        and _lasts(found.time[begin:end])
    ]


def _lasts(time: np.ndarray) -> bool:
    settled = np.searchsorted(time - time[0], SETTLED_S)
    return settled < len(time) and time[-1] - time[settled] >= LEAST_S


def _mean(values: np.ndarray) -> float:
    return float(np.mean(values)) if len(values) else float("nan")


def _root_mean(squares: np.ndarray) -> float:
    return float(np.sqrt(_mean(squares[~np.isnan(squares)])))
