"""The records of a study as its runner sees them: which are good, failed, cut short, of other files."""

import dataclasses
import json
import os
from pathlib import Path

SCHEMA = 2


class OtherFiles(Exception):
    """A trial was made from other files than the study."""


@dataclasses.dataclass(frozen=True)
class Record:
    """One record; `error` says why its trial failed, or what is wrong with the record."""

    file: Path
    error: str | None
    is_whole: bool
    files: dict[str, str]

    def other_files(self, files: dict[str, str]) -> list[str]:
        """Those that it was made from in another version than in `files`."""
        return [path for path, found in self.files.items() if files.get(path) != found]


def read(folder: Path, trial: str) -> Record:
    """The record of a trial. @raises OSError if it is there and cannot be read: a folder, say."""
    file = folder / f"{trial}.json"
    try:
        content = json.loads(file.read_bytes())
    except FileNotFoundError:
        return Record(file, "no record", False, {})
    except (ValueError, RecursionError):
        return Record(file, "the record is cut short or no JSON", False, {})
    if not isinstance(content, dict) or content.get("status") not in ("ok", "failed"):
        return Record(file, "the record has no status", False, {})
    if content["status"] == "failed":
        return Record(file, str(content.get("error", "no reason given")), True, {})
    series = content.get("series_bytes", 0)
    if series and size(folder / f"{trial}.series.json") != series:
        return Record(file, "the series beside the record are missing or cut short", False, {})
    return Record(file, None, True, content.get("files", {}))


def read_all(folder: Path, trials: list[str]) -> dict[str, Record]:
    """Those of `trials` that have one. 10,000 take half a second."""
    present = set(os.listdir(folder))
    return {trial: read(folder, trial) for trial in trials if f"{trial}.json" in present}


def remove(folder: Path, trial: str) -> None:
    """The record, and the series beside it."""
    for name in (f"{trial}.json", f"{trial}.series.json"):
        (folder / name).unlink(missing_ok=True)


def remove_unfinished(folder: Path) -> None:
    """What a killed trial left half-written."""
    for name in os.listdir(folder):
        if name.startswith(".") or not name.endswith(".json"):
            (folder / name).unlink()


def size(file: Path) -> int:
    """Bytes; 0 without the file."""
    try:
        return file.stat().st_size
    except FileNotFoundError:
        return 0
