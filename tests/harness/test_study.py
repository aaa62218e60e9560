"""`make trials`, the first half of `make study`: resuming, failures, interruptions, stale results."""

import json
import os
import signal
import subprocess
import time
from pathlib import Path

import pytest

from bench import ROOT, Bench


@pytest.fixture
def bench(tmp_path: Path) -> Bench:
    return Bench(tmp_path)


def test_runs_every_trial_once(bench):
    done = bench.run()
    assert done.returncode == 0
    assert "6 of 6 trials good" in done.stdout
    assert bench.ran() == ["t1", "t2", "t3", "t4", "t5", "t6"]
    assert {record["status"] for record in bench.records().values()} == {"ok"}

    assert bench.run().returncode == 0
    assert bench.ran() == []


def test_more_seeds_add_trials_only(bench):
    bench.run("SEEDS=2")
    assert bench.ran() == ["t1", "t2"]
    bench.run("SEEDS=4")
    assert bench.ran() == ["t3", "t4"]


def test_shortened_trials_have_their_own_folder(bench):
    bench.run()
    bench.run("SEEDS=1", "FRAMES=30")
    assert len(bench.records("fake")) == 6
    (record,) = bench.records("fake-f30").values()
    assert "--frames 30" in record["arguments"]


def test_goes_on_past_a_failure_and_lists_it(bench):
    done = bench.run(FAIL="t2")
    assert done.returncode != 0
    assert "5 of 6 trials good" in done.stdout
    record = bench.results / "fake" / "records" / "t2.json"
    command = f"{bench.program} --data-dir {ROOT} trial fake t2 -o {record}"
    assert f"FAILED t2: no path found\n  {command}\n" in done.stderr
    assert "1 of 6 trials failed" in done.stderr
    assert bench.records()["t2.json"]["status"] == "failed"


def test_tries_failed_trials_again(bench):
    bench.run(FAIL="t2")
    bench.ran()
    done = bench.run()
    assert done.returncode == 0
    assert bench.ran() == ["t2"]


def test_a_crash_leaves_a_record_with_its_reason(bench):
    done = bench.run(CRASH="t3")
    assert done.returncode != 0
    assert "FAILED t3: killed by SIGSEGV" in done.stderr
    record = bench.records()["t3.json"]
    assert record["status"] == "failed"
    assert record["error"] == "killed by SIGSEGV"
    assert record["id"] == "t3"


def test_a_trial_that_is_asked_to_end_has_not_failed(bench):
    done = bench.run(END="t3")
    assert done.returncode != 0
    assert "FAILED t3: ended by SIGTERM, no record" in done.stderr
    assert bench.run().returncode == 0


def test_the_command_of_a_failed_trial_repeats_it(bench):
    listed = bench.run(CRASH="t3").stderr.splitlines()
    command = listed[listed.index("FAILED t3: killed by SIGSEGV") + 1]
    bench.ran()
    again = subprocess.run(command, shell=True, cwd=ROOT, check=False,
                           env=os.environ | {"LOG": str(bench.log), "CRASH": "t3"})
    assert again.returncode == 128 + signal.SIGSEGV
    assert bench.ran() == ["t3"]


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
def test_an_interrupted_run_is_continued(bench, number):
    process = bench.start("SEEDS=8", SLEEP="0.4")
    deadline = time.monotonic() + 30
    while not list(bench.results.glob("fake/records/t*.json")):
        assert time.monotonic() < deadline
        time.sleep(0.02)
    # Ctrl-C and a closed terminal reach every process of its group, a polite `kill` only the first.
    process.send_signal(number) if number == signal.SIGTERM else os.killpg(process.pid, number)
    process.communicate(timeout=30)
    assert process.returncode != 0
    assert len(bench.ran()) < 8
    finished = bench.records()
    assert {record["status"] for record in finished.values()} == {"ok"}

    done = bench.run("SEEDS=8")
    assert done.returncode == 0
    assert bench.ran() == sorted({f"t{n}" for n in range(1, 9)} - {n[:-5] for n in finished})
    files = sorted(file.name for file in (bench.results / "fake" / "records").iterdir())
    assert files == [f"t{n}.json" for n in range(1, 9)]


def test_an_interruption_before_the_first_trial_is_one_line(bench):
    process = bench.start(LISTING="20")
    deadline = time.monotonic() + 30
    while not bench.log.with_name("log.listing").exists():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=15)
    assert process.returncode != 0 and "Traceback" not in err
    assert "study fake: stopped; the same command continues it" in err


def test_a_second_run_at_the_same_time_is_refused(bench):
    first = bench.start(SLEEP="0.3")
    deadline = time.monotonic() + 30
    while not (bench.results / "fake" / "MANIFEST").exists():
        assert time.monotonic() < deadline
        time.sleep(0.02)
    second = bench.run()
    assert second.returncode != 0
    assert "another run" in second.stderr
    first.communicate(timeout=30)
    assert first.returncode == 0


