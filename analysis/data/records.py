"""A study's records (experiments/RECORD.md) as a table; what must not mix is refused."""

from __future__ import annotations

import json
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterable

import pandas as pd

from analysis.data.errors import InputError
from analysis.data.mixtures import refuse_mixtures
from analysis.data.published import PAPER_NAMES

SCHEMA = 2
LISTED_NOTES = 20

_KEYS_OF_FAILED = {"error": str}
_KEYS_OF_GOOD = {
    "id": str,
    "scenario": str,
    "method": str,
    "replicate": int,
    "point": dict,
    "seeds": dict,
    "frames": int,
    "parameters": dict,
    "scenario_file_hash": str,
    "provenance": dict,
    "scores": dict,
}

SERIES_SUFFIX = ".series.json"
"""Of the file beside a record that holds the velocity series."""


class SchemaError(InputError):
    """A record of another version of the format."""


@dataclass(frozen=True)
class Study:
    """The good trials of one study, all of one commit, binary and length."""

    name: str
    folder: Path
    trials: pd.DataFrame
    """One row a trial: scenario, method, point (label), replicate, file, and a column per score
    (float, NaN where not defined)."""
    records: list[dict] = field(repr=False)
    """The same trials, in the same order, as read."""
    points: dict[str, dict]
    """Label of a point -> its swept parameters; {"": {}} without a sweep."""
    notes: list[str]
    """What is missing, failed or unreadable, a line each; the first 20 and how many more."""

    @property
    def frames(self) -> int:
        """Frames of each trial."""
        return self.records[0]["frames"]

    @property
    def commit(self) -> str:
        """Commit of the program that wrote the records, with "-dirty" where it had changes."""
        provenance = self.records[0]["provenance"]
        return str(provenance["commit"])[:12] + ("-dirty" if provenance.get("dirty") else "")

    @property
    def seeds(self) -> int:
        """Number of different replicates."""
        return self.trials["replicate"].nunique()

    @property
    def scenarios(self) -> list[str]:
        """Names, sorted."""
        return sorted(self.trials["scenario"].unique())

    @property
    def methods(self) -> list[str]:
        """Names, those of the paper first, then sorted."""
        first = [*PAPER_NAMES, "circular_buffer_pf"]
        found = set(self.trials["method"])
        return [m for m in first if m in found] + sorted(found - set(first))

    def source(self) -> str:
        """Where a number comes from, for captions: study, seeds, frames, commit."""
        plural = "" if self.seeds == 1 else "s"
        return (
            f"study {self.name}, {self.seeds} seed{plural} of {self.frames} frames, "
            f"commit {self.commit}"
        )

    def per_seed(self, scenario: str, method: str, score: str, point: str = "") -> pd.Series:
        """Replicate -> value of a score; replicates without one are left out."""
        rows = self.trials[
            (self.trials["scenario"] == scenario)
            & (self.trials["method"] == method)
            & (self.trials["point"] == point)
        ]
        if score not in rows:
            return pd.Series(dtype=float)
        return rows.set_index("replicate")[score].dropna()

    def require_no_sweep(self) -> None:
        """Raise InputError if the study sweeps a parameter."""
        if len(self.points) > 1:
            raise InputError(
                f"{self.folder}: has {len(self.points)} points of a sweep; "
                "this table or figure needs a study without one"
            )


def point_label(point: dict) -> str:
    """The swept parameters as text, `a=1, b=none`; empty without a sweep."""
    return ", ".join(f"{name}={_text(value)}" for name, value in sorted(point.items()))


def numbers_in_order(text: str) -> list[str | int]:
    """A key that sorts p2 before p10, and p99 before p100."""
    return [int(part) if part.isdecimal() else part for part in re.split(r"(\d+)", text)]


