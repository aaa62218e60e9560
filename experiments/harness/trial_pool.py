"""Trials as processes, some at a time: what became of each of them.

The program writes every record, that of a trial which crashed or hung, too: a second call tells it how
the trial ended. A trial that was asked to end (SIGHUP, SIGINT, SIGTERM) has not failed: it has no record.
"""

import concurrent.futures
import dataclasses
import os
import queue
import shlex
import signal
import subprocess
import threading
import time
from collections.abc import Callable
from pathlib import Path

import records

TICK_S = 0.2  # between two looks at the clock
GRACE_S = 10.0  # between asking a trial to end and ending it
FAILURE_S = 60.0  # for the record of a failure: nothing is run for it
ASKED_TO_END = {signal.SIGHUP, signal.SIGINT, signal.SIGTERM}


@dataclasses.dataclass(frozen=True)
class Work:
    """What it takes to run the trials of a study."""

    command: list[str]  # up to the id of the trial
    options: list[str]  # after it
    records: str  # folder
    files: dict[str, str]  # path -> hash of what the study is made of
    limit_s: float  # of one trial

    def command_of(self, trial: str) -> list[str]:
        """The command line of one trial."""
        return [*self.command, trial, *self.options, "-o", os.path.join(self.records, f"{trial}.json")]


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What became of a trial; `error` is None if its record is good."""

    trial: str
    error: str | None


@dataclasses.dataclass
class _Running:
    process: subprocess.Popen
    deadline: float
    late: bool = False

    def end(self, number: signal.Signals) -> None:
        try:
            os.killpg(self.process.pid, number)
        except ProcessLookupError:
            pass  # it has ended by itself


class Pool:
    """Runs trials, `jobs` at a time, each in a process group of its own."""

    def __init__(self, work: Work, jobs: int, lock_handle: int | None = None):
        """Trials inherit `lock_handle`: whoever outlives this program still keeps others out."""
        self._work = work
        self._jobs = jobs
        self._handles = [] if lock_handle is None else [lock_handle]
        self._running: dict[str, _Running] = {}
        self._guard = threading.Lock()  # of the two members around it
        self._stopping = False

    def run(self, trials: list[str], done: Callable[[Outcome], None], tick: Callable[[], None]) -> None:
        """Call `done` for each trial that ends, and `tick` now and then, both in this thread.

        Whatever is raised here, or by them, ends all trials first.
        """
        ended: queue.SimpleQueue = queue.SimpleQueue()
        with concurrent.futures.ThreadPoolExecutor(self._jobs) as threads:
            try:
                for trial in trials:
                    threads.submit(lambda trial: ended.put(self._attempt(trial)), trial)
                missing = len(trials)
                while missing:
                    try:
                        outcome = ended.get(timeout=TICK_S)
                    except queue.Empty:
                        self._end_late_ones()
                        tick()
                        continue
                    if isinstance(outcome, Exception):
                        raise outcome
                    missing -= 1
                    done(outcome)
            except BaseException:
                threads.shutdown(wait=False, cancel_futures=True)
                self._stop()
                raise

    def _attempt(self, trial: str) -> Outcome | Exception:
        try:
            return self._run(trial)
        except Exception as error:  # of this program: the main thread raises it
            return error

    def _run(self, trial: str) -> Outcome:
        with open(os.memfd_create("output"), "w+b") as output:
            with self._guard:
                if self._stopping:
                    return Outcome(trial, "not run")
                process = subprocess.Popen(
                    self._work.command_of(trial), stdin=subprocess.DEVNULL, stdout=output, stderr=output,
                    pass_fds=self._handles, process_group=0)
                running = self._running[trial] = _Running(process, time.monotonic() + self._work.limit_s)
            process.wait()
            with self._guard:
                del self._running[trial]
            running.end(signal.SIGKILL)  # what it has left behind
            if running.late:
                return self._failed(trial, f"took longer than {self._work.limit_s:g} s; TRIAL_SECONDS=n "
                                           "allows more")
            return self._judged(trial, process.returncode, output)

    def _judged(self, trial: str, exit_code: int, output) -> Outcome:
        if exit_code == 0 or exit_code == 1:
            record = records.read(Path(self._work.records), trial)
            if record.error is None:
                self._check_files(record)
            if record.is_whole:
                return Outcome(trial, record.error)
        elif -exit_code in ASKED_TO_END:
            return Outcome(trial, f"ended by {signal.Signals(-exit_code).name}, no record")
        return self._failed(trial, reason(exit_code, last_line(output)))

    def _failed(self, trial: str, error: str) -> Outcome:
        """Let the program write a record that says so."""
        for part in Path(self._work.records).glob(f".{trial}.*"):
            part.unlink(missing_ok=True)
        command = [*self._work.command_of(trial), "--failed", error]
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.PIPE, timeout=FAILURE_S, check=False)
        except subprocess.TimeoutExpired:
            return Outcome(trial, f"{error}; no record: the program hangs")
        if done.returncode != 0:
            lines = done.stderr.decode(errors="replace").strip().splitlines()
            why = reason(done.returncode, lines[-1] if lines else "")
            return Outcome(trial, error if why == error else f"{error}; no record: {why}")
        return Outcome(trial, error)

    def _check_files(self, record: records.Record) -> None:
        for path in record.other_files(self._work.files):
            os.unlink(record.file)
            raise records.OtherFiles(f"{path} has changed while the study ran; the trials that saw the "
                                     "change have no record")

    def _end_late_ones(self) -> None:
        now = time.monotonic()
        with self._guard:
            for running in self._running.values():
                if now > running.deadline and not running.late:
                    running.late = True
                    running.end(signal.SIGKILL)

    def _stop(self) -> None:
        with self._guard:
            self._stopping = True
        deadline = time.monotonic() + GRACE_S
        number = signal.SIGTERM
        while True:
            with self._guard:
                left = list(self._running.values())
            if not left:
                return
            for running in left:
                running.end(number)
            time.sleep(0.02)
            if time.monotonic() > deadline:
                number = signal.SIGKILL


def reason(exit_code: int, line: str) -> str:
    """Why a trial ended without a good record; `exit_code` as of subprocess, `line` its last word."""
    if exit_code < 0:
        how = f"killed by {signal.Signals(-exit_code).name}"
    elif exit_code == 0:
        how = "ended well but left no record"
    else:
        how = f"exit code {exit_code}"
    return f"{how}: {line}" if line else how


def last_line(output) -> str:
    """Of what a trial printed."""
    output.seek(max(0, output.seek(0, os.SEEK_END) - 4096))
    lines = output.read().decode(errors="replace").strip().splitlines()
    return lines[-1] if lines else ""


def shown(command: list[str]) -> str:
    """A command line for a shell."""
    return shlex.join(command)
