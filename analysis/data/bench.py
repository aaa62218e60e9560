"""The measured speeds: what `make bench` wrote to bench.json (docs/benchmarks.md)."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from analysis.data.errors import InputError

SCHEMA = 1
FEW_RAYS, MANY_RAYS = (16, 1024), (64, 2048)
"""Channels and azimuths of the paper's LiDAR, and of a dense one."""


class Case(NamedTuple):
    """What was timed; 0 and (0, 0) stand for none."""

    subject: str
    edge: int = 0
    particles: int = 0
    rays: tuple[int, int] = FEW_RAYS
    threads: int = 1

    def __str__(self) -> str:
        parts = [self.subject]
        parts += [f"{self.edge}^3"] if self.edge else []
        parts += [f"{self.particles:,} particles"] if self.particles else []
        parts += [f"{self.rays[0]}x{self.rays[1]} rays"] if self.rays[0] else []
        return ", ".join([*parts, threads_text(self.threads)])


def threads_text(threads: int) -> str:
    return f"{threads} thread{'s' if threads > 1 else ''}"


def ldm(edge: int, particles: int, rays: tuple[int, int] = FEW_RAYS, threads: int = 1) -> Case:
    return Case("ldm", edge, particles, rays, threads)


def bound(state: str, particles: int, threads: int) -> Case:
    """The memory bound B3; `state` is "memory" or "cache"."""
    return Case(f"bound_{state}", 0, particles, (0, 0), threads)


@dataclass
class Bench:
    """One run of `make bench`."""

    file: Path
    document: dict
    median_ms: dict[Case, float]
    stages_ms: dict[Case, dict[str, float]]

    def source(self) -> str:
        """Machine, build and load, in a line."""
        build, machine = self.document["build"], self.document["machine"]
        commit = build["commit"][:12] + (", changed" if build["dirty"] else "")
        before, after = machine["load_average_before_and_after"]
        return (f"{machine['cpu']}, {machine['cores']} cores, {build['compiler']}, commit {commit}, "
                f"{self.document['frames']} frames, load average {before:.1f} before, {after:.1f} after")


def bench_file(results: Path) -> Path:
    """Where `make bench` puts it."""
    return results / "bench.json"


def load_bench(results: Path) -> Bench:
    """Read RESULTS/bench.json.

    Raises
    ------
    InputError
        If it is missing, broken, or of another schema.
    """
    file = bench_file(results)
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
        if document["schema"] != SCHEMA:
            raise InputError(f"{file}: schema {document['schema']}: allowed: {SCHEMA}")
        cases = {_case(entry): entry for entry in document["cases"]}
        medians = {case: float(entry["median_ms"]) for case, entry in cases.items()}
        stages = {case: dict(entry["stages_ms"]) for case, entry in cases.items()}
    except FileNotFoundError:
        raise InputError(f"{file}: missing; run `make bench`") from None
    except (json.JSONDecodeError, KeyError, TypeError, ValueError) as error:
        raise InputError(f"{file}: not a file of `make bench`: {error!r}") from error
    return Bench(file, document, medians, stages)


def _case(entry: dict) -> Case:
    rays = (entry["channels"], entry["azimuths"])
    return Case(entry["subject"], entry["edge"], entry["particles"], rays, entry["threads"])
