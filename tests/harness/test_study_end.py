"""What `make study` makes of the records when all trials are there, and what `make studies` promises."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from bench import ROOT, Bench

sys.path.append(str(ROOT / "tests" / "analysis"))

from record_files import make_record, make_series, write_records  # noqa: E402


def finish_study(folder: Path, name: str, records: list[dict]) -> subprocess.CompletedProcess:
    """`make study` where every trial has its record; the stand-in calls them t1, t2, ..."""
    bench = Bench(folder)
    for number, record in enumerate(records, start=1):
        record |= {"study": name, "id": f"t{number}"}
    write_records(bench.results, records)
    return subprocess.run(
        ["make", "-C", ROOT, "study", f"STUDY={name}", f"LDM={bench.program}",
         f"RESULTS={bench.results}"],
        env=bench.environment(COUNT=str(len(records))), capture_output=True, text=True, check=False)


def test_a_sweep_ends_in_one_figure_and_one_table(tmp_path):
    records = [make_record(method, seed, point={"particles.count": count})
               for method in ("ldm", "circular_buffer_pf_eq17") for seed in (1, 2) for count in (1000, 2000)]
    done = finish_study(tmp_path, "sweep", records)
    assert done.returncode == 0, done.stderr
    made = tmp_path / "results" / "sweep"
    assert f"{made}/figures/sweep.png" in done.stdout
    assert (made / "figures" / "sweep.png").exists() and (made / "tables" / "sweep.csv").exists()
    assert (made / "tables" / "sweep.txt").read_text() in done.stdout


@pytest.mark.parametrize("name", ["velocity", "table1"])
def test_the_velocity_studies_end_in_figures_6_to_9(tmp_path, name):
    records = [
        make_record(method, seed, scenario=scenario,
                    series=[make_series(seed, scenario == "scenario1", list(range(50)))])
        for method in ("ldm", "circular_buffer_pf_eq17") for seed in (1, 2)
        for scenario in ("scenario1", "scenario2")]
    done = finish_study(tmp_path, name, records)
    assert done.returncode == 0, done.stderr
    made = tmp_path / "results" / name
    assert "Velocity error (Sec. 4.1.3)" in done.stdout
    assert (made / "tables" / "velocity.tex").exists()
    assert (made / "tables" / "table1.tex").exists() == (name == "table1")
    figures = {file.stem for file in (made / "figures").glob("*.png")}
    assert {"figure6", "figure7", "figure8", "figure9", "velocity_errors"} == figures


@pytest.fixture
def studies(tmp_path: Path):
    """`make studies`, where the program knows two."""
    program = tmp_path / "ldm"
    listing = [{"study": "calibration", "trials": 60, "title": "Of the scenarios", "frames": 300,
                "methods": {"ldm": "ldm", "octomap": "octomap"}},
               {"study": "timing", "trials": 10, "title": "One at a time", "frames": 600,
                "methods": {"ldm": "ldm"}}]
    program.write_text(f"#!/bin/sh\necho '{json.dumps(listing)}'\n")
    program.chmod(0o755)

    def run() -> str:
        return subprocess.run(
            ["make", "-C", ROOT, "studies", f"LDM={program}", f"RESULTS={tmp_path}", "JOBS=2"],
            capture_output=True, text=True, check=True).stdout

    return run


def test_studies_are_listed_with_a_typical_time(studies):
    shown = studies()
    calibration = next(line for line in shown.splitlines() if line.startswith("calibration"))
    _, trials, time, *_ = calibration.split()
    assert trials == "60" and 10 < float(time) < 1000 and "s*" in calibration
    assert "* from a typical trial" in shown


def test_a_study_that_has_run_is_estimated_from_its_own_trials(studies, tmp_path):
    for name in ("calibration", "timing"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "MANIFEST").write_text("key k\ncommit c\ncpu_s_per_trial 120.000\n")
    shown = studies()
    assert "60  60 min   Of the scenarios" in shown
    assert "10  20 min   One at a time" in shown  # on one core
    assert "*" not in shown


@pytest.mark.parametrize("program, said", [
    ("/nowhere/ldm", "/nowhere/ldm: No such file or directory"),
    ("/usr", "/usr: Permission denied"),
    ("/bin/true", "/bin/true: answers no JSON; LDM is to be the `ldm` program")])
@pytest.mark.parametrize("target", ["studies", "trials"])
def test_another_program_is_one_line(target, program, said, tmp_path):
    outside = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    done = subprocess.run(["make", "-C", ROOT, target, "STUDY=table1", f"LDM={program}", f"RESULTS={tmp_path}"],
                          capture_output=True, text=True, check=False, env=outside)
    assert done.returncode == 2
    line, *rest = done.stderr.splitlines()
    assert line.removeprefix("study table1: ") == said
    assert len(rest) == 1 and rest[0].startswith("make: ***")


def test_a_folder_in_place_of_a_manifest_is_one_line(studies, tmp_path):
    (tmp_path / "timing" / "MANIFEST").mkdir(parents=True)
    with pytest.raises(subprocess.CalledProcessError) as failed:
        studies()
    assert failed.value.stderr.splitlines()[0] == f"{tmp_path}/timing/MANIFEST: Is a directory"


def test_a_run_leaves_its_pace(tmp_path):
    bench = Bench(tmp_path)
    assert bench.run().returncode == 0
    manifest = (bench.results / "fake" / "MANIFEST").read_text()
    (pace,) = (line.split()[1] for line in manifest.splitlines() if line.startswith("cpu_s_per_trial"))
    assert 0 < float(pace) < 1
