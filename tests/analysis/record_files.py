"""Records in the shape of experiments/RECORD.md, made by hand for the tests."""

from __future__ import annotations

import json
import zlib
from pathlib import Path

import numpy as np

TYPICAL_SCORES = {
    "accuracy_pct": 99.5,
    "case1_voxels": 40000,
    "case2_voxels": 150000,
    "accuracy_visible_pct": 99.4,
    "case1_visible_voxels": 9000,
    "case2_grown_voxels": 60000,
    "mixed_voxels_per_frame": 57.5,
    "precision": 0.7,
    "recall": 0.9,
    "f1": 0.79,
    "iou_visible": 0.61,
    "brier": 0.01,
    "ghost_voxels_per_frame": 12.5,
    "seconds_to_clear": 0.8,
    "static_velocity_error_mps": 0.02,
    "dynamic_velocity_error_mps": 0.3,
    "static_velocity_error_steady_mps": 0.02,
    "dynamic_velocity_error_steady_mps": 0.2,
    "time_to_converge_s": 1.1,
    "objects_missed_pct": 2.0,
    "clusters_without_object_per_frame": 0.5,
}


def make_record(method: str = "ldm", replicate: int = 1, **changes) -> dict:
    """A good record; `changes` replace top-level keys, `scores` are merged into typical ones."""
    scenario = changes.get("scenario", "scenario1")
    study = changes.get("study", "table1")
    point = changes.get("point", {})
    tail = "".join(f"-{name}={value}" for name, value in point.items())
    record = {
        "schema": 2,
        "status": "ok",
        "command": f"ldm trial {study} ...",
        "study": study,
        "id": f"{scenario}-{method}-{replicate}{tail}",
        "scenario": scenario,
        "method": method,
        "replicate": replicate,
        "point": point,
        "seeds": {"scenario": str(1000 + replicate), "filter": str(zlib.crc32(method.encode()))},
        "frames": 1200,
        "parameters": {"map.resolution_m": 0.15, "execution.seed": replicate} | point,
        "scenario_file_hash": f"hash-of-{scenario}",
        "provenance": {
            "version": "0.1.0",
            "commit": "0123456789abcdef",
            "dirty": False,
            "binary": "b1",
            "compiler": "g++ 12",
            "flags": "-O2",
            "build_type": "Release",
            "cpu": "Test CPU",
            "cores": 2,
        },
        "files": {f"experiments/studies/{study}.toml": "f1"},
        "series_bytes": 0,
        "timing": {"serial": False, "frames": 1100, "update_time_ms": {}, "stages_ms": {}},
    }
    return record | changes | {"scores": TYPICAL_SCORES | changes.get("scores", {})}


def make_series(number: int, dynamic: bool, frames: list[int], noise: float = 0.05) -> dict:
    """The series of one object that moves to and fro in x and y; every tenth frame unmatched."""
    frame = np.array(frames)
    time = frame / 10
    truth = np.zeros((len(frame), 3))
    if dynamic:
        truth[:, 0] = np.where(time % 20 < 10, 0.8, -0.8)
        truth[:, 1] = np.where(time % 30 < 15, -0.4, 0.4)
    random = np.random.default_rng(number)
    estimate = truth + random.normal(0, noise, truth.shape)
    return {
        "object": number,
        "dynamic": dynamic,
        "frame": frame.tolist(),
        "time_s": time.tolist(),
        "true_velocity_mps": truth.tolist(),
        "velocity_mps": [None if f % 10 == 7 else v.tolist() for f, v in zip(frame, estimate)],
    }


def write_record(folder: Path, record: dict) -> Path:
    """Write FOLDER/ID.json, and its "series" beside it; returns the file of the record."""
    file = folder / f"{record['id']}.json"
    folder.mkdir(parents=True, exist_ok=True)
    if "series" in record:
        series = json.dumps({"schema": 2, "series": record["series"]})
        file.with_name(f"{record['id']}.series.json").write_text(series, encoding="utf-8")
        record = {k: v for k, v in record.items() if k != "series"} | {"series_bytes": len(series)}
    file.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")
    return file


def write_records(results: Path, records: list[dict]) -> Path:
    """Write each to results/STUDY/records/; returns `results`."""
    for record in records:
        write_record(results / record["study"] / "records", record)
    return results
