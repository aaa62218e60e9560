"""List the studies: number of trials, how long they take on the cores at hand, title.

A study that has run is estimated from the processor time of its own trials in full length (its
MANIFEST), another one from a typical trial of each of its methods (pace.toml).
"""

import argparse
import re
import subprocess
import sys
import tomllib
from pathlib import Path

from study_folder import HERE, read_manifest

MEASURED, TYPICAL, UNKNOWN = "", "*", "?"
NOTES = {
    TYPICAL: "* from a typical trial of each method with its default parameters; the study has not run "
             "here yet",
    UNKNOWN: "? of a method not timed yet; `make trials STUDY=name SEEDS=1` is a measurement",
}


def measured_cpu_s(results: Path, name: str) -> float | None:
    """Of one trial, from the last run that left it."""
    pace = read_manifest(results / name / "MANIFEST").get("cpu_s_per_trial")
    return float(pace) if pace else None


def typical_cpu_s(study: dict, pace: dict) -> float | None:
    """Of one trial, averaged over the methods and variants; None if one of them is unknown."""
    methods = study["methods"] + [variant["method"] for variant in study.get("variant", [])]
    if not set(methods) <= set(pace["frame_s"]):
        return None
    frame_s = sum(pace["frame_s"][method] for method in methods) / len(methods)
    return pace["start_s"] + study["frames"] * frame_s


def about(seconds: float) -> str:
    """No more digits than an estimate deserves."""
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", type=Path, default=Path("results"), help="folder of all results")
    parser.add_argument("--jobs", type=int, required=True, help="trials at a time")
    parser.add_argument("--serial", default="", metavar="NAME", help="study that runs one at a time")
    args = parser.parse_args()
    listing = subprocess.run([args.program, "studies"], stdout=subprocess.PIPE, text=True, check=False)
    if listing.returncode != 0:
        return listing.returncode  # the program has said why
    pace = tomllib.loads((HERE / "pace.toml").read_text(encoding="utf-8"))
    marks = set()
    rows = []
    for line in listing.stdout.splitlines():
        name, trials, title = re.split(r"  +", line, maxsplit=2)
        study = tomllib.loads((HERE.parent / "studies" / f"{name}.toml").read_text(encoding="utf-8"))
        cpu_s = measured_cpu_s(args.results, name)
        mark = MEASURED
        if cpu_s is None:
            cpu_s = typical_cpu_s(study, pace)
            mark = UNKNOWN if cpu_s is None else TYPICAL
        jobs = 1 if name == args.serial else args.jobs
        time = "" if cpu_s is None else about(cpu_s * int(trials) / jobs)
        rows.append((name, trials, time + mark, title))
        marks.add(mark)
    print(f"{'study':<16}{'trials':>7}  {'time':<9}title")
    for name, trials, time, title in rows:
        print(f"{name:<16}{trials:>7}  {time:<9}{title}")
    print(f"\nTimes on {args.jobs} cores.", *(NOTES[mark] for mark in NOTES if mark in marks), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
