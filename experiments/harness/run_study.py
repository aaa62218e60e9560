"""Run the missing trials of one study; `make study` calls it and documents its options.

Trials run on this machine or in the tasks of a Slurm job; this script says which, keeps results of
different programs and files apart, and tells what failed. A method that the study lacks (--methods) has
its trials in a folder of its own, STUDY+METHOD: held against the study's, they leave its records alone.
Exit codes: 0 all trials good, 1 some failed or the records are stale, 2 bad input, 130 interrupted.
"""

import argparse
import os
import re
import shlex
import sys

import interruption
import pace
import slurm_run
import trial_pool
from records import OtherFiles, Record
from study_folder import Study, measured_cpu_s

LISTED_FAILURES = 20


def parse_arguments() -> argparse.Namespace:
    def positive(text: str) -> int:
        if not re.fullmatch(r"[1-9][0-9]{0,8}", text):
            raise argparse.ArgumentTypeError(f"{text!r}: a whole number of at least 1 is needed")
        return int(text)

    parser = argparse.ArgumentParser(prog="study", description=__doc__)
    parser.add_argument("study", help="name of the study, as `make studies` lists it, or its .toml file")
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", default="results", help="folder of all results")
    parser.add_argument("--seeds", type=positive, help="replicates, instead of the study's number")
    parser.add_argument("--frames", type=positive, help="frames, instead of the scenarios' number")
    parser.add_argument("--jobs", type=positive, default=os.cpu_count(), help="trials at a time")
    parser.add_argument("--trial-seconds", type=positive, metavar="N",
                        help="end a trial after so long (default: a multiple of its estimate)")
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


def check_manifest(study: Study, good: dict[str, Record], missing: int) -> None:
    """Write the manifest of a study that begins; refuse to mix records of different programs."""
    key = study.key()
    if not good:
        study.write_manifest(key)
        return
    made_by = study.made_by()
    if made_by.get("key") == key:
        if others := study.other_files(good):
            trial, file = next(iter(others.items()))
            sys.exit(f"study {study.label}: {len(others)} results were made from other files than the study: "
                     f"{trial} from another {file}; FRESH=1 runs all again; nothing was run")
        return
    origin = f"commit {made_by['commit']}" if "commit" in made_by else "an unknown program"
    stale = (f"study {study.label}: {len(good)} results are stale (made by {origin}; program, study "
             "or scenarios have changed since)")
    if missing:
        sys.exit(f"{stale} and {missing} are missing: FRESH=1 runs all again; nothing was run")
    print(f"{stale}, using them; FRESH=1 runs them again", file=sys.stderr)


def report(study: Study, found: dict[str, Record], errors: dict[str, str]) -> int:
    """Print the outcome; the exit code. `errors` are of trials that could leave no record."""
    failed = {trial: errors.get(trial, "no record") if trial not in found else found[trial].error
              for trial in study.trials if trial not in found or found[trial].error is not None}
    total = len(study.trials)
    print(f"study {study.label}: {total - len(failed)} of {total} trials good, records in {study.records}")
    for trial in list(failed)[:LISTED_FAILURES]:
        command = trial_pool.shown(study.work().command_of(trial))
        print(f"FAILED {trial}: {failed[trial]}\n  {command}", file=sys.stderr)
    if len(failed) > LISTED_FAILURES:
        print(f"... and {len(failed) - LISTED_FAILURES} more", file=sys.stderr)
    if failed:
        print(f"study {study.label}: {len(failed)} of {total} trials failed; "
              "the same command tries them again", file=sys.stderr)
    return 1 if failed else 0


def tell_of_broken_records(study: Study, found: dict[str, Record]) -> None:
    for trial, record in found.items():
        if not record.is_whole:
            print(f"study {study.label}: {trial} is run again: {record.error}", file=sys.stderr)


def complete(study: Study, args: argparse.Namespace) -> int:
    """Run what is missing of one study; the exit code."""
    # Beside other methods, what is not stale is what they are held against.
    fresh = args.fresh and (not args.methods or study.made_by().get("key") != study.key())
    lock_handle = study.lock()
    slurm_run.refuse_running_job(study)
    study.refuse_namesake()
    study.prepare(fresh)
    found = study.found()
    good = {trial: record for trial, record in found.items() if record.error is None}
    todo = [trial for trial in study.trials if trial not in good]
    check_manifest(study, good, len(todo))
    if not todo:
        return report(study, found, {})
    tell_of_broken_records(study, found)
    study.remove_records(todo)  # failed before: each is tried again
    errors = run(study, todo, args, lock_handle)
    found = study.found()
    if others := study.other_files(found):
        study.remove_records(list(others))
        raise OtherFiles(f"{next(iter(others.values()))} has changed while the study ran; the trials that saw "
                         "the change have no record")
    return report(study, found, errors)


def run(study: Study, todo: list[str], args: argparse.Namespace, lock_handle: int) -> dict[str, str]:
    """Run the trials `todo`; why those failed that could leave no record."""
    where = f"in {args.shards} shards over Slurm" if args.shards else f"{args.jobs} at a time"
    cpu_s = measured_cpu_s(study.made_by())
    estimate = f", about {pace.about(cpu_s * len(todo) / args.jobs)}" if cpu_s and not args.shards else ""
    print(f"study {study.label}: {len(study.trials)} trials, {len(todo)} to run, {where}{estimate}",
          file=sys.stderr)
    if args.shards:
        return slurm_run.run(study, todo, slurm_run.Request(args.shards, args.shard_cpus, args.sbatch_flags))
    import local_run  # with tqdm, which only those who wait for trials need

    return local_run.run(study, todo, args.jobs, lock_handle)


def main() -> int:
    args = parse_arguments()
    label = args.study
    interruption.raise_when_interrupted()
    try:
        studies = [Study(args)]
        studies += [Study(args, method) for method in args.methods if method not in studies[0].methods]
        code = 0
        for study in studies:
            label = study.label
            code = max(code, complete(study, args))
        return code
    except interruption.Interrupted:
        print(f"\nstudy {label}: stopped; the same command continues it", file=sys.stderr)
        return interruption.EXIT_CODE
    except OtherFiles as error:
        sys.exit(f"study {label}: stopped: {error}")
    except OSError as error:
        sys.exit(f"study {label}: {error.filename or args.results}: {error.strerror}")


if __name__ == "__main__":
    sys.exit(main())
