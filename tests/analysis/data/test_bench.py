"""The speed table and figures: ratios by hand, verdicts, and files that are not bench.json."""

import json

import pytest

from analysis.data.bench import Case, bound, ldm, load_bench
from analysis.data.command_line import run
from analysis.figures.bench_figures import growth_figure, main as draw, stages_figure
from analysis.report.bench_numbers import KEYS, bench_numbers
from analysis.report.evidence import Evidence
from analysis.tables.bench_table import main as tabulate, target_row, targets

STAGES = {"particle_prediction": 0.5, "resampling": 0.7}
MILLISECONDS = {
    ldm(32, 200_000): 2.0,
    ldm(32, 200_000, threads=2): 1.5,
    ldm(64, 200_000): 4.5,
    ldm(32, 200_000, rays=(64, 2048)): 2.5,
    bound("memory", 200_000, 1): 1.0,
    bound("cache", 200_000, 1): 0.25,
    Case("plain_ldm", 32, 200_000): 60.0,
    Case("circular_buffer", 32): 0.6,
    Case("liboctomap", 32): 6.0,
}


def entry(case: Case, ms: float) -> dict:
    return {"subject": case.subject, "edge": case.edge, "particles": case.particles,
            "channels": case.rays[0], "azimuths": case.rays[1], "threads": case.threads, "clock": "cpu",
            "median_ms": ms, "wall_ms": [ms], "cpu_ms": [ms], "stages_ms": STAGES}


@pytest.fixture(name="document")
def made():
    return {
        "schema": 1, "frames": 100,
        "build": {"version": "0.1.0", "commit": "0123456789abcdef", "dirty": True, "compiler": "GNU 12",
                  "flags": "-O3", "build_type": "Release"},
        "machine": {"cpu": "Test CPU", "cores": 2, "largest_cache_bytes": 1,
                    "load_average_before_and_after": [0.1, 1.0]},
        "memory": {"bytes_beside_particles_per_voxel": 23.5, "blocks_in_steady_state": 3},
        "cases": [entry(case, ms) for case, ms in MILLISECONDS.items()],
        "kernels": [{"name": "clustering/edge:32", "items": 32768, "cpu_ms": 0.032768}],
    }


def write(folder, document) -> None:
    (folder / "bench.json").write_text(json.dumps(document))


@pytest.fixture(name="bench")
def loaded(tmp_path, document):
    write(tmp_path, document)
    return load_bench(tmp_path)


def row(bench, start: str) -> list[str]:
    return next(target_row(t, bench) for t in targets() if t.text.startswith(start))[1:]


def test_ratios_by_hand(bench):
    one = "32^3, 200,000 particles, 1 thread: B3 from"
    assert row(bench, f"{one} memory") == ["2.000", "1.000", "2.00", "<= 2.5 times", "met"]
    assert row(bench, f"{one} cache") == ["2.000", "0.250", "8.00", "<= 2.5 times", "NOT MET"]
    assert row(bench, "64^3 over 32^3") == ["4.500", "2.000", "2.25", "<= 2 times", "NOT MET"]
    assert row(bench, "32^3, 200,000 particles: 1 thread over 2") == [
        "2.000", "1.500", "1.33", ">= 1.2 times", "met"]
    assert row(bench, "plain") == ["60.000", "2.000", "30.00", ">= 25 times", "met"]
    assert row(bench, "liboctomap over circular_buffer, 32") == [
        "6.000", "0.600", "10.00", ">= 15 times", "NOT MET"]
    assert row(bench, "circular_buffer, 32^3") == ["0.600", "", "0.60", "<= 0.5 ms", "NOT MET"]
    assert row(bench, "64x2048") == ["2.500", "2.000", "1.25", "<= 1.5 times", "met"]
    assert row(bench, "memory") == ["", "", "23.5", "<= 24 bytes a voxel", "met"]
    assert row(bench, "allocations") == ["", "", "3.0", "<= 0 blocks", "NOT MET"]


