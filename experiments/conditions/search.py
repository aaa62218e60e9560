"""One stage of the search over conditions; `make conditions` runs them in turn.

Reads   RESULTS/conditions/STAGE_BEFORE/ranking.csv and conditions.csv, but for the first stage
Writes  RESULTS/conditions/STAGE/: conditions.csv, and a folder for each condition (trials.py)

A good record is not made again; trials that failed are tried again. Exit codes: 0 all trials good, 1 some
failed or a file cannot be written, 2 bad input, 130 interrupted.
"""

from __future__ import annotations

import argparse
import csv
import os
import re
import shlex
import sys
import time
import tomllib
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "harness"))

import records
import slurm_run
from design import offspring, read_conditions, space_filling, write_conditions
from interruption import Interrupted, raise_when_interrupted
from progress import Progress
from trials import Batch, Trial, batches, run, trials, write_studies

STAGES = Path(__file__).with_name("stages.toml")


def stages() -> list[dict]:
    """In the order in which they run."""
    with STAGES.open("rb") as stream:
        return tomllib.load(stream)["stage"]


def conditions_of(stage: dict, before: Path | None) -> dict[str, dict]:
    """Name -> condition of a stage; `before` is the folder of the stage before it."""
    if before is None:
        found = space_filling(stage["conditions"])
        return {f"c{k:04d}": condition for k, condition in enumerate(found, start=1)}
    if not (before / "ranking.csv").exists():
        sys.exit(f"search: {before / 'ranking.csv'}: is missing; rank the stage before first")
    known = read_conditions(before / "conditions.csv")
    with (before / "ranking.csv").open(newline="", encoding="utf-8") as stream:
        ranked = [row["condition"] for row in csv.DictReader(stream)]
    kept = {name: known[name] for name in ranked[: stage["keep"]]}
    if "hints" in stage:
        kept |= read_conditions(STAGES.with_name(stage["hints"]))
    born = offspring(list(kept.values()), stage.get("offspring", 0))
    return kept | {f"{stage['name']}-{k:03d}": child for k, child in enumerate(born, start=1)}


def prepare(stage: dict, folder: Path, before: Path | None, frames: float) -> list[Trial]:
    """Write the files of a stage, or find them as they are; all its trials, world by world."""
    lengths = {name: max(1, round(count * frames)) for name, count in stage["frames"].items()}
    table = folder / "conditions.csv"
    if not table.exists():
        write_conditions(table, conditions_of(stage, before))
    found = read_conditions(table)
    for name, condition in found.items():
        if not (folder / name / "outdoor2.toml").exists():
            write_studies(folder / name, condition, lengths)
    first, last = stage["replicates"]
    return [trial for replicate in range(first, last + 1) for name in found
            for trial in trials(folder / name, lengths, [replicate])]


def share_of(text: str) -> tuple[int, int]:
    """K/N, as a command-line type."""
    found = re.fullmatch(r"([1-9]\d*)/([1-9]\d*)", text)
    if not found or int(found[1]) > int(found[2]):
        raise argparse.ArgumentTypeError(f"{text!r}: allowed: K/N with 1 <= K <= N")
    return int(found[1]), int(found[2])


