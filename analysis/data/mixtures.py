"""Which records may share a table: one commit, binary, length; one setting per method and point."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Callable

from analysis.data.errors import InputError

# Differs between the replicates of a method by design.
PER_TRIAL_PARAMETERS = ("execution.seed",)


def refuse_mixtures(records: list[dict], where: Path) -> None:
    """Raise InputError with one line that says what differs, and in which files.

    Parameters
    ----------
    records : list of dict
        As `records.read_record` returns them.
    where : Path
        Folder of the study, for the message.
    """
    for key in ("commit", "dirty", "binary"):
        _refuse_different(records, where, key, lambda r: r["provenance"].get(key), lambda r: ())
    _refuse_different(records, where, "plugin", _plugin, lambda r: (r["method"],))
    _refuse_different(records, where, "frames", lambda r: r["frames"], lambda r: ())
    _refuse_different_parameters(records, where)
    _refuse_doubles(records, where)
    # Comparisons are paired: all methods, at all points, must have met the same draw.
    _refuse_different(
        records, where, "scenario_file_hash", lambda r: r["scenario_file_hash"], _place
    )
    _refuse_different(
        records, where, "seeds.scenario", lambda r: r["seeds"].get("scenario"), _draw
    )


def _plugin(record: dict) -> str | None:
    return record["provenance"].get("plugin", {}).get("hash")


def _place(record: dict) -> tuple[str, str]:
    """Scenario and point: the worlds of one place are draws from one description."""
    point = record["point"]
    return record["scenario"], json.dumps(point, sort_keys=True) if point else ""


def _draw(record: dict) -> tuple[str, str]:
    return record["scenario"], f"replicate {record['replicate']}"


def _refuse_different(
    records: list[dict],
    where: Path,
    what: str,
    value: Callable[[dict], object],
    within: Callable[[dict], tuple],
) -> None:
    """Raise if two records of one group, as `within` tells it, have different values."""
    first: dict[tuple, dict] = {}
    for record in records:
        other = first.setdefault(within(record), record)
        if value(other) != value(record):
            group = " ".join(filter(None, within(record)))
            raise _mixture(where, f"{what}{' for ' + group if group else ''}", other, record,
                           value(other), value(record))


def _refuse_different_parameters(records: list[dict], where: Path) -> None:
    first: dict[tuple, dict] = {}
    for record in records:
        group = (record["method"], _place(record)[1])
        other = first.setdefault(group, record)
        if other["parameters"] == record["parameters"]:
            continue
        for name in sorted(other["parameters"].keys() | record["parameters"].keys()):
            a, b = other["parameters"].get(name), record["parameters"].get(name)
            if a != b and name not in PER_TRIAL_PARAMETERS:
                what = " ".join(filter(None, [f"{name} for", *group]))
                raise _mixture(where, what, other, record, a, b)


def _refuse_doubles(records: list[dict], where: Path) -> None:
    first: dict[tuple, dict] = {}
    for record in records:
        other = first.setdefault((record["method"], record["replicate"], _place(record)), record)
        if other is not record:
            raise InputError(
                f"{where}: two records of one trial: {other['file'].name} and {record['file'].name}"
            )


def _mixture(where: Path, what: str, a: dict, b: dict, value_a, value_b) -> InputError:
    return InputError(
        f"{where}: records of different {what}: {value_a} in {a['file'].name}, "
        f"{value_b} in {b['file'].name}; run the study afresh"
    )
