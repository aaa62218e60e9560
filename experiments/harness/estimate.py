"""How long the missing trials of some studies will take; `make reproduce-full` asks before it starts.

The time of a trial is that of `make studies`: measured where the study has run, else typical.
"""

import argparse
import sys

import interruption
import pace
import program
import records
from list_studies import add_options, trial_cpu_s


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", nargs="+")
    parser.add_argument("--seeds", type=int, required=True, help="replicates of each study")
    add_options(parser)
    args = parser.parse_args()
    total_s, marks = 0.0, set()
    for name in args.studies:
        study = program.answer([*program.command(args.program), "trials", name, "--seeds", str(args.seeds)])
        trials = [trial["id"] for trial in study["trials"]]
        folder = args.results / name / "records"
        missing = len(trials) - (len(records.read_all(folder, trials)) if folder.exists() else 0)
        cpu_s, mark = trial_cpu_s(args.results, study)
        wall_s = missing * (cpu_s or 0) / (1 if name == args.serial else args.jobs)
        print(f"{name:<16}{missing:>7} trials to run  {pace.about(wall_s) if cpu_s else ''}{mark}")
        total_s += wall_s
        marks.add(mark)
    notes = (note for mark, note in pace.NOTES.items() if mark in marks)
    print(f"together about {pace.about(total_s)} on {args.jobs} cores", *notes, sep="\n", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(interruption.run(main))