def test_stale_results_are_named_and_used(bench):
    bench.run()
    bench.ran()
    bench.change_program()
    done = bench.run()
    assert done.returncode == 0
    assert "6 results are stale (made by commit " in done.stderr
    assert bench.ran() == []


def test_results_of_two_programs_never_mix(bench):
    bench.run()
    bench.ran()
    bench.change_program()
    done = bench.run("SEEDS=8")
    assert done.returncode != 0
    assert "6 results are stale" in done.stderr and "2 are missing" in done.stderr
    assert "FRESH=1" in done.stderr
    assert bench.ran() == []


def test_a_failed_trial_counts_as_missing_when_results_are_stale(bench):
    bench.run(FAIL="t2")
    bench.ran()
    bench.change_program()
    assert "1 are missing" in bench.run().stderr
    assert bench.ran() == []
    assert bench.records()["t2.json"]["status"] == "failed"


def test_fresh_runs_all_again(bench):
    bench.run("SEEDS=8")
    bench.ran()
    bench.change_program()
    assert bench.run("FRESH=1").returncode == 0
    assert bench.ran() == ["t1", "t2", "t3", "t4", "t5", "t6"]
    assert len(bench.records()) == 6
    assert "stale" not in bench.run().stderr


@pytest.mark.parametrize("variable", ["SEEDS=0", "SEEDS=ten", "FRAMES=-1", "JOBS=0"])
def test_numbers_are_checked(bench, variable):
    done = bench.run(variable)
    assert done.returncode != 0
    assert "a whole number of at least 1 is needed" in done.stderr
    assert not bench.results.exists()


@pytest.mark.parametrize("variable", ["SEEDS=1'; touch made'", "JOBS=1`touch made`", "STUDY=a'; touch made '"])
def test_no_variable_is_run_by_a_shell(bench, variable, tmp_path):
    done = subprocess.run(["make", "-f", ROOT / "Makefile", "-n", "trials", f"LDM={bench.program}", variable],
                          cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert "a whole number of at least 1 is needed" in done.stderr or "quotation mark" in done.stderr
    assert len(done.stderr.splitlines()) == 1 and not (tmp_path / "made").exists()


def test_the_programs_own_refusal_is_passed_on(bench):
    done = bench.run(UNKNOWN="1")
    assert done.returncode != 0
    assert done.stderr.startswith("unknown study\n")
    assert not bench.results.exists()


def test_ten_thousand_finished_trials_take_a_second(bench):
    records = bench.results / "fake" / "records"
    bench.run("SEEDS=1")
    content = json.dumps(json.loads((records / "t1.json").read_text()) | {"scores": "x" * 5000})
    for number in range(1, 10001):
        (records / f"t{number}.json").write_text(content)
    start = time.monotonic()
    done = bench.run("SEEDS=10000")
    assert done.returncode == 0
    assert "10000 of 10000 trials good" in done.stdout
    assert time.monotonic() - start < 5  # about 0.5 s; loose, for a busy machine


@pytest.fixture
def plugin(tmp_path: Path) -> Path:
    file = tmp_path / "new.so"
    file.write_text("first build\n")
    return file


def run_beside(bench, *variables: str) -> subprocess.CompletedProcess:
    """The runs of `make compare`, of which the fake records suffice for all but the table."""
    return subprocess.run(
        ["/usr/bin/python3", ROOT / "experiments" / "harness" / "run_study.py", "fake", "--program", bench.program,
         "--results", bench.results, "--methods", "old new", *variables],
        env=os.environ | {"LOG": str(bench.log), "NAMED": "1"},
        capture_output=True, text=True, check=False)


def test_a_method_beside_the_study_has_records_of_its_own(bench, plugin):
    done = run_beside(bench, "--plugin", str(plugin), "--seeds", "2")
    assert done.returncode == 0
    assert "study fake: 2 of 2 trials good" in done.stdout
    assert "study fake+new: 2 of 2 trials good" in done.stdout
    assert bench.ran() == ["w.new.t1", "w.new.t2", "w.old.t1", "w.old.t2"]
    assert "plugin" not in bench.records()["w.old.t1.json"]["arguments"]
    assert "--method new" in bench.records("fake+new")["w.new.t1.json"]["arguments"]


def test_a_new_build_of_a_plugin_leaves_the_study_alone(bench, plugin):
    arguments = ("--plugin", str(plugin), "--seeds", "2")
    run_beside(bench, *arguments)
    bench.ran()
    plugin.write_text("second build\n")
    done = run_beside(bench, *arguments)
    assert "study fake+new: 2 results are stale" in done.stderr
    assert "study fake:" not in done.stderr and bench.ran() == []

    run_beside(bench, *arguments, "--fresh")
    assert bench.ran() == ["w.new.t1", "w.new.t2"]


def test_an_unknown_method_stops_before_any_trial(bench):
    done = run_beside(bench)
    assert done.returncode == 2
    assert done.stderr == "unknown method new\n"
    assert bench.ran() == []
