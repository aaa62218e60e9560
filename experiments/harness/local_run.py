"""Trials on the cores of this machine: one Make (trials.mk), and the progress it reports."""

import os
import resource
import selectors
import signal
import subprocess
import sys
import tempfile
from pathlib import Path

from interruption import Interrupted
from progress import Progress
from study_folder import HERE, Study


def run(study: Study, todo: list[str], jobs: int, lock_handle: int) -> None:
    """Run the trials `todo`. @raises Interrupted after everything running has been ended."""
    before = children_cpu_s()
    with tempfile.NamedTemporaryFile("w", suffix=".todo") as listing:
        listing.write("\n".join(todo))
        listing.flush()
        make = subprocess.Popen(
            make_command(study, listing.name, jobs), env=make_environment(),
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, pass_fds=[lock_handle],
            # A group of its own: the whole tree can be interrupted at once, whoever asked for it.
            process_group=0)
        try:
            follow(make, Progress(f"study {study.label}", len(todo)))
        except Interrupted:
            os.killpg(make.pid, signal.SIGINT)
            make.communicate()
            raise
    study.write_pace((children_cpu_s() - before) / len(todo))


def children_cpu_s() -> float:
    """Processor time of all descendants that have ended."""
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def make_command(study: Study, todo: str | Path, jobs: int) -> list[str]:
    """Make upon the file `todo`, one trial id a line."""
    return ["make", "-f", str(HERE / "trials.mk"), "--keep-going", f"--jobs={jobs}",
            f"PROGRAM={study.program}", f"STUDY={study.name}", f"OPTIONS={' '.join(study.options)}",
            f"RECORDS={study.records}", f"TODO={todo}"]


def make_environment() -> dict[str, str]:
    """Without what an outer Make tells an inner one."""
    return {name: value for name, value in os.environ.items()
            if name not in ("MAKEFLAGS", "MFLAGS", "MAKELEVEL")}


def follow(make: subprocess.Popen, progress: Progress) -> None:
    """Show progress until Make ends; what Make itself complains of goes to stderr at the end."""
    complaints = b""
    with selectors.DefaultSelector() as selector:
        selector.register(make.stdout, selectors.EVENT_READ)
        selector.register(make.stderr, selectors.EVENT_READ)
        while selector.get_map():
            for ready, _ in selector.select(timeout=Progress.BAR_INTERVAL_S):
                data = os.read(ready.fd, 65536)
                if not data:
                    selector.unregister(ready.fileobj)
                elif ready.fileobj is make.stderr:
                    complaints += data
                else:
                    # A line is shorter than a pipe's atomic write, so none is ever split.
                    for line in data.splitlines():
                        progress.count(failed=line == b"failed")
            progress.show()
    progress.finish()
    make.wait()
    sys.stderr.write(complaints.decode(errors="replace"))
