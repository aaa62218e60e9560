"""How long trials take: measured where a study has run, else typical of its methods (pace.toml)."""

import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
MEASURED, TYPICAL, UNKNOWN = "", "*", "?"
NOTES = {
    TYPICAL: "* from a typical trial of each method with its default parameters; the study has not run "
             "here yet",
    UNKNOWN: "? of a method not timed yet; `make trials STUDY=name SEEDS=1` is a measurement",
}

# The limit of a trial stands far above every honest one: swept maps and particles cost up to a hundred
# times the defaults, and other programs may have most of the machine.
LIMIT_TIMES = 100
LEAST_LIMIT_S = 600
UNKNOWN_TIMES = 10  # slower than the slowest method that is timed


def typical_cpu_s(methods: list[str], frames: int) -> float | None:
    """Of one trial, averaged over the methods; None if one of them is unknown."""
    pace = _pace()
    if not set(methods) <= set(pace["frame_s"]):
        return None
    frame_s = sum(pace["frame_s"][method] for method in methods) / len(methods)
    return pace["start_s"] + frames * frame_s


def limit_s(methods: list[str], frames: int, measured_cpu_s: float | None) -> float:
    """How long a trial may take: a multiple of its estimate."""
    pace = _pace()
    unknown = UNKNOWN_TIMES * max(pace["frame_s"].values())
    frame_s = max(pace["frame_s"].get(method, unknown) for method in methods)
    expected = max(pace["start_s"] + frames * frame_s, measured_cpu_s or 0)
    return max(LEAST_LIMIT_S, round(LIMIT_TIMES * expected))


def about(seconds: float) -> str:
    """No more digits than an estimate deserves."""
    if seconds < 100:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 6000 else f"{seconds / 3600:.1f} h"


def _pace() -> dict:
    return tomllib.loads((HERE / "pace.toml").read_text(encoding="utf-8"))
