"""How the verdicts on the paper's orders depend on truth, no-return rays, speed and seeds."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Callable

import pandas as pd

from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.report import latex
from analysis.report.comparisons import ordering, paired
from analysis.report.evidence import Evidence
from analysis.tables import accuracy_table, velocity_table
from analysis.tables.beside import scenario_name
from analysis.tables.orderings import OPPOSITE, REPRODUCED, Claim
from analysis.tables.text_table import latex_tabular

OTHER_TRUTH = {
    "accuracy_pct": "accuracy_visible_pct",
    "case1_voxels": "case1_visible_voxels",
    "case2_voxels": "case2_grown_voxels",
    "static_velocity_error_mps": "static_velocity_error_steady_mps",
    "dynamic_velocity_error_mps": "dynamic_velocity_error_steady_mps",
}
"""Score -> the same against the truth that forgives more: what can be seen, grown, or steady."""

DROPPED = {"ldm": "drop_no_returns", "circular_buffer": "circular_buffer_drop_no_returns"}
"""Method -> its variant without no-return rays in the study `ablation`."""

FEW_SEEDS = (2, 4)
"""The verdict is also made from so small a part of the seeds: a half, a quarter."""

SAME, OTHER, UNDECIDED, UNKNOWN = r"\sameorder", r"\otherorder", r"\noorder", "-"


@dataclass(frozen=True)
class Column:
    """One change of the circumstances: the mark for each claim."""

    head: str  # LaTeX
    mark: Callable[[Claim], str]


def sensitivity_table(evidence: Evidence, caption: str) -> str:
    """A row for each of the paper's orders of Table 1 and Sec. 4.1.3, a column for each change."""
    study = evidence.study("table1")
    if study is None:
        return latex.missing("table1") + "\n"
    found = accuracy_table.judge_orderings(study) + velocity_table.judge_orderings(study)
    columns = _columns(evidence, study)
    rows = []
    for claim in [o.claim for o in found]:
        name = f"{scenario_name(claim.scenario)}, {SCORES[claim.score].label}"
        rows.append([name, claim.word, *(column.mark(claim) for column in columns)])
    head = " & ".join(["", "paper", *(column.head for column in columns)]) + r" \\"
    body = latex_tabular("ll" + "c" * len(columns), [head], rows)
    return latex.table(r"\fitted{%"
                       + "\n" + body.strip() + "}", caption, "tab:sensitivity")  # fmt: skip


def _columns(evidence: Evidence, study: Study) -> list[Column]:
    columns = [
        Column("ours", lambda claim: _mark(study, claim)),
        Column(r"\shortstack{other\\truth}", lambda claim: _mark(study, claim, _other_truth)),
    ]
    ablation = evidence.study("ablation")
    for head, change in (("free", lambda c: c), ("dropped", _dropped)):
        head = rf"\shortstack{{no returns\\{head}}}"
        columns.append(Column(head, lambda claim, change=change: _mark(ablation, claim, change)))
    speeds = evidence.study("obstacle_speed")
    for point, values in speeds.points.items() if speeds else ():
        factor = values["scenario.obstacles.speed_scale"]
        columns.append(
            Column(rf"\shortstack{{speed\\$\times${factor:g}}}",
                   lambda claim, point=point: _mark(speeds, claim, point=point))
        )  # fmt: skip
    for part in FEW_SEEDS:
        most = max(2, study.seeds // part)
        columns.append(
            Column(rf"\shortstack{{{most}\\seeds}}",
                   lambda claim, most=most: _mark(study, claim, most=most))
        )  # fmt: skip
    return columns


def _mark(
    study: Study | None, claim: Claim, change: Callable[[Claim], Claim] = lambda claim: claim,
    point: str = "", most: int | None = None,
) -> str:  # fmt: skip
    """The paper's order, the other one, or none that our seeds can tell."""
    if study is None:
        return UNKNOWN
    changed = change(claim)
    method, baseline = (
        _first(study.per_seed(changed.scenario, name, changed.score, point), most)
        for name in (changed.method, changed.baseline)
    )
    found = ordering(changed, paired(method, baseline, SCORES[changed.score].better))
    if found.difference.n < 2:
        return UNKNOWN
    return {REPRODUCED: SAME, OPPOSITE: OTHER}.get(found.verdict, UNDECIDED)


def _first(values: pd.Series, most: int | None) -> pd.Series:
    """The values of the lowest replicates."""
    return values if most is None else values.sort_index().iloc[:most]


def _other_truth(claim: Claim) -> Claim:
    return replace(claim, score=OTHER_TRUTH[claim.score])


def _dropped(claim: Claim) -> Claim:
    return replace(
        claim,
        method=DROPPED.get(claim.method, claim.method),
        baseline=DROPPED.get(claim.baseline, claim.baseline),
    )
