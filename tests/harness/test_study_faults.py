"""`make trials` where something is wrong: cut records, hanging trials, other files, folders that cannot be written."""

import json
import os
import shutil
import signal
import subprocess
import time
from pathlib import Path

import pytest

from bench import ROOT, Bench


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


def one_line(done: subprocess.CompletedProcess) -> str:
    """What is on stderr beside make's own last word, which must be one line."""
    lines = [line for line in done.stderr.splitlines() if not line.startswith("make: ***")]
    assert done.returncode != 0 and len(lines) == 1, done.stderr
    return lines[0]


@pytest.mark.parametrize("cut", [lambda text: text[: len(text) // 2], lambda text: text.rstrip()[:-1],
                                 lambda text: ""])
def test_a_record_cut_short_is_run_again(bench, cut):
    bench.run()
    bench.ran()
    record = bench.results / "fake" / "records" / "t4.json"
    whole = record.read_text()
    record.write_text(cut(whole))
    done = bench.run()
    assert done.returncode == 0
    assert "study fake: t4 is run again: the record is cut short" in done.stderr
    assert bench.ran() == ["t4"] and record.read_text() == whole


def test_a_record_whose_series_are_cut_short_is_run_again(bench):
    bench.run()
    bench.ran()
    records = bench.results / "fake" / "records"
    content = json.loads((records / "t2.json").read_text()) | {"series_bytes": 10}
    (records / "t2.json").write_text(json.dumps(content))
    (records / "t2.series.json").write_text("0123456789")
    assert bench.run().returncode == 0 and bench.ran() == []
    (records / "t2.series.json").write_text("012345678")
    done = bench.run()
    assert "t2 is run again: the series beside the record are missing or cut short" in done.stderr
    assert bench.ran() == ["t2"] and not (records / "t2.series.json").exists()


def test_a_trial_that_hangs_is_ended_recorded_and_listed(bench):
    begin = time.monotonic()
    done = bench.run("TRIAL_SECONDS=1", HANG="t2")
    assert time.monotonic() - begin < 30
    assert "5 of 6 trials good" in done.stdout
    assert "FAILED t2: took longer than 1 s; TRIAL_SECONDS=n allows more\n" in done.stderr
    assert f"  {bench.program} --data-dir {ROOT} trial fake t2 -o " in done.stderr
    record = bench.records()["t2.json"]
    assert record["status"] == "failed" and record["error"].startswith("took longer than 1 s")
    assert sorted(os.listdir(bench.results / "fake" / "records")) == [f"t{n}.json" for n in range(1, 7)]
    assert not descendants_of(bench)  # the child of the trial neither


def descendants_of(bench: Bench) -> list[str]:
    """Processes that hold the study's lock."""
    lock = os.stat(bench.results / "fake" / "lock").st_ino
    found = []
    for entry in Path("/proc").glob("[0-9]*/fd/*"):
        try:
            if entry.stat().st_ino == lock and entry.readlink().name == "lock":
                found.append(str(entry))
        except OSError:
            continue
    return found


def test_a_killed_run_leaves_its_trials_the_lock_and_nothing_broken(bench):
    process = bench.start("SEEDS=8", SLEEP="2")
    while not list(bench.results.glob("fake/records/t*.json")):
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
    deadline = time.monotonic() + 30
    if descendants_of(bench):
        assert "another run is still writing" in bench.run("SEEDS=8").stderr
    while descendants_of(bench):
        assert time.monotonic() < deadline
    finished = bench.records()
    assert {record["status"] for record in finished.values()} == {"ok"}
    bench.ran()
    assert bench.run("SEEDS=8").returncode == 0
    assert len(bench.ran()) == 8 - len(finished)
    assert not list((bench.results / "fake" / "records").glob(".*"))


@pytest.fixture
def study_file(tmp_path: Path) -> Path:
    file = tmp_path / "own studies" / "mine.toml"
    file.parent.mkdir()
    file.write_text('title = "mine"\n')
    return file


def test_a_study_of_ones_own_is_named_by_its_file_and_stays_within_the_results(bench, study_file):
    done = bench.run(f"STUDY={study_file}", "FRAMES=30", INPUT=str(study_file))
    assert done.returncode == 0, done.stderr
    assert os.listdir(bench.results) == ["mine-f30"]
    assert len(bench.records("mine-f30")) == 6
    assert os.listdir(study_file.parent) == ["mine.toml"]


def test_a_study_of_ones_own_is_stale_when_its_file_has_changed(bench, study_file):
    variables = (f"STUDY={study_file}", "SEEDS=2")
    bench.run(*variables, INPUT=str(study_file))
    study_file.write_text('title = "changed"\n')
    assert "2 results are stale" in bench.run(*variables, INPUT=str(study_file)).stderr
    done = bench.run(f"STUDY={study_file}", "SEEDS=3", INPUT=str(study_file))
    assert "2 results are stale" in done.stderr and "1 are missing" in done.stderr


def test_another_study_of_the_same_name_is_refused(bench, study_file, tmp_path):
    bench.run(f"STUDY={study_file}", INPUT=str(study_file))
    bench.ran()
    other = tmp_path / "mine.toml"
    other.write_text('title = "other"\n')
    for more in ((), ("FRESH=1",)):
        said = one_line(bench.run(f"STUDY={other}", *more, INPUT=str(other)))
        assert said == (f"study mine: {bench.results}/mine holds the results of {study_file}, and {other} is "
                        "another study of that name: rename one of them, or give another RESULTS=folder")
    assert bench.ran() == [] and len(bench.records("mine")) == 6
    shutil.copy(study_file, other)  # the same study in another place
    assert bench.run(f"STUDY={other}", INPUT=str(study_file)).returncode == 0


def test_records_of_other_files_stop_the_study(bench, study_file):
    bench.run(INPUT=str(study_file))
    bench.ran()
    record = bench.results / "fake" / "records" / "t3.json"
    content = json.loads(record.read_text())
    content["files"] = {name: "0" for name in content["files"]}
    record.write_text(json.dumps(content))
    said = one_line(bench.run(INPUT=str(study_file)))
    assert f"1 results were made from other files than the study: t3 from another {study_file}" in said


def test_a_file_that_changes_while_the_study_runs_stops_it(bench, study_file):
    done = bench.run("JOBS=1", INPUT=str(study_file), EDIT="t3")
    assert done.returncode != 0
    assert f"study fake: stopped: {study_file} has changed while the study ran" in done.stderr
    assert sorted(bench.records()) == ["t1.json", "t2.json"]


def test_folders_with_blanks_work(tmp_path):
    folder = tmp_path / "a b"
    folder.mkdir()
    bench = Bench(folder)
    assert bench.run(CRASH="t3").returncode != 0
    assert bench.records()["t3.json"]["error"] == "killed by SIGSEGV"
    assert bench.run().returncode == 0


@pytest.mark.parametrize("text", ["garbage\n", "more garbage\n", "key\n", "key k\ncpu_s_per_trial soon\n", "\xff\xfe"])
def test_a_damaged_manifest_is_one_line(bench, text):
    bench.run()
    manifest = bench.results / "fake" / "MANIFEST"
    manifest.write_bytes(text.encode("latin-1"))
    said = one_line(bench.run())
    assert said == f"{manifest}: not as a study writes it; without the file its results count as stale"
    manifest.unlink()
    assert "6 results are stale (made by an unknown program" in bench.run().stderr


def test_a_folder_in_place_of_a_record_is_one_line(bench):
    record = bench.results / "fake" / "records" / "t2.json"
    record.mkdir(parents=True)
    assert one_line(bench.run()) == f"study fake: {record}: Is a directory"


def test_a_program_that_is_missing_is_one_line(bench):
    said = one_line(bench.run("LDM=/nowhere/ldm"))
    assert said == "study fake: /nowhere/ldm: No such file or directory"


def test_results_that_cannot_be_made_are_one_line(bench):
    bench.results.write_text("a file")
    assert one_line(bench.run()) == f"study fake: {bench.results}/fake: Not a directory"


def test_results_that_vanish_are_one_line(bench):
    process = bench.start("SEEDS=4", SLEEP="0.5")
    while not list(bench.results.glob("fake/records/t1.json")):
        time.sleep(0.02)
    bench.results.rename(bench.results.with_name("elsewhere"))
    _, err = process.communicate(timeout=60)
    lines = [line for line in err.splitlines() if not line.startswith("make: ***")]
    assert process.returncode != 0 and "Traceback" not in err
    assert lines[-1].startswith(f"study fake: {bench.results}/fake/")
    assert lines[-1].endswith(": No such file or directory")


@pytest.fixture
def small_disk(tmp_path: Path):
    """A file system of its own; `size` and `ro` can be changed by remounting."""
    folder = tmp_path / "disk"
    folder.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "none", folder],
                             capture_output=True, check=False).returncode == 0
    if not mounted:
        pytest.skip("needs the right to mount")
    yield folder
    subprocess.run(["umount", "-l", folder], check=True)


def fill(folder: Path) -> None:
    """Leave no byte."""
    with open(folder / "filler", "wb", buffering=0) as file:
        for size in (4096, 1):
            try:
                while True:
                    file.write(b"x" * size)
            except OSError:
                continue


def test_a_full_disk_is_named_for_each_failed_trial(bench, small_disk):
    bench.results = small_disk / "results"
    bench.run("SEEDS=1")
    fill(small_disk)
    done = bench.run("SEEDS=3")
    assert done.returncode != 0 and "Traceback" not in done.stderr
    assert "No space left on device" in done.stderr
    if "FAILED t2" in done.stderr:  # the manifest still had room
        assert "FAILED t2: exit code 1: " in done.stderr


def test_a_disk_for_reading_only_is_one_line(bench, small_disk):
    bench.results = small_disk / "results"
    bench.run("SEEDS=1")
    subprocess.run(["mount", "-o", "remount,ro", small_disk], check=True)
    assert one_line(bench.run("SEEDS=3")) == (
        f"study fake: {bench.results}/fake/lock: Read-only file system")
