"""Every number that the text of the report names, as `\\val{KEY}`."""

from __future__ import annotations

import tomllib
from collections import Counter
from pathlib import Path

import pandas as pd

from analysis.data import series_scores, statistics
from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.statistics import interval_of_one_more
from analysis.figures.computation_time import METHOD, TOTAL, serial_records, time_table
from analysis.report import latex
from analysis.report.bench_numbers import bench_numbers
from analysis.report.claim_rows import MOST_PCT, Row
from analysis.report.claims import counts
from analysis.report.closed_loop import closed_loop_numbers
from analysis.report.evidence import STUDIES, WORLDS, Evidence
from analysis.report.objects import objects_numbers
from analysis.report.open_points import open_points, show
from analysis.tables import accuracy_table
from analysis.tables.orderings import OPPOSITE, REPRODUCED

SCENARIOS = ("scenario1", "scenario2", "scenario3")


def numbers(evidence: Evidence, rows: list[Row], defaults: dict[str, object]) -> dict[str, str]:
    """Key -> LaTeX text; keys of a missing study say so, so that the set of keys never changes."""
    found = _constants(rows)
    found |= {f"parameter.{name}": latex.latex_text(show(v)) for name, v in defaults.items()}
    for name in STUDIES:
        found |= _study_numbers(name, evidence.study(name))
    found |= _table1_numbers(evidence.study("table1"))
    found |= _time_numbers(evidence)
    found |= bench_numbers(evidence)
    found |= _world_numbers(evidence)
    found |= closed_loop_numbers(evidence)
    found |= objects_numbers(evidence)
    return found


def definitions(found: dict[str, str]) -> str:
    """The numbers as LaTeX definitions, for `\\val`."""
    lines = [rf"\expandafter\def\csname val:{key}\endcsname{{{text}}}"
             for key, text in sorted(found.items())]  # fmt: skip
    return "\n".join(lines) + "\n"


def _constants(rows: list[Row]) -> dict[str, str]:
    setup = published()["setup"]
    found = {
        "confidence": rf"{100 * statistics.CONFIDENCE:.0f}\,\%",
        "resamples": latex.value(statistics.RESAMPLES, 0),
        "significance": f"{statistics.SIGNIFICANCE}",
        "most": rf"{MOST_PCT}\,\%",
        "settled": f"{series_scores.SETTLED_S}",
        "least-stretch": f"{series_scores.LEAST_S}",
        "moving": f"{series_scores.MOVING_MPS}",
        "right-within": f"{series_scores.RIGHT_WITHIN_DEG}",
        "paper.frames": latex.value(setup["frames"]["value"], 0),
        "paper.voxels": latex.value(setup["voxels_per_map"], 0),
        "paper.particles": latex.value(setup["particles"], 0),
        "paper.resolution": str(setup["resolution_m"]),
        "paper.time": str(published()["computation_time"]["total_ms"][METHOD]),
        "open-points": str(len(open_points())),
        "ledger.claims": str(len(rows)),
    }
    for verdict, count in counts(rows).items():
        numbers_ = [str(i) for i, row in enumerate(rows, start=1) if row.verdict == verdict]
        found[f"ledger.{verdict}"] = str(count)
        found[f"ledger.{verdict}.which"] = ", ".join(numbers_) or "none"
    return found


def _study_numbers(name: str, study: Study | None) -> dict[str, str]:
    if study is None:
        return {f"{name}.{key}": latex.missing(name)
                for key in ("trials", "seeds", "frames", "commit", "source")}  # fmt: skip
    return {
        f"{name}.trials": latex.value(len(study.trials), 0),
        f"{name}.seeds": str(study.seeds),
        f"{name}.frames": latex.value(study.frames, 0),
        f"{name}.commit": rf"\code{{{study.commit}}}",
        f"{name}.source": latex.plain(study.source()),
    }


def _table1_numbers(study: Study | None) -> dict[str, str]:
    keys = ("cells", "cells.within", "orders", "orders.same", "orders.opposite", "orders.undecided")
    if study is None:
        return {f"table1.{key}": latex.missing("table1") for key in keys}
    factor = study.frames / published()["setup"]["frames"]["value"]
    within = []
    for scenario, values in published()["table1"].items():
        for score in accuracy_table.PUBLISHED:
            for method, value in values[score.name].items():
                ours = study.per_seed(scenario, method, score.name)
                low, high = interval_of_one_more(ours.to_numpy())
                within.append(low <= value * (factor if score.summed else 1) <= high)
    verdicts = Counter(o.verdict for o in accuracy_table.judge_orderings(study))
    same, opposite = verdicts[REPRODUCED], verdicts[OPPOSITE]
    total = verdicts.total()
    counted = (len(within), sum(within), total, same, opposite, total - same - opposite)
    return {f"table1.{key}": str(count) for key, count in zip(keys, counted, strict=True)}


def _time_numbers(evidence: Evidence) -> dict[str, str]:
    study = evidence.study("timing")
    if study is None:
        return {"time.total": latex.missing("timing"), "time.cpu": latex.missing("timing")}
    records = serial_records(study)
    table = time_table(records, study.methods).set_index(["method", "stage"])
    return {
        "time.total": latex.value(table.loc[(METHOD, TOTAL), "mean_ms"], 1),
        "time.cpu": latex.latex_text(str(records[0]["provenance"]["cpu"])),
    }


def _world_numbers(evidence: Evidence) -> dict[str, str]:
    """Objects of the worlds that Figure 5 shows, and the sensor of the first."""
    folder = evidence.folder(WORLDS) or evidence.results
    found = {}
    for scenario in SCENARIOS:
        file = folder / f"{scenario}.truth.csv"
        for kind, dynamic in (("dynamic", 1), ("static", 0)):
            found[f"world.{scenario}.{kind}"] = (
                _objects(file, dynamic) if file.exists() else latex.missing(WORLDS)
            )
    return found | _sensor_numbers(folder / f"{SCENARIOS[0]}.log.toml")


def _objects(file: Path, dynamic: int) -> str:
    objects = pd.read_csv(file, usecols=["id", "dynamic"]).drop_duplicates("id")
    return str(int((objects["dynamic"] == dynamic).sum()))


def _sensor_numbers(file: Path) -> dict[str, str]:
    keys = ("channels", "azimuths", "rate_hz", "min_range_m", "max_range_m", "range_sigma_m")
    if not file.exists():
        return {f"sensor.{key}": latex.missing(WORLDS) for key in keys}
    lidar = tomllib.loads(file.read_text(encoding="utf-8"))["lidar"]
    values = lidar | {"channels": len(lidar["elevations_rad"])}
    return {f"sensor.{key}": show(values[key]) for key in keys}