def load_study(results: Path, name: str, methods: Iterable[str] = ()) -> Study:
    """Read results/NAME/records/*.json.

    Failed, unreadable and missing trials are left out and named in `notes`. 10,000 records take
    about two seconds. Those of `methods` that are not among the study's own are read from
    results/NAME+METHOD.

    Raises
    ------
    InputError
        If there is no usable record, or records that must not share a table do.
    """
    folder = results / name
    good, notes = _read_folder(folder)
    own = {record["method"] for record in good}
    for method in methods:
        beside = results / f"{name}+{method}"
        if method not in own and beside.is_dir():
            more, more_notes = _read_folder(beside)
            good, notes = good + more, notes + more_notes
    # Ids number points in order.
    good.sort(key=lambda r: (r["scenario"], r["method"], numbers_in_order(r["id"])))
    refuse_mixtures(good, folder)
    rows = []
    for record in good:
        row = {key: record[key] for key in ("scenario", "method", "replicate", "file")}
        rows.append(row | {"point": point_label(record["point"])} | record["scores"])
    trials = pd.DataFrame(rows)
    scores = trials.columns.difference(["scenario", "method", "replicate", "file", "point"])
    trials[scores] = trials[scores].astype(float)
    points = {point_label(record["point"]): record["point"] for record in good}
    notes += _missing_trials(trials)
    if len(notes) > LISTED_NOTES:
        notes[LISTED_NOTES:] = [f"... and {len(notes) - LISTED_NOTES} more"]
    return Study(name, folder, trials, good, points, notes)


def read_record(file: Path) -> dict:
    """One record as a dict, with its path under "file".

    Raises
    ------
    InputError
        Naming the file and what is wrong with it; SchemaError if that is its version.
    """
    record = read_json(file)
    _check_keys(record, file)
    record["file"] = file
    return record


def record_files(folder: Path) -> list[Path]:
    """The records in a folder, without the series beside them and what is being written."""
    return sorted(file for file in folder.glob("[!.]*.json") if not file.name.endswith(SERIES_SUFFIX))


def read_json(file: Path) -> object:
    """The content of a file of JSON.

    Raises
    ------
    InputError
        Naming the file and what is wrong with it.
    """
    try:
        return json.loads(file.read_bytes(), parse_constant=_refuse)
    except OSError as error:
        raise InputError(f"{file}: unreadable: {error.strerror}") from error
    except (ValueError, RecursionError) as error:
        raise InputError(f"{file}: unreadable: cut short or no JSON: {error}") from error


def _read_folder(folder: Path) -> tuple[list[dict], list[str]]:
    files = record_files(folder / "records")
    if not files:
        raise InputError(f"{folder / 'records'}: holds no record (*.json); run the study first")
    good, notes = [], []
    for file in files:
        try:
            record = read_record(file)
        except SchemaError:
            raise
        except InputError as error:
            notes.append(f"left out: {error}")
            continue
        if record["status"] == "failed":
            notes.append(f"left out: {file}: failed: {record['error']}")
        else:
            good.append(record)
    if not good:
        reason = f"none of {len(files)} records is usable; {notes[0]}"
        raise InputError(f"{folder / 'records'}: {reason}")
    return good, notes


def _check_keys(record: object, file: Path) -> None:
    if not isinstance(record, dict):
        raise InputError(f"{file}: not an object of JSON")
    if (found := record.get("schema")) != SCHEMA:
        raise SchemaError(f"{file}: schema: {found!r}, this analysis reads {SCHEMA}")
    status = record.get("status")
    if status not in ("ok", "failed"):
        raise InputError(f'{file}: status: {status!r}, neither "ok" nor "failed"')
    for key, kind in (_KEYS_OF_GOOD if status == "ok" else _KEYS_OF_FAILED).items():
        if not isinstance(record.get(key), kind):
            raise InputError(f"{file}: {key}: missing or not of type {kind.__name__}")
    for name, value in record.get("scores", {}).items():
        if value is not None and not isinstance(value, (int, float)):
            raise InputError(f"{file}: scores.{name}: {value!r} is neither a number nor null")


def _missing_trials(trials: pd.DataFrame) -> list[str]:
    """Replicates that some method has and another lacks, one line for each set of them."""
    replicates = set(trials["replicate"])
    seen = trials.groupby(["point", "scenario", "method"])["replicate"].agg(set)
    notes = []
    for point, of_point in trials.groupby("point"):
        for scenario in sorted(trials["scenario"].unique()):
            for method in sorted(of_point["method"].unique()):
                lacking = replicates - seen.get((point, scenario, method), set())
                if lacking:
                    where = " ".join(filter(None, [scenario, method, point]))
                    numbers = ", ".join(map(str, sorted(lacking)))
                    notes.append(f"missing: {where}: replicate {numbers}")
    return notes


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is not a number of JSON")


def _text(value: object) -> str:
    return value if isinstance(value, str) else json.dumps(value)
