"""The trials of one stage: their files, which are missing, and running them.

    CONDITION/flight.toml, outdoor1.toml, outdoor2.toml   studies, with the condition's parameters
    CONDITION/scenario1.toml ...                          its worlds
    CONDITION/records/SCENARIO.METHOD.sNNN.json           records (experiments/RECORD.md)
"""

from __future__ import annotations

import shlex
import subprocess
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass
from pathlib import Path
from typing import Callable, Iterable

import pace
import records
from unknowns import Value, unknowns
from worlds import scenario_text, toml

DATA = Path(__file__).resolve().parents[2]
"""Whatever build the program is of: the outdoor worlds are those of this tree."""
FLIGHTS = ("scenario1", "scenario2", "scenario3")
WITH_FILTER = ("ldm", "circular_buffer", "circular_buffer_pf_eq17", "circular_buffer_pf_free")
METHODS = {"scenario1": WITH_FILTER, "scenario2": WITH_FILTER,
           "scenario3": ("ldm", "circular_buffer"), "outdoor1": ("ldm",), "outdoor2": ("ldm",)}
"""What the claims compare, scenario by scenario."""
CLAMPS = {"octomap": (-2.0, 3.5), "usenko": (-2.75, 2.75)}


@dataclass(frozen=True)
class Trial:
    """One record to be."""

    study: Path
    id: str
    replicate: int
    frames: int

    @property
    def record(self) -> Path:
        return self.study.parent / "records" / f"{self.id}.json"

    def fault(self) -> str | None:
        """Why there is no good record: none, one cut short, a trial that failed."""
        return records.read(self.record.parent, self.id).error


@dataclass(frozen=True)
class Batch:
    """Trials of one study and replicate: one process, which shares worlds among them."""

    trials: tuple[Trial, ...]

    def command(self, program: str) -> list[str]:
        study, replicate = self.trials[0].study, self.trials[0].replicate
        output = study.parent / "records"
        if len(self.trials) == 1:
            output = self.trials[0].record
        return [program, "--data-dir", str(DATA), "trial", str(study), *(trial.id for trial in self.trials),
                "--seeds", str(replicate), "-o", str(output)]

    def limit_s(self) -> float:
        """How long it may take: as a study's trials, one after the other."""
        return sum(pace.limit_s([trial.id.split(".")[1]], trial.frames, None) for trial in self.trials)


def batches(missing: Iterable[Trial]) -> list[Batch]:
    """In the order of the first trial of each."""
    found: dict[tuple[Path, int], list[Trial]] = {}
    for trial in missing:
        found.setdefault((trial.study, trial.replicate), []).append(trial)
    return [Batch(tuple(of_study)) for of_study in found.values()]


def parameters(condition: dict[str, Value]) -> dict[str, Value]:
    """Parameters of the method, by name."""
    found = {unknown.parameter: condition[unknown.name]
             for unknown in unknowns() if unknown.parameter}
    sigma = float(condition["sigma_mps"])
    found["particles.sigma_z_mps"] = float(f"{sigma * float(condition['sigma_z_share']):.4g}")
    low, high = CLAMPS[str(condition["clamps"])]
    return found | {"sensor_model.log_odds_min": low, "sensor_model.log_odds_max": high}


def write_studies(folder: Path, condition: dict[str, Value], frames: dict[str, int]) -> None:
    """The files of one condition. The names of studies are part of the filter's seed: the same in
    every condition, so that conditions are compared on the same seeds."""
    (folder / "records").mkdir(parents=True, exist_ok=True)
    for name in FLIGHTS:
        (folder / f"{name}.toml").write_text(scenario_text(name, condition), encoding="utf-8")
    for study, scenarios in (("flight", [str(folder / f"{name}.toml") for name in FLIGHTS]),
                             ("outdoor1", ["outdoor1"]), ("outdoor2", ["outdoor2"])):
        content = {"title": f"Condition {folder.name}", "scenarios": scenarios, "seeds": 1,
                   "frames": frames[Path(scenarios[0]).stem], "series": True,
                   "methods": list(METHODS[Path(scenarios[0]).stem]), "set": parameters(condition)}
        (folder / f"{study}.toml").write_text(toml(content), encoding="utf-8")


def trials(folder: Path, frames: dict[str, int], replicates: Iterable[int]) -> list[Trial]:
    """All of one condition, world by world."""
    return [
        Trial(folder / f"{'flight' if scenario in FLIGHTS else scenario}.toml",
              f"{scenario}.{method}.s{replicate:03d}", replicate, frames[scenario])
        for replicate in replicates
        for scenario, methods in METHODS.items()
        for method in methods
    ]


def run(missing: list[Batch], program: str, jobs: int, done: Callable[[Batch, str], None]) -> int:
    """Run batches, `jobs` at a time; `done` hears of each and of its complaint. How many failed.

    Ctrl-C ends it after the batches that are running; what has a record is not run again.
    """
    failed = 0
    with ThreadPoolExecutor(jobs) as pool:
        waiting = {pool.submit(_run, batch, program): batch for batch in missing}
        try:
            for future in as_completed(waiting):
                complaint = future.result()
                failed += bool(complaint)
                done(waiting[future], complaint)
        except BaseException:
            pool.shutdown(cancel_futures=True)
            raise
    return failed


def _run(batch: Batch, program: str) -> str:
    limit_s = batch.limit_s()
    try:
        found = subprocess.run(batch.command(program), capture_output=True, text=True, check=False,
                               timeout=limit_s)
    except subprocess.TimeoutExpired:
        return f"took longer than {limit_s:.0f} s: {shlex.join(batch.command(program))}"
    if found.returncode and not found.stderr.strip():
        return f"exit code {found.returncode}"
    return found.stderr.strip() if found.returncode else ""