def test_what_was_not_measured_has_no_verdict(bench):
    assert row(bench, "32^3, 200,000 particles, 2 threads: B3 from memory") == [
        "1.500", "-", "-", "<= 4 times", "not measured"]
    assert row(bench, "simulated scan") == ["-", "", "-", "<= 0.5 ms", "not measured"]


def test_the_script_writes_and_prints(tmp_path, bench, capsys):
    assert run(tabulate, ["--results", str(tmp_path)]) == 0
    text = (tmp_path / "bench.txt").read_text()
    assert capsys.readouterr().out == text
    assert "Test CPU, 2 cores, GNU 12, commit 0123456789ab, changed, 100 frames" in text
    assert "ldm, 32^3, 200,000 particles, 16x1024 rays, 2 threads" in text
    kernel = next(line for line in text.splitlines() if line.startswith("clustering"))
    assert kernel.split() == ["clustering/edge:32", "0.0328", "1.00"]


def test_stages_of_ours_beside_plain(bench):
    small, _ = stages_figure(bench).axes
    assert [tick.get_text() for tick in small.get_yticklabels()] == ["particle prediction", "resampling"]
    assert [list(line.get_xdata()) for line in small.lines] == [[0.5, 0.7]] * 3


def test_growth_has_the_bound_below(bench):
    voxels, _, rays, threads = growth_figure(bench).axes
    ours, memory, cache = rays.lines
    assert list(ours.get_xdata()) == [16 * 1024, 64 * 2048] and list(ours.get_ydata()) == [2.0, 2.5]
    assert list(memory.get_ydata()) == [1.0, 1.0] and list(cache.get_ydata()) == [0.25, 0.25]
    assert list(voxels.lines[0].get_xdata()) == [32**3, 64**3]
    assert list(threads.lines[0].get_ydata()) == [2.0, 1.5]


def test_figures_are_saved(tmp_path, bench):
    assert run(draw, ["--results", str(tmp_path)]) == 0
    assert "changed" in (tmp_path / "figures" / "bench_growth.txt").read_text()


@pytest.mark.parametrize("change, message", [
    ({"schema": 2}, "schema 2: allowed: 1"),
    ({"cases": [{}]}, "not a file of `make bench`: KeyError"),
    ({"cases": []}, "lacks ldm, 32^3, 200,000 particles, 16x1024 rays, 1 thread; run `make bench`"),
])
def test_other_files_are_refused(tmp_path, document, capsys, change, message):
    write(tmp_path, document | change)
    assert run(draw, ["--results", str(tmp_path)]) == 2
    assert message in capsys.readouterr().err


def test_a_missing_file_names_the_command(tmp_path, capsys):
    assert run(tabulate, ["--results", str(tmp_path)]) == 2
    assert "bench.json: missing; run `make bench`" in capsys.readouterr().err


def test_the_report_names_the_speeds(tmp_path, document):
    assert all("make bench" in text for text in bench_numbers(Evidence(tmp_path)).values())
    write(tmp_path, document)
    found = bench_numbers(Evidence(tmp_path))
    assert set(found) == {f"bench.{key}" for key in KEYS}
    assert found["bench.frame"] == "2.00" and found["bench.over-bound"] == "2.0"
    assert found["bench.plain"] == "30" and found["bench.octomap"] == "10"
    assert found["bench.bytes"] == "23.5" and found["bench.cpu"] == "Test CPU"
    assert found["bench.large"] == "-"  # not timed here


def test_a_report_older_than_the_speeds_is_found(tmp_path, document):
    before = Evidence(tmp_path)
    assert "bench" in before.missing() and "bench" not in before.digests()
    write(tmp_path, document)
    assert "bench" not in before.missing()
    first = before.digests()["bench"]
    document["frames"] = 50
    write(tmp_path, document)
    assert before.digests()["bench"] != first
