"""Run `ldm_bench` and read what it prints: facts, and the samples of each configuration."""

from __future__ import annotations

import csv
import statistics
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

FORMAT = "1"


class BenchError(Exception):
    """One line for the user; `code` is what the script ends with."""

    def __init__(self, message: str, code: int):
        super().__init__(message)
        self.code = code


class Configuration(NamedTuple):
    """What was measured, as in configuration.h; 0 stands for none."""

    subject: str
    edge: int
    particles: int
    channels: int
    azimuths: int
    threads: int

    @property
    def clock(self) -> str:
        """Which time counts. One thread's own CPU time does not grow when others use the machine."""
        return "cpu" if self.threads == 1 else "wall"

    def __str__(self) -> str:
        edge = f"{self.edge}^3" if self.edge else "-"
        rays = f"{self.channels}x{self.azimuths}" if self.channels else "-"
        return f"{self.subject}/{edge}/{self.particles or '-'}/{rays}/{self.threads}"


@dataclass
class Samples:
    """Times of the frames that count [ms]."""

    wall: list[float] = field(default_factory=list)
    cpu: list[float] = field(default_factory=list)  # of the calling thread
    stages: dict[str, list[float]] = field(default_factory=dict)  # wall time

    def median(self, clock: str) -> float:
        return statistics.median(self.cpu if clock == "cpu" else self.wall)


class Run(NamedTuple):
    """One run of the program."""

    facts: dict[str, str]
    samples: dict[Configuration, Samples]


def run_program(program: Path, frames: int | None, only: list[str]) -> Run:
    """Run it to its end.

    Raises
    ------
    BenchError
        If the program fails, or prints another format than this script reads.
    """
    command = [str(program)] + (["--frames", str(frames)] if frames else [])
    command += [word for prefix in only for word in ("--only", prefix)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise BenchError(f"{program}: {error.strerror}", 2) from error
    if done.returncode != 0:
        last_line = (done.stderr.strip().splitlines() or ["no message"])[-1]
        raise BenchError(f"{program}: {last_line}", max(done.returncode, 1))
    return parse(done.stdout.splitlines(), program)


def parse(lines: list[str], program: Path) -> Run:
    """Facts and samples of the output's lines."""
    facts = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    if facts.get("format") != FORMAT:
        raise BenchError(f"{program}: prints format {facts.get('format')}: allowed: {FORMAT}", 2)
    samples: dict[Configuration, Samples] = {}
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        sizes = (int(row[name]) for name in Configuration._fields[1:])
        of_case = samples.setdefault(Configuration(row["subject"], *sizes), Samples())
        if row["part"] == "total":
            of_case.wall.append(float(row["wall_ms"]))
            of_case.cpu.append(float(row["cpu_ms"]))
        else:
            of_case.stages.setdefault(row["part"], []).append(float(row["wall_ms"]))
    return Run(facts, samples)
