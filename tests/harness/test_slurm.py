"""`make trials SLURM=1` with stand-ins for program and Slurm; `make test-slurm` meets the real one."""

import json
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from bench import ROOT, Bench


class SlurmBench(Bench):
    """A bench whose PATH begins with a Slurm."""

    def __init__(self, folder: Path):
        super().__init__(folder)
        self.state = folder
        programs = folder / "bin"
        programs.mkdir()
        for name in ("sbatch", "squeue", "scancel"):
            shutil.copy(ROOT / "tests" / "harness" / "fake_slurm.sh", programs / name)
        self.path = f"{programs}:{os.environ['PATH']}"

    def submit(self, *variables: str, **behaviour: str):
        return self.run("SLURM=1", *variables, PATH=self.path, SLURM_STATE=str(self.state), **behaviour)

    def sbatch_arguments(self) -> list[str]:
        return (self.state / "arguments").read_text().splitlines()


@pytest.fixture
def bench(tmp_path: Path) -> SlurmBench:
    return SlurmBench(tmp_path)


def test_gives_the_records_of_a_local_run(bench):
    done = bench.submit("SHARDS=3")
    assert done.returncode == 0, done.stderr
    assert "6 of 6 trials good" in done.stdout
    assert bench.ran() == ["t1", "t2", "t3", "t4", "t5", "t6"]
    over_slurm = bench.records()
    bench.run("FRESH=1")
    assert bench.records() == over_slurm


def test_every_shard_has_its_share(bench):
    bench.submit("SHARDS=4")
    folder = bench.results / "fake" / "slurm"
    shares = [json.loads(file.read_text())["trials"] for file in sorted(folder.glob("shard-*.json"))]
    assert shares == [["t1", "t5"], ["t2", "t6"], ["t3"], ["t4"]]
    assert not (folder / "job").exists()


def test_there_are_no_empty_shards(bench):
    assert bench.submit("SHARDS=50").returncode == 0
    assert "--array=1-6" in bench.sbatch_arguments()


def test_cpus_and_more_flags_reach_sbatch(bench):
    bench.submit("CPUS=8", "SBATCH_FLAGS=--time=2:00:00 --comment='two words'")
    assert {"--requeue", "--cpus-per-task=8", "--time=2:00:00", "--comment=two words"} <= set(
        bench.sbatch_arguments())
    assert "--jobs=8" in bench.sbatch_arguments()[-1]


def test_failures_are_listed_and_tried_again(bench):
    done = bench.submit(FAIL="t2", CRASH="t5")
    assert done.returncode != 0
    assert "4 of 6 trials good" in done.stdout
    assert "FAILED t2: no path found\n" in done.stderr
    assert "FAILED t5: killed by SIGSEGV\n" in done.stderr
    bench.ran()
    assert bench.submit().returncode == 0
    assert bench.ran() == ["t2", "t5"]


def test_trials_that_left_no_record_are_missed(bench):
    done = bench.submit(END="t3")
    assert done.returncode != 0
    assert "1 trials left no record; out of time?" in done.stderr
    assert "FAILED t3: no record" in done.stderr


def test_without_sbatch_one_line_says_so(bench):
    # Of this machine's commands only those needed: it may have a Slurm itself.
    path = bench.state / "few"
    path.mkdir()
    for name in ("git", "seq", "cat", "cksum", "sed"):
        (path / name).symlink_to(shutil.which(name))
    done = subprocess.run(
        ["/usr/bin/python3", ROOT / "experiments" / "harness" / "run_study.py", "fake", "--program", bench.program,
         "--results", bench.results, "--shards", "2"],
        env={"PATH": str(path), "LOG": str(bench.log)}, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert done.stderr.splitlines()[-1] == (
        "study fake: sbatch is not installed here: SLURM=1 needs a machine that submits to Slurm; "
        "without it the trials run on this one")
    assert bench.ran() == []


def test_what_sbatch_refuses_is_passed_on(bench):
    done = bench.submit("SBATCH_FLAGS=--partition=none")
    assert done.returncode != 0
    assert "study fake: sbatch: sbatch: error: invalid partition specified: none" in done.stderr
    assert not (bench.results / "fake" / "slurm" / "job").exists()


def test_a_forgotten_job_keeps_others_out_while_it_lives(bench):
    job = bench.results / "fake" / "slurm" / "job"
    job.parent.mkdir(parents=True)
    job.write_text("7\n")
    (bench.state / "process").write_text(f"{os.getpid()}\n")
    done = bench.submit()
    assert done.returncode != 0
    assert "Slurm's job 7 is still writing" in done.stderr and "'scancel 7' ends it" in done.stderr
    assert bench.ran() == []

    (bench.state / "process").write_text("999999999\n")
    assert bench.submit().returncode == 0


def test_times_are_not_measured_over_slurm(bench):
    done = bench.submit("STUDY=timing")
    assert done.returncode != 0
    assert "no Slurm" in done.stderr
