"""The section on the closed loop: success per world and arm, and the numbers that its text names."""

from __future__ import annotations

from analysis.data.records import Study
from analysis.data.statistics import SIGNIFICANCE
from analysis.report import latex
from analysis.report.evidence import Evidence
from analysis.tables.avoidance_table import (
    MEDIUM, arms, medium_pairs, medium_success, pair_frame, success_frame, tabular)  # fmt: skip

STUDY = "avoidance"
ARMS = ("blind", "circular_buffer", "ldm", "object_ldm", "oracle")
"""Those whose success at medium difficulty the text names."""
PAIRS = (("ldm", "circular_buffer"), ("object_ldm", "circular_buffer"), ("object_ldm", "ldm"))
"""Those whose test it names."""


def success_table(evidence: Evidence, caption: str) -> str:
    """Flights that reach the goal, with their intervals."""
    study = evidence.study(STUDY)
    body = latex.missing(STUDY) if study is None else rf"\fitted{{{tabular(study).strip()}}}"
    return latex.table(body, caption, "tab:avoidance")


def closed_loop_numbers(evidence: Evidence) -> dict[str, str]:
    """Key -> LaTeX text: at medium difficulty the arms' success and tests; pairs; times of a plan."""
    keys = [*(f"medium.{arm}" for arm in ARMS), *(f"medium.{a}.{b}" for a, b in PAIRS),
            "pairs", "pairs.differ", "plan.median", "plan.p95", "percentile"]  # fmt: skip
    study = evidence.study(STUDY)
    found = {} if study is None else _numbers(study)
    found["percentile"] = "95th percentile"
    absent = latex.missing(STUDY) if study is None else "--"
    return {f"{STUDY}.{key}": found.get(key, absent) for key in keys}


def _numbers(study: Study) -> dict[str, str]:
    tested = pair_frame(study)
    found = {"pairs": str(len(tested)), "pairs.differ": str((tested["p_holm"] < SIGNIFICANCE).sum())}
    if set(MEDIUM) <= set(study.scenarios):
        for arm in set(ARMS) & set(arms(study)):
            share = medium_success(study, arm)
            bounds = rf"\bounds{{{100 * share.low:.0f}}}{{{100 * share.high:.0f}}}"
            found[f"medium.{arm}"] = rf"{100 * share.mean:.0f}\,\% {bounds}"
        pairs = medium_pairs(study)
        for a, b in PAIRS:
            for row in pairs[pairs["a"].isin((a, b)) & pairs["b"].isin((a, b))].itertuples():
                found[f"medium.{a}.{b}"] = rf"$p$ = {latex.test(row.p_holm)}".replace("= $<$", "$<$")
    times = success_frame(study)
    for part in ("median", "p95"):
        found[f"plan.{part}"] = latex.value(times[f"plan_ms_{part}"].max(), 1)
    return found
