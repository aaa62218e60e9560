"""The stages of the search, with the real program on trials of a few frames."""

import csv
import json
import os
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import search
from design import read_conditions, space_filling
from unknowns import unknowns
from trials import METHODS, Trial, batches, parameters, run, trials, write_studies
from worlds import scenario_text, toml

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("LDM", ROOT / "build" / "bin" / "ldm")).resolve()
FRAMES = {"scenario1": 3, "scenario2": 3, "scenario3": 3, "outdoor1": 3, "outdoor2": 3}
OF_ONE = sum(map(len, METHODS.values()))

needs_program = pytest.mark.skipif(not PROGRAM.exists(), reason="the program is not built")


def stage(results, name, *options):
    command = [sys.executable, ROOT / "experiments" / "conditions" / "search.py", name,
               "--program", PROGRAM, "--results", results, "--jobs", "2", *options]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def records(results, name):
    found = (results / "conditions" / name).glob("*/records/*.json")
    return sorted(file for file in found if not file.name.endswith(".series.json"))


def test_hints_lie_within_the_ranges():
    for hint in read_conditions(search.STAGES.with_name("hints.csv")).values():
        for unknown in unknowns():
            assert unknown.words or -0.01 <= unknown.share(hint[unknown.name]) <= 1.01


def test_toml_comes_back():
    tables = {"a": 1, "b": [1.5, 2], "c": {"x.y": "text", "on": True, "d": {"e": -2.0}}}
    assert tomllib.loads(toml(tables)) == tables


def test_a_world_has_the_speeds_of_its_condition_and_keeps_the_rest():
    condition = space_filling(1)[0] | {"speed_mps": 0.3, "width_scale": 1.0, "elevation_deg": 12.0}
    world = tomllib.loads(scenario_text("scenario3", condition))
    assert world["groups"]["walking_persons"]["speed_mps"] == [0.2, 0.4]
    assert world["sensor"]["elevation_deg"] == [-12.0, 12.0]
    assert world["groups"]["boxes"]["count"] == 3 and "speed_mps" not in world["groups"]["boxes"]
    assert world["uav"]["height_m"] == [1.2, 1.9]


def test_narrow_obstacles_are_more():
    condition = space_filling(1)[0] | {"width_scale": 0.75}
    world = tomllib.loads(scenario_text("scenario2", condition))
    assert world["groups"]["boxes"]["count"] == round(9 * 0.75**-1.2)


def test_clamps_and_vertical_noise_follow_the_condition():
    condition = space_filling(1)[0] | {"clamps": "usenko", "sigma_mps": 0.2, "sigma_z_share": 0.5}
    found = parameters(condition)
    assert (found["sensor_model.log_odds_min"], found["sensor_model.log_odds_max"]) == (-2.75, 2.75)
    assert found["particles.sigma_z_mps"] == pytest.approx(0.1)


def test_trials_of_one_study_and_world_are_one_batch(tmp_path):
    found = batches(trials(tmp_path, FRAMES, [1, 2]))
    assert [len(batch.trials) for batch in found] == [10, 1, 1, 10, 1, 1]
    assert found[0].command("ldm")[:4] == ["ldm", "--data-dir", str(ROOT), "trial"]
    assert found[0].command("ldm")[-3:] == ["1", "-o", str(tmp_path / "records")]
    assert found[1].command("ldm")[-1] == str(tmp_path / "records" / "outdoor1.ldm.s001.json")


def test_no_two_stages_share_a_world():
    seen = set()
    for of_stage in search.stages():
        first, last = of_stage["replicates"]
        worlds = set(range(first, last + 1))
        assert worlds and not worlds & seen
        seen |= worlds


def test_the_first_stage_has_at_least_400_conditions_and_the_last_50_worlds():
    first, *_, last = search.stages()
    assert first["conditions"] >= 400
    assert last["replicates"][1] - last["replicates"][0] + 1 >= 50
    assert last["frames"]["scenario1"] == 1200 and last["keep"] == 3


