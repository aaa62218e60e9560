"""Run the missing trials of one study; `make study` calls it and documents its options.

Make runs the trials (trials.mk), on this machine or in the tasks of a Slurm job; this script says
which, keeps results of different programs apart, and tells what failed. A method that the study
lacks (--methods) has its trials in a folder of its own, STUDY+METHOD: held against the study's, they
leave its records alone.
Exit codes: 0 all trials good, 1 some failed or the records are stale, 2 bad input, 130 interrupted.
"""

import argparse
import os
import re
import shlex
import sys

import interruption
import local_run
import slurm_run
from study_folder import Study

LISTED_FAILURES = 20


def parse_arguments() -> argparse.Namespace:
    def positive(text: str) -> int:
        if not re.fullmatch(r"[1-9][0-9]{0,8}", text):
            raise argparse.ArgumentTypeError(f"{text!r}: a whole number of at least 1 is needed")
        return int(text)

    parser = argparse.ArgumentParser(prog="study", description=__doc__)
    parser.add_argument("study", help="name of the study, as `make studies` lists it")
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", default="results", help="folder of all results")
    parser.add_argument("--seeds", type=positive, help="replicates, instead of the study's number")
    parser.add_argument("--frames", type=positive, help="frames, instead of the scenarios' number")
    parser.add_argument("--jobs", type=positive, default=os.cpu_count(), help="trials at a time")
    parser.add_argument("--serial", action="store_true",
                        help="one trial at a time, and say in the records that timings are valid")
    parser.add_argument("--fresh", action="store_true",
                        help="run all trials again; with --methods, those that are stale")
    parser.add_argument("--methods", type=lambda text: text.replace(",", " ").split(), default=[],
                        metavar="NAMES", help="methods to run beside those of the study")
    parser.add_argument("--plugin", action="append", default=[], metavar="FILE",
                        help="shared object with more methods; may be repeated")
    parser.add_argument("--shards", type=positive, help="run over Slurm, as an array of so many tasks")
    parser.add_argument("--shard-cpus", type=positive, default=1, help="trials at a time in a task")
    parser.add_argument("--sbatch-flags", type=shlex.split, default=[], metavar="FLAGS",
                        help="more options of sbatch")
    args = parser.parse_args()
    if args.serial and args.shards:
        parser.error("times count only where trials run one after the other: no Slurm")
    if args.serial:
        args.jobs = 1
    return args


def check_manifest(study: Study, good: set[str], missing: int) -> None:
    """Write the manifest of a study that begins; refuse to mix records of different programs."""
    key = study.key()
    if not good:
        study.write_manifest(key)
        return
    made_by = study.made_by()
    if made_by.get("key") == key:
        return
    origin = f"commit {made_by['commit']}" if made_by else "an unknown program"
    stale = (f"study {study.label}: {len(good)} results are stale (made by {origin}; program, study "
             "or scenarios have changed since)")
    if missing:
        sys.exit(f"{stale} and {missing} are missing: FRESH=1 runs all again; nothing was run")
    print(f"{stale}, using them; FRESH=1 runs them again", file=sys.stderr)


def report(study: Study, trials: list[str]) -> int:
    """Print the outcome; the exit code."""
    good = study.good_records()
    failed = [trial for trial in trials if trial not in good]
    print(f"study {study.label}: {len(trials) - len(failed)} of {len(trials)} trials good, "
          f"records in {study.records}")
    for trial in failed[:LISTED_FAILURES]:
        print(f"FAILED {trial}: {study.error(trial)}\n  {study.command(trial)}", file=sys.stderr)
    if len(failed) > LISTED_FAILURES:
        print(f"... and {len(failed) - LISTED_FAILURES} more", file=sys.stderr)
    if failed:
        print(f"study {study.label}: {len(failed)} of {len(trials)} trials failed; "
              "the same command tries them again", file=sys.stderr)
    return 1 if failed else 0


def complete(study: Study, args: argparse.Namespace, fresh: bool) -> int:
    """Run what is missing of one study; the exit code."""
    lock_handle = study.lock()
    slurm_run.refuse_running_job(study)
    study.prepare(fresh)
    good = study.good_records()
    todo = [trial for trial in study.trials if trial not in good]
    check_manifest(study, good, len(todo))
    if not todo:
        return report(study, study.trials)
    study.remove_records(todo)  # failed before: each is tried again
    where = f"in {args.shards} shards over Slurm" if args.shards else f"{args.jobs} at a time"
    print(f"study {study.label}: {len(study.trials)} trials, {len(todo)} to run, {where}", file=sys.stderr)
    try:
        interruption.raise_when_interrupted()
        if args.shards:
            slurm_run.run(study, todo, slurm_run.Request(args.shards, args.shard_cpus, args.sbatch_flags))
        else:
            local_run.run(study, todo, args.jobs, lock_handle)
    except interruption.Interrupted:
        print(f"\nstudy {study.label}: stopped; the same command continues it", file=sys.stderr)
        return interruption.EXIT_CODE
    return report(study, study.trials)


def main() -> int:
    args = parse_arguments()
    studies = [Study(args)]
    studies += [Study(args, method) for method in args.methods if method not in studies[0].methods()]
    code = 0
    for study in studies:
        # Beside other methods, what is not stale is what they are held against.
        fresh = args.fresh and (not args.methods or study.made_by().get("key") != study.key())
        code = max(code, complete(study, args, fresh))
        if code == interruption.EXIT_CODE:
            break
    return code


if __name__ == "__main__":
    sys.exit(main())
