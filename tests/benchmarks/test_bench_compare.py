"""`make bench-compare`: a revision beside the working tree, with a stand-in for program and build."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "experiments" / "benchmarks"
sys.path.insert(0, str(SCRIPTS))

from compare import interval  # noqa: E402
from samples import BenchError, Configuration, parse  # noqa: E402

PROGRAM = """#!/bin/sh
echo "# format: {format}"
echo "subject,edge,particles,channels,azimuths,threads,frame,part,wall_ms,cpu_ms"
for frame in 1 2 3; do
  echo "ldm,32,200000,16,1024,1,$frame,total,99,{ms}"
  echo "ldm,32,200000,16,1024,2,$frame,total,{ms},99"
done
"""
CMAKE = """cmake_minimum_required(VERSION 3.25)
project(stand_in NONE)
add_custom_target(ldm_bench COMMAND ${CMAKE_COMMAND} -E make_directory bin
  COMMAND cp ${CMAKE_SOURCE_DIR}/program bin/ldm_bench)
"""


def write_program(file: Path, ms: float, program_format: int = 1) -> None:
    file.write_text(PROGRAM.format(ms=ms, format=program_format))
    file.chmod(0o755)


class Repository:
    """A repository with a program that takes so many milliseconds in each revision."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.git("init", "--quiet")
        self.commit("before the benchmarks")
        (folder / "experiments" / "benchmarks").mkdir(parents=True)
        (folder / "experiments" / "benchmarks" / "CMakeLists.txt").touch()
        (folder / "CMakeLists.txt").write_text(CMAKE)
        (folder / ".gitignore").write_text("/build*/\n")

    def git(self, *words: str) -> str:
        command = ["git", "-c", "user.name=Test", "-c", "user.email=test@example.org", *words]
        return subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=True).stdout

    def commit(self, message: str) -> None:
        self.git("add", "--all")
        self.git("commit", "--quiet", "--allow-empty", "--message", message)

    def compare(self, revision: str) -> subprocess.CompletedProcess:
        return subprocess.run(
            ["/usr/bin/python3", SCRIPTS / "compare.py", f"--revision={revision}", "--program", "./program",
             "--pairs", "3", "--jobs", "1"],
            cwd=self.folder, capture_output=True, text=True, check=False,
            env={k: v for k, v in os.environ.items() if not k.startswith(("MAKE", "MFLAGS"))})


@pytest.fixture(name="repository")
def made(tmp_path):
    repository = Repository(tmp_path)
    write_program(tmp_path / "program", ms=8)
    repository.commit("slow")
    write_program(tmp_path / "program", ms=2)
    return repository


def test_the_ratio_of_each_configuration(repository):
    done = repository.compare("HEAD")
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[0] == "time of the working tree / time of HEAD: median and interval of 3 pairs"
    # One thread by its CPU time, two by wall time.
    assert [line.split() for line in lines[2:]] == [
        ["ldm/32^3/200000/16x1024/1", "0.250", "0.250..0.250", "faster"],
        ["ldm/32^3/200000/16x1024/2", "0.250", "0.250..0.250", "faster"]]


def test_the_working_tree_is_left_alone(repository):
    before = repository.git("status", "--porcelain"), repository.git("rev-parse", "HEAD")
    repository.compare("HEAD")
    assert (repository.git("status", "--porcelain"), repository.git("rev-parse", "HEAD")) == before
    assert "8" in (repository.folder / "build-rev" / before[1].strip() / "source" / "program").read_text()


def test_a_second_time_and_after_clean(repository):
    repository.compare("HEAD")
    assert repository.compare("HEAD").returncode == 0
    subprocess.run(["rm", "-rf", repository.folder / "build-rev"], check=True)
    assert repository.compare("HEAD").returncode == 0


@pytest.mark.parametrize("revision, message", [
    ("nosuch", "REV=nosuch: no such revision here"),
    ("--all", "REV=--all: no such revision here"),
    ("HEAD~1", "REV=HEAD~1: it has no experiments/benchmarks/CMakeLists.txt: allowed: "
               "revisions with benchmarks"),
])
def test_revisions_that_cannot_be_compared(repository, revision, message):
    done = repository.compare(revision)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"bench-compare: {message}\n")
    assert not (repository.folder / "build-rev").exists()


def test_a_revision_that_does_not_build(repository):
    (repository.folder / "CMakeLists.txt").write_text("nonsense(\n")
    repository.commit("broken")
    done = repository.compare("HEAD")
    assert done.returncode == 1
    assert "does not build: see build-rev/" in done.stderr and done.stderr.count("\n") == 1


def test_another_format_is_refused(repository):
    write_program(repository.folder / "program", ms=1, program_format=7)
    done = repository.compare("HEAD")
    assert done.returncode == 2
    assert done.stderr.endswith("/program: prints format 7: allowed: 1\n")


def test_an_interval_leaves_one_ratio_out_on_either_side():
    assert interval([3, 1, 2]) == (2, 2)
    assert interval([9, 1, 5, 3, 7, 2, 8, 4, 6]) == (2, 8)


def test_output_by_hand():
    run = parse(["# format: 1", "# cpu: Test: CPU",
                 "subject,edge,particles,channels,azimuths,threads,frame,part,wall_ms,cpu_ms",
                 "ldm,32,5,16,8,2,9,total,1.5,2.5", "ldm,32,5,16,8,2,9,clustering,0.5,",
                 "ldm,32,5,16,8,2,10,total,2.5,3.5", "ldm,32,5,16,8,2,10,clustering,0.7,"], Path("p"))
    case = Configuration("ldm", 32, 5, 16, 8, 2)
    assert run.facts == {"format": "1", "cpu": "Test: CPU"}
    assert list(run.samples) == [case] and str(case) == "ldm/32^3/5/16x8/2"
    assert run.samples[case].median("wall") == 2 and run.samples[case].median("cpu") == 3
    assert run.samples[case].stages == {"clustering": [0.5, 0.7]}
    with pytest.raises(BenchError, match="prints format None"):
        parse(["no facts"], Path("p"))
