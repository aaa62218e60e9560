"""Loading records: what counts, what is left out, and what stops."""

import json
import math
import time

import pytest
from record_files import make_record, make_series, write_records

from analysis.data.errors import InputError
from analysis.data.records import load_study, read_record
from analysis.data.series import read_series


def load(tmp_path, *records):
    return load_study(write_records(tmp_path, list(records)), "table1")


def test_scores_become_columns_and_null_becomes_nan(tmp_path):
    study = load(
        tmp_path,
        make_record("ldm", 1, scores={"accuracy_pct": 99.1}),
        make_record("octomap", 1, scores={"dynamic_velocity_error_mps": None}),
    )
    assert study.methods == ["ldm", "octomap"]
    assert study.trials["accuracy_pct"].tolist() == [99.1, 99.5]
    assert math.isnan(study.trials["dynamic_velocity_error_mps"][1])
    assert study.notes == []
    assert study.source() == "study table1, 1 seed of 1200 frames, commit 0123456789ab"


def test_points_keep_their_values_and_order(tmp_path):
    points = [{"particles.count": 2000, "mode": "b"}, {"particles.count": 1000, "mode": "a"}]
    study = load(tmp_path, *(make_record(point=p, id=f"p{i}") for i, p in enumerate(points)))
    assert list(study.points.values()) == points
    assert list(study.points) == ["mode=b, particles.count=2000", "mode=a, particles.count=1000"]


def test_no_folder_and_no_record(tmp_path):
    with pytest.raises(InputError, match="table1/records: holds no record"):
        load_study(tmp_path, "table1")


def test_failed_truncated_and_missing_trials_are_named(tmp_path):
    good = [make_record(m, r) for m in ("ldm", "octomap") for r in (1, 2, 3)]
    write_records(tmp_path, good)
    folder = tmp_path / "table1" / "records"
    crashed = {"schema": 2, "status": "failed", "error": "killed by SIGSEGV", "id": "x"}
    (folder / "scenario1-ldm-2.json").write_text(json.dumps(crashed))
    truncated = folder / "scenario1-ldm-3.json"
    truncated.write_bytes(truncated.read_bytes().rstrip()[:-1])  # lacks its last brace
    (folder / ".scenario1-ldm-4.77.part.json").write_text("{")  # a trial that runs
    study = load_study(tmp_path, "table1")
    assert len(study.trials) == 4
    assert "scenario1-ldm-2.json: failed: killed by SIGSEGV" in study.notes[0]
    assert "scenario1-ldm-3.json: unreadable: " in study.notes[1]
    assert study.notes[2] == "missing: scenario1 ldm: replicate 2, 3"


def test_nothing_usable_stops_with_the_first_reason(tmp_path):
    write_records(tmp_path, [make_record(status="failed", error="out of memory")])
    with pytest.raises(InputError, match="none of 1 records is usable.*out of memory"):
        load_study(tmp_path, "table1")


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"schema": 1}, "schema: 1, this analysis reads 2"),
        ({"status": "fine"}, "status: 'fine'"),
        ({"replicate": "1"}, "replicate: missing or not of type int"),
        ({"scores": {"f1": "high"}}, "scores.f1: 'high' is neither a number nor null"),
        ({"scores": {"f1": math.inf}}, "Infinity is not a number of JSON"),
    ],
)
def test_a_record_of_another_shape_is_refused(tmp_path, changes, message):
    write_records(tmp_path, [make_record(id="x") | changes])
    with pytest.raises(InputError, match=message):
        read_record(tmp_path / "table1" / "records" / "x.json")


def test_records_of_another_schema_stop_and_are_not_left_out(tmp_path):
    write_records(tmp_path, [make_record("ldm", 1), make_record("ldm", 2) | {"schema": 1}])
    with pytest.raises(InputError, match="scenario1-ldm-2.json: schema: 1, this analysis reads 2"):
        load_study(tmp_path, "table1")


def test_many_notes_are_counted(tmp_path):
    failed = [make_record("ldm", r, status="failed", error="x") for r in range(2, 40)]
    study = load(tmp_path, make_record("ldm", 1), *failed)
    assert len(study.notes) == 21 and study.notes[-1] == "... and 18 more"


def test_series_are_read_from_the_file_beside_the_record(tmp_path):
    series = [make_series(2, False, [5]), make_series(1, True, [0, 1, 2])]
    study = load(tmp_path, make_record(series=series, id="x"))
    file = tmp_path / "table1" / "records" / "x.json"
    assert study.trials["file"].tolist() == [file]
    assert [found.object for found in read_series(file)] == [1, 2]

    beside = file.with_name("x.series.json")
    beside.write_text(beside.read_text() + " ")
    with pytest.raises(InputError, match="x.series.json: not the series that x.json was written"):
        read_series(file)
    beside.write_bytes(beside.read_bytes()[:-5])
    with pytest.raises(InputError, match="x.series.json: unreadable: cut short"):
        read_series(file)


def test_two_thousand_records_load_in_seconds(tmp_path):
    write_records(tmp_path, [make_record("ldm", r) for r in range(2000)])
    begin = time.process_time()
    assert len(load_study(tmp_path, "table1").trials) == 2000
    assert time.process_time() - begin < 5