@needs_program
def test_a_stage_runs_is_resumed_and_hands_over_to_the_next(tmp_path):
    first = stage(tmp_path, "stage1", "--conditions", "2", "--frames", "0.02")
    assert first.returncode == 0, first.stderr
    assert len(records(tmp_path, "stage1")) == 2 * OF_ONE
    again = json.loads(records(tmp_path, "stage1")[0].read_text())
    assert again["status"] == "ok" and again["frames"] <= 4

    lost = records(tmp_path, "stage1")[3]
    lost.unlink()
    resumed = stage(tmp_path, "stage1", "--conditions", "2", "--frames", "0.02")
    assert "1 to run" in resumed.stderr and lost.exists()

    refused = stage(tmp_path, "stage2a", "--conditions", "1")
    assert refused.returncode != 0 and "ranking.csv" in refused.stderr

    ranking = tmp_path / "conditions" / "stage1" / "ranking.csv"
    with ranking.open("w", newline="", encoding="utf-8") as stream:
        csv.writer(stream).writerows([["condition"], ["c0002"], ["c0001"]])
    second = stage(tmp_path, "stage2a", "--conditions", "1", "--offspring", "1", "--seeds", "1",
                   "--frames", "0.01")
    assert second.returncode == 0, second.stderr
    found = read_conditions(tmp_path / "conditions" / "stage2a" / "conditions.csv")
    before = read_conditions(tmp_path / "conditions" / "stage1" / "conditions.csv")
    hints = read_conditions(search.STAGES.with_name("hints.csv"))
    assert list(found) == ["c0002", *hints, "stage2a-001"] and found["c0002"] == before["c0002"]


def test_a_batch_that_hangs_is_ended_and_named(tmp_path, monkeypatch):
    program = tmp_path / "ldm"
    program.write_text("#!/bin/sh\nexec sleep 1000\n")
    program.chmod(0o755)
    monkeypatch.setattr("pace.limit_s", lambda *_: 0.2)
    complaints = []
    batch = batches([Trial(tmp_path / "flight.toml", "scenario1.ldm.s001", 1, 3)])
    assert run(batch, str(program), 1, lambda _, complaint: complaints.append(complaint)) == 1
    assert complaints[0].startswith(f"took longer than 0 s: {program} --data-dir ")


def test_results_that_cannot_be_written_are_one_line(tmp_path):
    (tmp_path / "conditions").write_text("a file")
    found = stage(tmp_path, "stage1", "--conditions", "1")
    assert found.returncode == 1
    assert found.stderr == f"stage1: {tmp_path}/conditions/stage1: Not a directory\n"


@needs_program
def test_shares_of_many_machines_are_the_whole(tmp_path):
    for share in ("1/2", "2/2"):
        found = stage(tmp_path, "stage1", "--conditions", "1", "--frames", "0.02", "--share", share)
        assert found.returncode == 0, found.stderr
    assert len(records(tmp_path, "stage1")) == OF_ONE


@pytest.fixture
def slurm(tmp_path, monkeypatch):
    """A stand-in for Slurm; what sbatch was told is in the file `arguments`."""
    for name in ("sbatch", "squeue", "scancel"):
        shutil.copy(ROOT / "tests" / "harness" / "fake_slurm.sh", tmp_path / name)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    monkeypatch.setenv("SLURM_STATE", str(tmp_path))


@needs_program
def test_over_slurm_the_shares_are_tasks_of_one_job(tmp_path, slurm):
    options = ("--conditions", "1", "--frames", "0.02", "--shards", "2", "--sbatch-flags=--time=9:00")
    done = stage(tmp_path / "r", "stage1", *options)
    assert done.returncode == 0, done.stderr
    assert len(records(tmp_path / "r", "stage1")) == OF_ONE
    arguments = (tmp_path / "arguments").read_text().splitlines()
    assert "--array=1-2" in arguments and "--time=9:00" in arguments
    again = stage(tmp_path / "r", "stage1", *options)
    assert again.returncode == 0 and "0 to run" in again.stderr and "job" not in again.stderr


