"""Computation times: serial records alone, stages in their order, the paper's value beside."""

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.records import load_study
from analysis.figures.computation_time import main, serial_records, time_figure, time_table


def timing(total, serial=True):
    half = {"median": total / 2, "mean": total / 2 + 0.1}
    return {
        "serial": serial,
        "frames": 1190,
        "update_time_ms": {"median": total, "mean": total + 0.2, "p95": total, "max": total},
        "stages_ms": {"resampling": half, "clustering": half},
    }


def record(method, replicate, total, **changes):
    return make_record(method, replicate, study="timing", timing=timing(total)) | changes


@pytest.fixture
def results(tmp_path):
    records = [record("ldm", 1, 10.0), record("ldm", 2, 12.0), record("octomap", 1, 4.0)]
    records.append(record("octomap", 2, 1000.0, timing=timing(1000.0, serial=False)))
    return write_records(tmp_path, records)


def test_rows_by_hand(results):
    study = load_study(results, "timing")
    table = time_table(serial_records(study), study.methods)
    rows = table[["method", "stage", "median_ms", "mean_ms", "trials"]].values.tolist()
    assert rows == [
        ["ldm", "resampling", 5.5, pytest.approx(5.6), 2],
        ["ldm", "clustering", 5.5, pytest.approx(5.6), 2],
        ["ldm", "total", 11.0, pytest.approx(11.2), 2],
        ["octomap", "resampling", 2.0, pytest.approx(2.1), 1],
        ["octomap", "clustering", 2.0, pytest.approx(2.1), 1],
        ["octomap", "total", 4.0, pytest.approx(4.2), 1],
    ]


def test_figure_shows_stages_totals_and_the_paper(results):
    study = load_study(results, "timing")
    stages, totals = time_figure(time_table(serial_records(study), study.methods)).axes
    assert [t.get_text() for t in stages.get_yticklabels()] == ["resampling", "clustering"]
    assert [bar.get_width() for bar in stages.patches] == pytest.approx([5.6, 5.6])
    assert [t.get_text() for t in totals.get_yticklabels()] == ["ldm", "octomap"]
    assert totals.lines[-1].get_xdata() == [98, 98]
    assert totals.get_xlabel() == "mean time of an update (ms)"


def test_the_script_writes_and_prints(results, capsys):
    assert run(main, ["--results", str(results)]) == 0
    text = (results / "timing" / "tables" / "computation_time.txt").read_text()
    total = next(line for line in text.splitlines() if "total" in line and "ldm" in line)
    assert total.split()[2:4] == ["11.000", "11.200"] and total.split()[-1] == "98"
    assert text in capsys.readouterr().out
    assert (results / "timing" / "figures" / "computation_time.pdf").exists()


def test_parallel_runs_are_no_timings(tmp_path):
    write_records(tmp_path, [make_record(study="timing")])
    with pytest.raises(InputError, match="no record has timing.serial true"):
        serial_records(load_study(tmp_path, "timing"))


def test_processors_do_not_mix(tmp_path):
    other = record("ldm", 2, 5.0)
    other["provenance"] = other["provenance"] | {"cpu": "Fast CPU"}
    write_records(tmp_path, [record("ldm", 1, 10.0), other])
    with pytest.raises(InputError, match="different processors: Fast CPU and Test CPU"):
        serial_records(load_study(tmp_path, "timing"))
