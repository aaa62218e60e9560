"""How long the missing trials of some studies will take; `make reproduce-full` asks before it starts.

The time of a trial is that of `make studies`: measured where the study has run, else typical.
"""

import argparse
import subprocess
import sys
import tomllib
from pathlib import Path

from list_studies import HERE, NOTES, TYPICAL, UNKNOWN, about, measured_cpu_s, typical_cpu_s


def missing_trials(program: str, results: Path, study: str, seeds: int) -> int:
    """Trials without a record. @raises CalledProcessError after the program has said why."""
    listing = subprocess.run([program, "trials", study, "--seeds", str(seeds)],
                             stdout=subprocess.PIPE, text=True, check=True)
    records = results / study / "records"
    return sum(not (records / f"{trial}.json").exists() for trial in listing.stdout.split())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="+")
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", type=Path, default=Path("results"), help="folder of all results")
    parser.add_argument("--seeds", type=int, required=True, help="replicates of each study")
    parser.add_argument("--jobs", type=int, required=True, help="trials at a time")
    parser.add_argument("--serial", default="", metavar="NAME", help="study that runs one at a time")
    args = parser.parse_args()
    pace = tomllib.loads((HERE / "pace.toml").read_text(encoding="utf-8"))
    total_s, marks = 0.0, set()
    for name in args.studies:
        try:
            missing = missing_trials(args.program, args.results, name, args.seeds)
        except subprocess.CalledProcessError as error:
            return error.returncode
        study = tomllib.loads((HERE.parent / "studies" / f"{name}.toml").read_text(encoding="utf-8"))
        measured = measured_cpu_s(args.results, name)
        cpu_s = measured or typical_cpu_s(study, pace)
        mark = "" if measured else UNKNOWN if cpu_s is None else TYPICAL
        wall_s = missing * (cpu_s or 0) / (1 if name == args.serial else args.jobs)
        print(f"{name:<16}{missing:>7} trials to run  {about(wall_s) if cpu_s else ''}{mark}")
        total_s += wall_s
        marks.add(mark)
    print(f"together about {about(total_s)} on {args.jobs} cores",
          *(NOTES[mark] for mark in NOTES if mark in marks), sep="\n", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