@needs_program
def test_over_slurm_a_trial_that_fails_is_named_and_tried_again(tmp_path, slurm):
    options = ("--conditions", "1", "--frames", "0.02", "--shards", "2")
    assert stage(tmp_path, "stage1", *options).returncode == 0
    world = tmp_path / "conditions" / "stage1" / "c0001" / "scenario1.toml"
    whole = world.read_text()
    world.write_text(whole.replace("size_m = [10, 10]", "size_m = [1, 1]"))
    lost = [file for file in records(tmp_path, "stage1") if file.name.startswith("scenario1.ldm.")]
    lost[0].unlink()
    failed = stage(tmp_path, "stage1", *options)
    assert failed.returncode == 1
    assert f"FAILED c0001 {lost[0].stem}: " in failed.stderr and "no world" in failed.stderr
    world.write_text(whole)
    again = stage(tmp_path, "stage1", *options)
    assert again.returncode == 0 and "1 to run" in again.stderr


@needs_program
def test_over_slurm_trials_without_a_record_are_missed(tmp_path, slurm, monkeypatch):
    assert stage(tmp_path, "stage1", "--conditions", "1", "--frames", "0.02").returncode == 0
    records(tmp_path, "stage1")[0].unlink()
    monkeypatch.setattr(sys.modules[__name__], "PROGRAM", tmp_path / "none")
    found = stage(tmp_path, "stage1", "--conditions", "1", "--frames", "0.02", "--shards", "1")
    assert found.returncode == 1 and "1 trials left no record" in found.stderr


@needs_program
def test_a_record_cut_short_is_run_again(tmp_path):
    options = ("--conditions", "1", "--frames", "0.02")
    assert stage(tmp_path, "stage1", *options).returncode == 0
    short = records(tmp_path, "stage1")[0]
    whole = short.read_bytes()
    short.write_bytes(whole[:-2])
    assert "1 to run" in stage(tmp_path, "stage1", *options).stderr
    assert json.loads(short.read_bytes())["scores"] == json.loads(whole)["scores"]


def test_without_slurm_one_line_says_so(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    found = stage(tmp_path / "r", "stage1", "--conditions", "1", "--shards", "2")
    assert found.returncode == 1
    assert found.stderr.splitlines()[-1].startswith("conditions stage1: sbatch is not installed here")


@pytest.mark.parametrize("option", [("--share", "3/2"), ("--share", "0/2"), ("--share", "x"),
                                    ("--frames", "2"), ("--frames", "0.0"), ("--seeds", "0")])
def test_a_bad_option_is_named_with_what_is_allowed(tmp_path, option):
    found = stage(tmp_path, "stage1", *option)
    assert found.returncode == 2
    assert option[0] in found.stderr and repr(option[1]) in found.stderr


@needs_program
def test_a_trial_that_fails_is_named_and_the_rest_is_run(tmp_path):
    assert stage(tmp_path, "stage1", "--conditions", "1", "--frames", "0.02").returncode == 0
    for file in records(tmp_path, "stage1"):
        file.unlink()
    world = tmp_path / "conditions" / "stage1" / "c0001" / "scenario1.toml"
    world.write_text(world.read_text().replace("size_m = [10, 10]", "size_m = [1, 1]"))
    found = stage(tmp_path, "stage1", "--conditions", "1", "--frames", "0.02")
    assert found.returncode == 1
    assert "FAILED c0001" in found.stderr and "no world" in found.stderr
    assert len(records(tmp_path, "stage1")) == OF_ONE


def test_files_of_a_condition_are_studies_of_the_program(tmp_path):
    write_studies(tmp_path / "c0001", space_filling(1)[0], FRAMES)
    study = tomllib.loads((tmp_path / "c0001" / "flight.toml").read_text())
    assert study["methods"] == list(METHODS["scenario1"])
    assert Trial(tmp_path / "c0001" / "flight.toml", "a.b.s001", 1, 3).record == (
        tmp_path / "c0001" / "records" / "a.b.s001.json")
