"""The numbers of trials that the claims are about, from the records of a condition."""

from __future__ import annotations

from pathlib import Path

import pandas as pd

from analysis.conditions.claims import METHOD, claims, pf_readings
from analysis.data import series_scores
from analysis.data.errors import InputError
from analysis.data.records import read_record, record_files
from analysis.data.series import read_series

COLUMNS = ["scenario", "method", "replicate", "measure", "value"]

OF_SERIES = {
    "fluctuation_mps": series_scores.fluctuation,
    "response_s": series_scores.response,
    "static_share_pct": series_scores.static_share,
    "direction_share_pct": series_scores.direction_share,
}
"""Measures that the records do not hold as scores."""
BETTER = "static_better_pct"
"""With a reading of "[11] with PF" behind a dot: share of the frames in which METHOD errs less."""


def wanted() -> dict[str, set[str]]:
    """Scenario -> measures that a claim is about."""
    found: dict[str, set[str]] = {}
    for claim in claims():
        found.setdefault(claim.scenario, set()).add(claim.measure)
    return found


def measures(records: Path) -> tuple[pd.DataFrame, list[str]]:
    """Of all records of a folder, a row for each number; and a line for each record that is unusable."""
    good, notes = {}, []
    for file in record_files(records):
        try:
            record = read_record(file)
        except InputError as error:
            notes.append(str(error))
            continue
        if record["status"] == "failed":
            notes.append(f"{file}: failed: {record['error']}")
        else:
            good[record["scenario"], record["method"], record["replicate"]] = record
    rows = []
    for key, record in good.items():
        found = _of_record(record, wanted()[record["scenario"]]) | _better(good, key)
        rows += [(*key, measure, value) for measure, value in found.items() if value == value]
    return pd.DataFrame(rows, columns=COLUMNS), notes


def _of_record(record: dict, names: set[str]) -> dict[str, float]:
    found = {name: float(value) for name in names
             if (value := record["scores"].get(name)) is not None}  # fmt: skip
    own = OF_SERIES.keys() & names
    if own and record["method"] in (METHOD, *pf_readings()):
        series = read_series(record["file"])
        found |= {name: OF_SERIES[name](series) for name in own}
    return found


def _better(good: dict, key: tuple) -> dict[str, float]:
    scenario, method, replicate = key
    if method != METHOD or BETTER not in wanted()[scenario]:
        return {}
    return {
        f"{BETTER}.{reading}": series_scores.better_frames(
            read_series(good[key]["file"]),
            read_series(good[scenario, reading, replicate]["file"]),
        )
        for reading in pf_readings()
        if (scenario, reading, replicate) in good
    }
