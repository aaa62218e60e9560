"""The scenario files of a condition: BASES with its speeds, sizes and sensor."""

from __future__ import annotations

import tomllib
from pathlib import Path

from unknowns import Value

SCENARIOS = Path(__file__).resolve().parents[2] / "datasets" / "scenarios"
BASES = {"scenario1": "scenario1_fast", "scenario2": "scenario2", "scenario3": "scenario3_fast"}
"""What a condition changes. The shipped scenario1 and scenario3 are themselves the worlds of a condition."""
SPREAD = (2 / 3, 4 / 3)
"""Every obstacle draws its speed, acceleration and way between turns from its mean times these."""
NUMBER_EXPONENT = -1.2
"""Number of obstacles = number of the base x width_scale ^ this: [11] then errs about as often
(analysis/conditions shows its accuracy beside the paper's for every condition)."""


def scenario_text(name: str, condition: dict[str, Value]) -> str:
    """The file of a scenario under a condition. People outdoors are as they are: only what the paper
    leaves open of scenarios 1 to 3 changes."""
    with (SCENARIOS / f"{BASES[name]}.toml").open("rb") as stream:
        scenario = tomllib.load(stream)
    scenario["sensor"]["range_sigma_m"] = condition["range_sigma_m"]
    elevation = condition["elevation_deg"]
    scenario["sensor"]["elevation_deg"] = [-elevation, elevation]
    for group in scenario["groups"].values():
        _change(group, condition)
    return toml(scenario)


def _change(group: dict, condition: dict[str, Value]) -> None:
    scale = condition["width_scale"]
    group["count"] = max(1, round(group["count"] * scale**NUMBER_EXPONENT))
    group["width_m"] = _rounded(width * scale for width in group["width_m"])
    if group["motion"] != "shuttle":
        return
    for key, unknown in (("speed_mps", "speed_mps"), ("acceleration_mps2", "acceleration_mps2"),
                         ("leg_m", "leg_m")):
        group[key] = _rounded(condition[unknown] * share for share in SPREAD)
    group["pause_s"] = _rounded((0.2 * condition["pause_s"], condition["pause_s"]))


def _rounded(values) -> list[float]:
    return [float(f"{value:.4g}") for value in values]


def toml(tables: dict, prefix: str = "") -> str:
    """Numbers, texts, truth values and lists of them in nested tables, as TOML."""
    plain = {key: value for key, value in tables.items() if not isinstance(value, dict)}
    text = f"[{prefix}]\n" if prefix and plain else ""
    text += "".join(f"{_key(key)} = {_value(value)}\n" for key, value in plain.items())
    for key, value in tables.items():
        if isinstance(value, dict):
            text += "\n" + toml(value, f"{prefix}.{_key(key)}" if prefix else _key(key))
    return text


def _key(name: str) -> str:
    return f'"{name}"' if "." in name else name


def _value(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return repr(value)
