"""Which conditions are tried: a space-filling design, and offspring of the nearest ones."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
from scipy.stats import qmc

from unknowns import Unknown, Value, unknowns

SEED = 20210088
MUTATED = 0.1
"""Standard deviation of a mutation, in the unit cube."""
FROM_OTHER = 0.25
"""Probability that an unknown is inherited from a second parent."""


def space_filling(count: int) -> list[dict[str, Value]]:
    """The first `count` points of a scrambled Sobol sequence over all unknowns."""
    found = unknowns()
    sequence = qmc.Sobol(len(found), seed=SEED)
    points = sequence.random_base2(max(0, int(count - 1).bit_length()))[:count]
    return [_condition(found, point) for point in points]


def offspring(parents: list[dict[str, Value]], count: int) -> list[dict[str, Value]]:
    """Each of a parent in turn: some unknowns from another parent, numbers a little mutated, a word
    anew with the same small probability."""
    found = unknowns()
    generator = np.random.default_rng(SEED)
    shares = np.array([[unknown.share(parent[unknown.name]) for unknown in found]
                       for parent in parents])
    children = []
    for k in range(count):
        child = shares[k % len(shares)].copy()
        other = shares[generator.integers(len(shares))]
        mixed = generator.random(len(found)) < FROM_OTHER
        child[mixed] = other[mixed]
        words = np.array([bool(unknown.words) for unknown in found])
        child[~words] += generator.normal(0, MUTATED, np.sum(~words))
        anew = words & (generator.random(len(found)) < MUTATED)
        child[anew] = generator.random(np.sum(anew))
        children.append(_condition(found, np.clip(child, 0, 1 - 1e-9)))
    return children


def _condition(found: list[Unknown], point: np.ndarray) -> dict[str, Value]:
    return {unknown.name: unknown.value(share) for unknown, share in zip(found, point)}


def write_conditions(file: Path, conditions: dict[str, dict[str, Value]]) -> None:
    """A table: name, unknowns."""
    file.parent.mkdir(parents=True, exist_ok=True)
    names = [unknown.name for unknown in unknowns()]
    with file.open("w", newline="", encoding="utf-8") as stream:
        writer = csv.writer(stream)
        writer.writerow(["condition", *names])
        for name, condition in conditions.items():
            writer.writerow([name, *(condition[key] for key in names)])


def read_conditions(file: Path) -> dict[str, dict[str, Value]]:
    """Name -> unknowns, in the order of the file."""
    kinds = {unknown.name: str if unknown.words else int if unknown.whole else float
             for unknown in unknowns()}
    with file.open(newline="", encoding="utf-8") as stream:
        return {row["condition"]: {name: kind(row[name]) for name, kind in kinds.items()}
                for row in csv.DictReader(stream)}