def parse_arguments() -> argparse.Namespace:
    def positive(text: str) -> int:
        if not re.fullmatch(r"[1-9][0-9]{0,6}", text):
            raise argparse.ArgumentTypeError(f"{text!r}: a whole number of at least 1 is needed")
        return int(text)

    def factor(text: str) -> float:
        if not re.fullmatch(r"0?\.\d+|1(\.0*)?", text) or float(text) == 0:
            raise argparse.ArgumentTypeError(f"{text!r}: allowed: above 0, at most 1")
        return float(text)

    parser = argparse.ArgumentParser(prog="search", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stage", choices=[stage["name"] for stage in stages()])
    parser.add_argument("--program", required=True, help="the `ldm` program")
    parser.add_argument("--results", type=Path, default=Path("results"))
    parser.add_argument("--jobs", type=positive, default=os.cpu_count(), help="batches at a time")
    parser.add_argument("--share", type=share_of, default=(1, 1), metavar="K/N",
                        help="only every N-th batch, from the K-th: for many machines")
    parser.add_argument("--shards", type=positive, help="run so many shares as an array job of Slurm")
    parser.add_argument("--shard-cpus", type=positive, default=1, help="batches at a time in each")
    parser.add_argument("--sbatch-flags", type=shlex.split, default=[], help="more options of sbatch")
    # A smaller search; its results are not those of the full one.
    parser.add_argument("--conditions", type=positive, help="of the first stage, or kept, instead of its number")
    parser.add_argument("--offspring", type=int, help="instead of the stage's number")
    parser.add_argument("--seeds", type=positive, help="replicates, instead of the stage's number")
    parser.add_argument("--frames", type=factor, default=1, help="factor of the lengths of all trials")
    return parser.parse_args()


def shortened(stage: dict, args: argparse.Namespace) -> dict:
    """The stage as the command line wants it."""
    first, last = stage["replicates"]
    changed = dict(stage, replicates=[first, first + args.seeds - 1 if args.seeds else last])
    if args.conditions:
        changed["keep" if "keep" in stage else "conditions"] = args.conditions
    if args.offspring is not None:
        changed["offspring"] = args.offspring
    return changed


def main() -> int:
    args = parse_arguments()
    try:
        return complete(args)
    except OSError as error:
        print(f"{args.stage}: {error.filename or args.results}: {error.strerror}", file=sys.stderr)
        return 1


def complete(args: argparse.Namespace) -> int:
    """Run what is missing of the stage; the exit code."""
    names = [stage["name"] for stage in stages()]
    place = names.index(args.stage)
    stage = shortened(stages()[place], args)
    root = args.results / "conditions"
    folder = (root / args.stage).resolve()
    found = prepare(stage, folder, root / names[place - 1] if place else None, args.frames)
    share, shares = args.share
    mine = [trial for batch in batches(found)[share - 1::shares] for trial in batch.trials]
    missing = [trial for trial in mine if trial.fault()]
    for trial in missing:
        records.remove(trial.record.parent, trial.id)
    waiting = batches(missing)
    print(f"{args.stage}: {len(mine)} trials, {len(missing)} to run in {len(waiting)} batches",
          file=sys.stderr)
    raise_when_interrupted()
    try:
        if args.shards:
            failed = over_slurm(args, folder, missing)
        else:
            failed = on_this_machine(args, waiting)
    except Interrupted:
        print(f"{args.stage}: stopped; the same command continues it", file=sys.stderr)
        return 130
    return 1 if failed else 0


def on_this_machine(args: argparse.Namespace, waiting: list[Batch]) -> int:
    """Run batches; how many failed."""
    with Progress(args.stage, len(waiting)) as progress:
        def done(batch: Batch, complaint: str) -> None:
            progress.count(failed=bool(complaint))
            progress.show()
            if complaint:
                print(f"\nFAILED {batch.trials[0].study.parent.name}: {complaint}", file=sys.stderr)

        return run(waiting, args.program, args.jobs, done)


def over_slurm(args: argparse.Namespace, folder: Path, missing: list[Trial]) -> int:
    """Run the missing trials as an array job, each task of which is this script with a share; how many
    failed or are missing after it."""
    if not missing:
        return 0
    logs = folder / "slurm"
    logs.mkdir(exist_ok=True)
    command = shlex.join([sys.executable, str(Path(__file__).resolve()), args.stage,
                          f"--program={Path(args.program).resolve()}", f"--results={args.results.resolve()}",
                          f"--jobs={args.shard_cpus}", *same_stage(args)])
    request = slurm_run.Request(args.shards, args.shard_cpus, args.sbatch_flags)
    number = slurm_run.submit(f"conditions {args.stage}", logs,
                              f'{command} --share="$SLURM_ARRAY_TASK_ID"/{args.shards}', request)
    print(f"{args.stage}: Slurm's job {number}, logs in {logs}", file=sys.stderr)
    failed = 0
    try:
        with Progress(args.stage, len(missing)) as progress:
            while True:
                queued = slurm_run.is_queued(number)
                for trial in [trial for trial in missing if trial.record.exists()]:
                    missing.remove(trial)
                    fault = trial.fault()
                    failed += bool(fault)
                    progress.count(failed=bool(fault))
                    if fault:
                        print(f"\nFAILED {trial.study.parent.name} {trial.id}: {fault}", file=sys.stderr)
                progress.show()
                if not queued:
                    if missing:
                        print(f"\n{args.stage}: {len(missing)} trials left no record: {logs}", file=sys.stderr)
                    return failed + len(missing)
                time.sleep(slurm_run.POLL_S)
    except Interrupted:
        slurm_run.cancel(number)
        raise


def same_stage(args: argparse.Namespace) -> list[str]:
    """The options that shape the stage."""
    found = {"conditions": args.conditions, "offspring": args.offspring, "seeds": args.seeds,
             "frames": args.frames}
    return [f"--{name}={value}" for name, value in found.items() if value is not None]


if __name__ == "__main__":
    sys.exit(main())
