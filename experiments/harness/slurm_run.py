"""Trials on the nodes of a Slurm cluster: an array job, each of whose tasks runs its shard (shard.py).

The records go straight to the study's folder, which all nodes must share. A task whose node is lost
is queued again (--requeue), and finds what is finished already.
"""

import dataclasses
import json
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

import records
from interruption import Interrupted
from progress import Progress
from study_folder import HERE, Study

POLL_S = 2.0  # of the records
QUEUE_POLL_S = 10.0  # of the queue: its controller serves others, too
CANCEL_S = 60.0  # twice Slurm's usual KillWait


@dataclasses.dataclass(frozen=True)
class Request:
    """What to ask of Slurm."""

    shards: int
    cpus: int  # of a shard, and so trials at a time
    flags: list[str]  # more options of sbatch


def refuse_running_job(study: Study) -> None:
    """Stop if the array of an earlier run, killed before it could cancel it, is still queued."""
    job = job_file(study)
    if not job.exists():
        return
    number = job.read_text(encoding="utf-8").strip()
    if shutil.which("squeue") is None:
        sys.exit(f"study {study.label}: Slurm's job {number} may still write to {study.folder}; where "
                 f"squeue knows of it no more, delete {job}")
    if is_queued(number):
        sys.exit(f"study {study.label}: Slurm's job {number} is still writing to {study.folder}; "
                 f"'scancel {number}' ends it")
    job.unlink()


def run(study: Study, todo: list[str], request: Request) -> dict[str, str]:
    """Run the trials `todo`; where to look for those without a record.

    @raises Interrupted after the job has been cancelled.
    """
    write_shards(study, todo, request.shards)
    folder = study.folder / "slurm"
    task = shlex.join([sys.executable, str(HERE / "shard.py"), f"--jobs={request.cpus}", f"{folder}/shard-"])
    request = dataclasses.replace(request, shards=min(request.shards, len(todo)))
    number = submit(f"study {study.label}", folder, f'{task}"$SLURM_ARRAY_TASK_ID".json', request)
    job_file(study).write_text(number + "\n", encoding="utf-8")
    try:
        return follow(study, todo, number)
    except Interrupted:
        cancel(number)
        raise
    finally:
        if not is_queued(number):
            job_file(study).unlink()


def job_file(study: Study) -> Path:
    return study.folder / "slurm" / "job"


def write_shards(study: Study, todo: list[str], shards: int) -> None:
    """`slurm/shard-K.json`: neighbours in the list, alike in cost, go to different shards."""
    folder = study.folder / "slurm"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    work = dataclasses.asdict(study.work())
    for shard in range(min(shards, len(todo))):
        share = json.dumps({"work": work, "trials": todo[shard::shards]}, indent=1)
        (folder / f"shard-{shard + 1}.json").write_text(share, encoding="utf-8")


def submit(label: str, folder: Path, command: str, request: Request) -> str:
    """Number of the array job whose tasks run `command`, a shell's; their logs go to `folder`/shard-K.log."""
    sbatch = ["sbatch", "--parsable", "--requeue", f"--job-name={label.replace(' ', '-')}",
              f"--array=1-{request.shards}", f"--cpus-per-task={request.cpus}", "--ntasks=1",
              f"--output={folder}/shard-%a.log", "--open-mode=append", *request.flags,
              "--wrap", f"exec {command}"]
    try:
        done = subprocess.run(sbatch, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        sys.exit(f"{label}: sbatch is not installed here: SLURM=1 needs a machine that submits "
                 "to Slurm; without it the trials run on this one")
    if done.returncode != 0:
        sys.exit(f"{label}: sbatch: {done.stderr.strip()}")
    return done.stdout.strip().partition(";")[0]


def is_queued(number: str) -> bool:
    """Whether a task of the job waits, runs or ends; True, too, while the controller is silent."""
    queue = subprocess.run(["squeue", "--noheader", "--jobs", number, "--format=%t"],
                           capture_output=True, text=True, check=False)
    if queue.returncode != 0:
        return "Invalid job id" not in queue.stderr  # so it calls one it has forgotten
    return bool(queue.stdout.split())


def cancel(number: str) -> None:
    """End the job and wait for it, as long as Slurm lets its tasks live."""
    subprocess.run(["scancel", number], check=False)
    deadline = time.monotonic() + CANCEL_S
    while is_queued(number) and time.monotonic() < deadline:
        time.sleep(POLL_S)


def follow(study: Study, todo: list[str], number: str) -> dict[str, str]:
    """Show progress until the job has left the queue; the log of each trial without a record."""
    folder = study.folder / "slurm"
    print(f"study {study.label}: Slurm's job {number}, logs in {folder}", file=sys.stderr)
    missing = dict.fromkeys(todo)  # in their order
    asked = time.monotonic()
    with Progress(f"study {study.label}", len(todo)) as progress:
        while True:
            time.sleep(POLL_S)
            count_finished(study, missing, progress)
            progress.show()
            # When all is there, the last tasks are about to leave.
            if not missing or time.monotonic() - asked > QUEUE_POLL_S:
                asked = time.monotonic()
                if not is_queued(number):
                    break
        count_finished(study, missing, progress)
    if missing:
        print(f"study {study.label}: {len(missing)} trials left no record; out of time? The logs in "
              f"{folder} and `sacct --jobs={number}` tell", file=sys.stderr)
    shards = len(list(folder.glob("shard-*.json")))
    return {trial: f"no record; its log is {folder}/shard-{todo.index(trial) % shards + 1}.log"
            for trial in missing}


def count_finished(study: Study, missing: dict[str, None], progress: Progress) -> None:
    """Take from `missing` what has a record now."""
    for trial, record in records.read_all(study.records, list(missing)).items():
        del missing[trial]
        progress.count(failed=record.error is not None)
