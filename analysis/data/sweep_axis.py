"""How the points of a sweep stand along an axis: by a number, or one beside the other."""

from __future__ import annotations

import json
from dataclasses import dataclass
from math import prod

from analysis.data.records import point_label

_UNITS = {"_mps2": "m/s²", "_mps": "m/s", "_deg": "deg", "_hz": "Hz", "_m": "m", "_s": "s"}

DECADE = 10.0
SMALLEST_FACTOR = 1.5
"""Steps by a smaller factor look alike on both kinds of axis."""


@dataclass(frozen=True)
class SweepAxis:
    """Where each point of a sweep stands."""

    label: str  # with unit
    numeric: bool
    place: dict[str, float]
    """Point label -> value of the parameter, or 0, 1, ... if not numeric."""
    line: dict[str, str]
    """Point label -> the other swept parameters, which a line is drawn for; mostly empty."""
    names: dict[str, str]
    """Point label -> short name of the point."""
    order: list[str]
    """Point labels as a table lists them: line by line, along the axis."""

    @property
    def values(self) -> list[float]:
        """The different places, ascending."""
        return sorted(set(self.place.values()))

    @property
    def logarithmic(self) -> bool:
        """True if the values are positive and span a decade or more, or are spaced by factors."""
        return self.numeric and (spans_decades(self.values) or spaced_by_factors(self.values))


def spans_decades(values: list[float]) -> bool:
    """True if all are positive and the largest is at least ten times the smallest."""
    return min(values) > 0 and max(values) >= DECADE * min(values)


def spaced_by_factors(values: list[float]) -> bool:
    """True if three or more ascending values grow by a factor that stays the same within 10%."""
    if len(values) < 3 or min(values) <= 0:
        return False
    factors = [b / a for a, b in zip(values, values[1:])]
    return max(factors) <= 1.1 * min(factors) and min(factors) >= SMALLEST_FACTOR


def sweep_axis(points: dict[str, dict]) -> SweepAxis:
    """The axis for the points of a study, as `Study.points` holds them.

    A numeric parameter that tells all points apart is the axis. If there is none but the points are
    the full product of their parameters' values, the numeric parameter with most values is, and
    each combination of the others gets a line. Else the points stand one beside the other.
    """
    values = _swept_values(points)
    numeric = [n for n, found in values.items() if all(_is_number(value) for value in found)]
    telling = [name for name in numeric if len(values[name]) == len(points)]
    if telling:
        companions = [name for name in values if name != telling[0]]
        note = f", with {', '.join(map(_short, companions))}" if companions else ""
        return _numeric_axis(points, telling[0], note, others=[])
    if numeric and len(points) == prod(len(found) for found in values.values()):
        widest = max(numeric, key=lambda name: len(values[name]))
        return _numeric_axis(points, widest, "", [name for name in values if name != widest])
    return SweepAxis(
        label=", ".join(map(parameter_label, values)),
        numeric=False,
        place={label: float(i) for i, label in enumerate(points)},
        line=dict.fromkeys(points, ""),
        names=_variant_names(points, list(values)),
        order=list(points),
    )


def parameter_label(name: str) -> str:
    """`map.resolution_m` as `map.resolution (m)`."""
    for suffix, unit in _UNITS.items():
        if name.endswith(suffix):
            return f"{name.removesuffix(suffix)} ({unit})"
    return name


def _numeric_axis(points: dict[str, dict], name: str, note: str, others: list[str]) -> SweepAxis:
    return SweepAxis(
        label=parameter_label(name) + note,
        numeric=True,
        place={label: float(point[name]) for label, point in points.items()},
        line={label: _short_label(point, others) for label, point in points.items()},
        names={label: _short_label(point, [name]) for label, point in points.items()},
        order=sorted(points, key=lambda label: [_rank(points[label].get(n)) for n in (*others, name)]),
    )


def _rank(value: object) -> tuple[bool, float, str]:
    """Numbers by their size, then words."""
    return (False, value, "") if _is_number(value) else (True, 0.0, json.dumps(value))


def _swept_values(points: dict[str, dict]) -> dict[str, list]:
    """Parameter -> its different values, for the parameters that have more than one."""
    names = dict.fromkeys(name for point in points.values() for name in point)
    values = {}
    for name in names:
        found = [point.get(name) for point in points.values()]
        # As text: 1 and true differ, which Python takes for equal.
        values[name] = list({json.dumps(value): value for value in found}.values())
    return {name: found for name, found in values.items() if len(found) > 1}


def _variant_names(points: dict[str, dict], swept: list[str]) -> dict[str, str]:
    """Name each point by the values most others do not have, if that tells them apart."""
    usual = {}
    for name in swept:
        found = [json.dumps(point.get(name)) for point in points.values()]
        usual[name] = max(found, key=found.count)
    names = {}
    for label, point in points.items():
        unusual = [name for name in swept if json.dumps(point.get(name)) != usual[name]]
        names[label] = _short_label(point, unusual) or "usual values"
    if len(swept) > 1 and len(set(names.values())) == len(points):
        return names
    return {label: _short_label(point, swept) for label, point in points.items()}


def _is_number(value: object) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _short(name: str) -> str:
    return name.rsplit(".", 1)[-1]


def _short_label(point: dict, names: list[str]) -> str:
    return point_label({_short(name): point[name] for name in names if name in point})
