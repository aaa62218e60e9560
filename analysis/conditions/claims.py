"""The paper's claims as intervals for a number of a trial, read from claims.toml.

Prints them: /usr/bin/python3 -m analysis.conditions.claims
"""

from __future__ import annotations

import math
import sys
import tomllib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from analysis.data.published import published

FILE = Path(__file__).parents[1] / "claims.toml"
METHOD = "ldm"
RELATIVE = ("case1_voxels", "case2_voxels")
"""Scores that are compared as a share of the baseline's mean [%]: counts grow with the frames."""


@dataclass(frozen=True)
class Claim:
    """What must lie where; the file says what the kinds mean."""

    name: str
    group: str
    kind: str
    scenario: str
    measure: str
    baseline: str | None  # a method; None: x is the score itself
    low: float  # the mean of x must lie between these
    high: float
    paper: float | None  # the paper's x
    scale: float | None  # of the distance; None: no part of it

    @property
    def key(self) -> str:
        """Unique: name, scenario, measure, and baseline if there is one."""
        return ".".join(filter(None, (self.name, self.scenario, self.measure, self.baseline)))

    @property
    def relative(self) -> bool:
        """x is a share of the baseline's mean [%]."""
        return self.baseline is not None and self.measure in RELATIVE


@lru_cache(maxsize=1)
def pf_readings() -> tuple[str, ...]:
    """The methods that "[11] with PF" may mean."""
    return tuple(_file()["pf_readings"])


@lru_cache(maxsize=1)
def claims() -> tuple[Claim, ...]:
    """All, in the order of the file; one for each scenario, measure and baseline of an entry."""
    return tuple(claim for entry in _file()["claim"] for claim in _expanded(entry))


def _file() -> dict:
    with FILE.open("rb") as stream:
        return tomllib.load(stream)


def _expanded(entry: dict) -> list[Claim]:
    baseline = entry.get("baseline")
    baselines = pf_readings() if baseline == "pf_readings" else (baseline,)
    return [
        _claim(entry, scenario, measure, each)
        for scenario in entry["scenarios"]
        for measure in entry["measures"]
        for each in baselines
    ]


def _claim(entry: dict, scenario: str, measure: str, baseline: str | None) -> Claim:
    kind = entry["kind"]
    scale = entry.get("scale")
    paper = _published_x(entry, scenario, measure)
    low, high = -math.inf, math.inf
    if kind == "order":
        low, high = (0.0, high) if paper > 0 else (low, 0.0)
    elif kind == "size":
        scale = entry["margin_share"] * abs(paper)
        low, high = paper - scale, paper + scale
    elif kind == "similar":
        paper = 0.0
        low, high = -entry["margin"], entry["margin"]
    elif kind == "at_most":
        high = entry["limit"]
    elif kind == "at_least":
        low = entry["limit"]
    else:
        raise ValueError(f"{FILE}: {entry['name']}: kind {kind!r} is unknown")
    return Claim(entry["name"], entry["group"], kind, scenario, measure, baseline, low, high,
                 paper, scale)  # fmt: skip


def _published_x(entry: dict, scenario: str, measure: str) -> float | None:
    """The paper's x of an entry; None where it gives no number."""
    if "published" not in entry:
        return entry.get("paper_difference")
    place = published()
    for key in entry["published"].split("."):
        place = place[key]
    values = list(place.get(scenario, place)[measure].values())  # method, baseline
    if "baseline" not in entry:
        return values[0]
    return (values[0] - values[1]) * (100 / values[1] if measure in RELATIVE else 1)


def main() -> None:
    """A line for each claim."""
    for claim in claims():
        paper = "" if claim.paper is None else f", the paper {claim.paper:.3g}"
        print(f"{claim.key}: {claim.low:.3g} to {claim.high:.3g}{paper}")


if __name__ == "__main__":
    sys.exit(main())
