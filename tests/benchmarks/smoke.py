"""The benchmarks run and what they write is whole; only ratios that noise cannot turn are asserted.

ctest runs it with the programs' names in LDM_BENCH and LDM_KERNELS; pytest alone does not match its name.
"""

import json
import math
import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BENCH, KERNELS = os.environ["LDM_BENCH"], os.environ["LDM_KERNELS"]
LDM = {"subject": "ldm", "edge": 32, "particles": 200000, "channels": 16, "azimuths": 1024, "threads": 1}


def run(*command: str | Path) -> subprocess.CompletedProcess:
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)


@pytest.fixture(name="results", scope="module")
def measured(tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    prefixes = ("ldm/32^3/200000/16x1024", "plain_ldm", "circular_buffer/32^3", "liboctomap/32^3", "bound",
                "simulate")
    only = [word for prefix in prefixes for word in ("--only", prefix)]
    done = run("/usr/bin/python3", "experiments/benchmarks/bench.py", "--program", BENCH,
               "--kernels", KERNELS, "--results", folder, "--frames", "18", *only)
    assert done.returncode == 0, done.stderr
    return folder


@pytest.fixture(name="document")
def read(results):
    return json.loads((results / "bench.json").read_text())


def find(document, subject):
    return next(case for case in document["cases"] if case["subject"] == subject)


def test_the_document_is_whole(document):
    assert document["schema"] == 1 and document["frames"] == 18
    assert document["build"].keys() == {"version", "commit", "dirty", "compiler", "flags", "build_type"}
    assert document["machine"]["cores"] >= 1 and document["machine"]["largest_cache_bytes"] > 0
    for case in document["cases"]:
        # 8 frames of warm-up, and of each turn of 4 the first do not count.
        assert len(case["wall_ms"]) == len(case["cpu_ms"]) == 7, case
        times = [case["median_ms"], *case["wall_ms"], *case["cpu_ms"], *case["stages_ms"].values()]
        assert all(math.isfinite(ms) and ms >= 0 for ms in times), case
    assert {kernel["name"].partition("/")[0] for kernel in document["kernels"]} >= {
        "clustering", "measurement_flags", "occupancy_update", "particle_filter"}
    assert all(kernel["cpu_ms"] > 0 and kernel["items"] > 0 for kernel in document["kernels"])


def test_ours_has_the_stages_of_fig_1(document):
    ours = next(case for case in document["cases"] if LDM.items() <= case.items())
    assert list(ours["stages_ms"]) == [
        "occupancy_prediction", "particle_prediction", "movement_update", "measurement_flags",
        "occupancy_update", "particle_update", "resampling", "clustering"]


def test_ratios_that_no_noise_can_turn(document):
    median = {subject: find(document, subject)["median_ms"] for subject in (
        "ldm", "plain_ldm", "liboctomap", "circular_buffer", "bound_cache")}
    assert median["liboctomap"] > 5 * median["circular_buffer"]
    assert median["plain_ldm"] > 5 * median["ldm"]
    assert median["ldm"] > median["bound_cache"]


@pytest.mark.parametrize("script, made", [
    ("tables.bench_table", ["bench.txt"]),
    ("figures.bench_figures", ["figures/bench_stages.png", "figures/bench_growth.pdf"]),
])
def test_tables_and_figures_come_from_it(results, script, made):
    done = run("/usr/bin/python3", "-m", f"analysis.{script}", "--results", results)
    assert done.returncode == 0, done.stderr
    assert all((results / file).stat().st_size > 0 for file in made)


@pytest.mark.parametrize("arguments, message", [
    (["--frames", "9"], "--frames 9: allowed: 10 to 1200"),
    (["--frames", "ten"], "--frames ten: allowed: 10 to 1200"),
    (["--fast"], "argument --fast: allowed: --frames N, --only PREFIX"),
    (["--only"], "argument --only: allowed: --frames N, --only PREFIX"),
    (["--only", "nothing"],
     "--only nothing: no name begins so: allowed, for instance: ldm/32^3"),
])
def test_bad_arguments_give_one_line(arguments, message):
    done = run(BENCH, *arguments)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"ldm_bench: {message}\n")


def test_what_the_program_refuses_ends_the_script(tmp_path):
    done = run("/usr/bin/python3", "experiments/benchmarks/bench.py", "--program", BENCH,
               "--kernels", KERNELS, "--results", tmp_path, "--frames", "1")
    assert done.returncode == 2
    assert done.stderr == f"bench: {BENCH}: ldm_bench: --frames 1: allowed: 10 to 1200\n"
    assert list(tmp_path.iterdir()) == []
