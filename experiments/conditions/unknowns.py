"""The unknowns of a condition (unknowns.toml): from a point of the unit cube to values."""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass
from pathlib import Path

FILE = Path(__file__).with_name("unknowns.toml")

Value = float | int | str


@dataclass(frozen=True)
class Unknown:
    """One thing that the paper leaves open, and the values to try."""

    name: str
    parameter: str | None
    words: tuple[str, ...]  # empty: a number
    low: float
    high: float
    log: bool
    whole: bool
    zero_below: float | None

    def value(self, share: float) -> Value:
        """The value at `share` in [0, 1) of the way through the range."""
        if self.words:
            return self.words[min(int(share * len(self.words)), len(self.words) - 1)]
        if self.log:
            found = self.low * (self.high / self.low) ** share
        else:
            found = self.low + share * (self.high - self.low)
        if self.zero_below is not None and found < self.zero_below:
            return 0.0
        # Four digits say all: a condition reads the same wherever it is written.
        return round(found) if self.whole else float(f"{found:.4g}")

    def share(self, value: Value) -> float:
        """Where a value lies in the range, in [0, 1]; of a word, the middle of its part."""
        if self.words:
            return (self.words.index(str(value)) + 0.5) / len(self.words)
        if self.log:
            return math.log(float(value) / self.low) / math.log(self.high / self.low)
        return (float(value) - self.low) / (self.high - self.low)


def unknowns() -> list[Unknown]:
    """All, in the order of the file.

    Raises
    ------
    ValueError
        Naming the file, the unknown and what is wrong with it.
    """
    with FILE.open("rb") as stream:
        return [_unknown(entry) for entry in tomllib.load(stream)["unknown"]]


def _unknown(entry: dict) -> Unknown:
    words = tuple(entry.get("words", ()))
    low, high = (0.0, 0.0) if words else (entry["from"], entry["to"])
    log = entry.get("scale") == "log"
    if not words and not low < high or log and low <= 0:
        raise ValueError(f"{FILE}: {entry['name']}: from = {low}, to = {high}: allowed: from < to, "
                         "above 0 on a scale of ratios")
    return Unknown(entry["name"], entry.get("parameter"), words, low, high, log,
                   entry.get("whole", False), entry.get("zero_below"))
