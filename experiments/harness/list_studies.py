"""List the studies: number of trials, how long they take on the cores at hand, title.

A study that has run is estimated from the processor time of its own trials in full length (its
MANIFEST), another one from a typical trial of each of its methods (pace.toml).
"""

import argparse
import sys
from pathlib import Path

import interruption
import pace
import program
from study_folder import measured_cpu_s, read_manifest


def trial_cpu_s(results: Path, study: dict) -> tuple[float | None, str]:
    """Processor time of one trial of a study that the program lists, and the mark of its origin."""
    measured = measured_cpu_s(read_manifest(results / study["study"] / "MANIFEST"))
    if measured is not None:
        return measured, pace.MEASURED
    typical = pace.typical_cpu_s(list(study["methods"].values()), study["frames"])
    return typical, pace.UNKNOWN if typical is None else pace.TYPICAL


def add_options(parser: argparse.ArgumentParser) -> None:
    """What every estimate depends on."""
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", type=Path, default=Path("results"), help="folder of all results")
    parser.add_argument("--jobs", type=int, required=True, help="trials at a time")
    parser.add_argument("--serial", default="", metavar="NAME", help="study that runs one at a time")


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    add_options(parser)
    args = parser.parse_args()
    marks = set()
    print(f"{'study':<16}{'trials':>7}  {'time':<9}title")
    for study in program.answer([*program.command(args.program), "studies"]):
        cpu_s, mark = trial_cpu_s(args.results, study)
        jobs = 1 if study["study"] == args.serial else args.jobs
        time = "" if cpu_s is None else pace.about(cpu_s * study["trials"] / jobs)
        print(f"{study['study']:<16}{study['trials']:>7}  {time + mark:<9}{study['title']}")
        marks.add(mark)
    notes = (note for mark, note in pace.NOTES.items() if mark in marks)
    print(f"\nTimes on {args.jobs} cores.", *notes, sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(interruption.run(main))
