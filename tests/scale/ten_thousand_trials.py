"""What a study of 10,000 trials costs beside its trials: listing, running, analysing.

`make test-scale` prints the times and fails if one is above its limit (docs/studies.md). Half a minute.
"""

import argparse
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "analysis")]

from record_files import make_record, write_records  # noqa: E402

LISTING_S = 1.0
OVERHEAD_PCT = 5.0
ANALYSIS_S = 60.0
SEEDS = 556  # table1 has 18 trials a seed
SHORT_TRIAL = ["trial", "table1", "scenario1.circular_buffer.s001", "--frames", "5"]  # 0.2 s
NOISES = [0.0, 0.01, 0.02, 0.05, 0.1]


def seconds(command: list) -> float:
    start = time.monotonic()
    subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return time.monotonic() - start


def study_s(folder: Path, jobs: int) -> float:
    """Of a study whose 10,000 trials do nothing: all that is not trial."""
    return seconds(["/usr/bin/python3", "experiments/harness/run_study.py", "nothing",
                    "--program", ROOT / "tests" / "scale" / "null_program.sh", "--results", folder,
                    "--jobs", str(jobs)])


def short_trial_s(program: str, folder: Path) -> float:
    command = [program, *SHORT_TRIAL, "-o", folder / "record.json"]
    return statistics.median(seconds(command) for _ in range(20))


def write_sweep(results: Path) -> None:
    """10,020 records in full: 4 methods, 3 scenarios, 5 points, 167 seeds."""
    write_records(results, [
        make_record(method, seed, study="sweep", scenario=f"scenario{scenario}",
                    point={"scenario.sensor.range_sigma_m": noise},
                    scores={"accuracy_pct": 99.5 - noise - 0.001 * (seed * len(method) % 17)})
        for method in ("ldm", "circular_buffer", "circular_buffer_pf", "octomap")
        for scenario in (1, 2, 3) for noise in NOISES for seed in range(1, 168)])


def analysis_s(script: str, results: Path) -> float:
    return seconds(["/usr/bin/python3", "-m", f"analysis.{script}", "--results", results,
                    "--study", "sweep"])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--jobs", type=int, required=True, help="trials at a time")
    args = parser.parse_args()
    within = True

    def show(what: str, value: float, unit: str, limit: float) -> None:
        nonlocal within
        within = within and value <= limit
        print(f"{what:<58}{value:>6.2f} {unit}  (limit {limit:.0f} {unit})", flush=True)

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        show("list 10,008 trials", seconds([args.program, "trials", "table1", "--json", "--seeds", str(SEEDS)]),
             "s", LISTING_S)
        trial = short_trial_s(args.program, folder)
        around = study_s(folder, args.jobs)
        share = 100 * around / (10000 * trial / args.jobs)
        show(f"run 10,000 trials of {trial:.2f} s, {args.jobs} at a time: {around:.0f} s more", share, "%",
             OVERHEAD_PCT)
        show("find 10,000 trials finished", study_s(folder, args.jobs), "s", LISTING_S)
        write_sweep(folder)
        show("figure and table of a sweep of 10,020 trials", analysis_s("figures.sweep_figure", folder), "s",
             ANALYSIS_S)
        show("all pairs of methods, 10,020 trials", analysis_s("tables.compare", folder), "s", ANALYSIS_S)
    return 0 if within else 1


if __name__ == "__main__":
    sys.exit(main())
