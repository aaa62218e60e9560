"""Measure how fast everything is and write RESULTS/bench.json; `make bench` calls it.

The file's format is described in docs/benchmarks.md. Exit codes: 0 measured, 1 a program failed, 2 bad
input.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import os
import statistics
import subprocess
import sys
from pathlib import Path

from samples import BenchError, Configuration, Run, Samples, run_program

SCHEMA = 1
BUILD_FACTS = ("version", "commit", "compiler", "flags", "build_type")


def parse_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bench", description=__doc__)
    parser.add_argument("--program", type=Path, required=True, help="`ldm_bench`")
    parser.add_argument("--kernels", type=Path, required=True, help="`ldm_kernels`")
    parser.add_argument("--results", type=Path, default=Path("results"), help="folder of bench.json")
    parser.add_argument("--frames", type=int, help="of each configuration (default: the program's)")
    parser.add_argument("--only", action="append", default=[], metavar="PREFIX",
                        help="configurations whose name begins with it; may be repeated")
    return parser.parse_args()


def measure_kernels(program: Path, quick: bool) -> list[dict]:
    """Median times of Google Benchmark's repetitions, in turns."""
    command = [program, "--benchmark_format=json", "--benchmark_enable_random_interleaving=true",
               f"--benchmark_repetitions={1 if quick else 9}",
               f"--benchmark_min_time={0.001 if quick else 0.02}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise BenchError(f"{program}: exit code {done.returncode}", 1)
    times: dict[str, list[float]] = {}
    items: dict[str, float] = {}
    for row in json.loads(done.stdout)["benchmarks"]:
        if row["run_type"] == "iteration":
            times.setdefault(row["run_name"], []).append(row["cpu_time"])  # [ns]
            items[row["run_name"]] = row["items"]
    return [{"name": name, "items": round(items[name]), "cpu_ms": statistics.median(times[name]) / 1e6}
            for name in sorted(times)]


def case_json(configuration: Configuration, samples: Samples) -> dict:
    return configuration._asdict() | {
        "clock": configuration.clock,
        "median_ms": samples.median(configuration.clock),
        "wall_ms": samples.wall,
        "cpu_ms": samples.cpu,
        "stages_ms": {stage: statistics.median(ms) for stage, ms in samples.stages.items()},
    }


def document(run: Run, kernels: list[dict], load: list[float]) -> dict:
    """The whole of bench.json."""
    facts = run.facts
    return {
        "schema": SCHEMA,
        "build": {name: facts[name] for name in BUILD_FACTS} | {"dirty": facts["dirty"] == "true"},
        "machine": {"cpu": facts["cpu"], "cores": int(facts["cores"]),
                    "largest_cache_bytes": int(facts["largest_cache_bytes"]),
                    "load_average_before_and_after": load},
        "frames": int(facts["frames"]),
        "memory": {
            "bytes_beside_particles_per_voxel": float(facts["bytes_beside_particles_per_voxel"]),
            "blocks_in_steady_state": int(facts["blocks_in_steady_state"])},
        "cases": [case_json(*case) for case in run.samples.items()],
        "kernels": kernels,
    }


def write(file: Path, text: str) -> int:
    """The file as a whole, or not at all, and the exit code."""
    unfinished = file.with_suffix(".part")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        unfinished.write_text(text, encoding="utf-8")
        unfinished.replace(file)
    except OSError as error:
        with contextlib.suppress(OSError):
            unfinished.unlink()
        print(f"bench: {file}: {error.strerror}", file=sys.stderr)
        return 1
    return 0


def main() -> int:
    args = parse_arguments()
    try:
        load = [os.getloadavg()[0]]
        run = run_program(args.program, args.frames, args.only)
        kernels = measure_kernels(args.kernels, quick=args.frames is not None)
        load.append(os.getloadavg()[0])
    except BenchError as error:
        print(f"bench: {error}", file=sys.stderr)
        return error.code
    text = json.dumps(document(run, kernels, load), indent=1) + "\n"
    return write(args.results / "bench.json", text)


if __name__ == "__main__":
    sys.exit(main())
