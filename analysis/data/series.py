"""The velocity series of the objects of one trial, as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from analysis.data.errors import InputError
from analysis.data.records import SERIES_SUFFIX, read_json, read_record


@dataclass(frozen=True)
class ObjectSeries:
    """What one object did and what was estimated, while it was in the map; T frames."""

    object: int
    dynamic: bool
    frame: np.ndarray  # (T,) integers
    time: np.ndarray  # (T,) [s]
    truth: np.ndarray  # (T, 3) [m/s], world frame
    estimate: np.ndarray  # (T, 3) [m/s], world frame; NaN where no cluster was matched
    hidden: np.ndarray  # (T,) True where no ray met it; all False in records that do not say

    def error(self) -> np.ndarray:
        """Norm of (estimate - truth), (T,) [m/s]; NaN where there is no estimate."""
        return np.linalg.norm(self.estimate - self.truth, axis=1)

    def hidden_runs(self) -> np.ndarray:
        """First row and the row after the last of each time in hiding, (K, 2)."""
        edges = np.diff(self.hidden.astype(int), prepend=0, append=0)
        return np.flatnonzero(edges).reshape(-1, 2)

    def part(self, rows: slice) -> ObjectSeries:
        """The series of these rows alone."""
        arrays = (self.frame, self.time, self.truth, self.estimate, self.hidden)
        return ObjectSeries(self.object, self.dynamic, *(array[rows] for array in arrays))


def read_series(file: Path) -> list[ObjectSeries]:
    """All objects of the trial whose record `file` is, sorted by number.

    Raises
    ------
    InputError
        If the trial keeps no series, or ones cut short or of an unexpected shape.
    """
    bytes_written = read_record(file).get("series_bytes")
    if not bytes_written:
        raise InputError(f"{file}: the trial keeps no velocity series")
    beside = file.with_name(file.stem + SERIES_SUFFIX)
    content = read_json(beside)
    if beside.stat().st_size != bytes_written or not isinstance(content, dict):
        raise InputError(f"{beside}: not the series that {file.name} was written with")
    entries = content.get("series", [])
    return sorted((_object(entry, beside) for entry in entries), key=lambda s: s.object)


def longest_run(frame: np.ndarray) -> slice:
    """Rows of the longest run of consecutive frames; the first of equally long ones.

    Parameters
    ----------
    frame : (T,) integers, ascending, T >= 1
    """
    begins = np.flatnonzero(np.diff(frame, prepend=frame[0] - 2) != 1)
    lengths = np.diff(begins, append=len(frame))
    k = int(np.argmax(lengths))
    return slice(int(begins[k]), int(begins[k] + lengths[k]))


def longest_in_map(series: list[ObjectSeries], dynamic: bool) -> ObjectSeries | None:
    """The object of this kind with the longest contiguous time in the map, cut to that time.

    Of equally long ones the lowest number. None if there is no object of this kind.
    """
    cut = [s.part(longest_run(s.frame)) for s in series if s.dynamic == dynamic and len(s.frame)]
    return max(cut, key=lambda s: (len(s.frame), -s.object), default=None)


def _object(entry: dict, file: Path) -> ObjectSeries:
    try:
        frame = np.asarray(entry["frame"], dtype=int)
        return ObjectSeries(
            object=int(entry["object"]),
            dynamic=bool(entry["dynamic"]),
            frame=frame,
            time=np.asarray(entry["time_s"], dtype=float).reshape(len(frame)),
            truth=_vectors(entry["true_velocity_mps"], len(frame)),
            estimate=_vectors(entry["velocity_mps"], len(frame)),
            hidden=~_booleans(entry.get("visible"), len(frame)),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise InputError(f"{file}: series: not as experiments/RECORD.md says: {error!r}") from error


def _vectors(values: list, count: int) -> np.ndarray:
    nothing = [np.nan] * 3
    rows = [nothing if value is None else value for value in values]
    return np.asarray(rows, dtype=float).reshape(count, 3)


def _booleans(values: list | None, count: int) -> np.ndarray:
    return np.asarray([True] * count if values is None else values, dtype=bool).reshape(count)
