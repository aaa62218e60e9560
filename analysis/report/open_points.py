"""What the paper leaves open: each point with its alternatives and their measured effect."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path

from analysis.data.mixtures import PER_TRIAL_PARAMETERS
from analysis.data.records import Study, point_label
from analysis.data.scores import SCORES, Score
from analysis.report import latex
from analysis.report.comparisons import paired
from analysis.report.evidence import Evidence
from analysis.tables.accuracy_table import judge_orderings
from analysis.tables.orderings import judge
from analysis.tables.text_table import NOTHING

FILE = Path(__file__).with_name("open_points.toml")
STUDIES = ("ablation", "process_noise", "survival")
"""Where alternatives are looked for."""
BASELINE = "circular_buffer"

EFFECTS = (
    ("accuracy_pct", ("scenario1", "scenario2", "scenario3")),
    ("mixed_voxels_per_frame", ("scenario1", "scenario2", "scenario3")),
    ("static_velocity_error_mps", ("scenario2",)),
    ("dynamic_velocity_error_mps", ("scenario1",)),
)
"""Scores, each with the scenarios, whose change the table shows."""

_COLUMNS = "@{}l" + "c" * sum(len(scenarios) for _, scenarios in EFFECTS) + "r@{}"

Entrant = tuple[str, str]
"""Method or variant, and point of the sweep."""


@dataclass(frozen=True)
class Alternative:
    """Another setting than that of the LDM, measured in a study over the same worlds."""

    study: Study
    entrant: Entrant
    reference: Entrant
    changes: dict[str, object]  # parameter -> its other value

    @property
    def label(self) -> str:
        """The changed values, and the name of the variant, as LaTeX."""
        words = [f"{n.rpartition('.')[2]} = {show(v)}" for n, v in self.changes.items()]
        own = "" if self.entrant[0] == "ldm" else f" ({latex.code(self.entrant[0])})"
        return ", ".join(map(latex.code, words)) + own


@lru_cache(maxsize=1)
def open_points() -> list[dict]:
    """The points of open_points.toml."""
    with FILE.open("rb") as stream:
        return tomllib.load(stream)["point"]


def show(value: object) -> str:
    """A parameter's value as a TOML file has it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def settled_text(point: dict, parameters: dict[str, object]) -> str:
    """The decision as LaTeX, with the values of the records; parameters: of any record."""
    filled = re.sub(
        r"\{([\w.]+)\}", lambda name: show(parameters.get(name.group(1), "?")), point["settled"]
    )
    return latex.plain(filled)


def alternatives(evidence: Evidence, defaults: dict[str, object]) -> list[Alternative]:
    """All settings of the LDM in the studies that differ from its own, the `defaults`.

    None if the defaults are not known.
    """
    found = []
    for name in STUDIES:
        study = evidence.study(name)
        if study is not None and defaults:
            found += _of_study(study, defaults)
    return found


def of_point(point: dict, found: list[Alternative]) -> list[Alternative]:
    """Those that change nothing but the parameters of the point."""
    return [a for a in found if set(a.changes) <= set(point["parameters"])]


def points_table(
    evidence: Evidence, defaults: dict[str, object], caption: str
) -> str:
    """Every point with its decision, and below it the effect of each alternative."""
    found = alternatives(evidence, defaults)
    width = 2 + sum(len(scenarios) for _, scenarios in EFFECTS)
    rows = []
    for number, point in enumerate(open_points(), start=1):
        question, place = latex.plain(point["question"]), latex.plain(point["place"])
        text = rf"\textbf{{{number}. {question}}} ({place}). {settled_text(point, defaults)}."
        rows.append(rf"\multicolumn{{{width}}}{{@{{}}p{{\linewidth}}@{{}}}}{{{text}}} \\*[2pt]")
        own = of_point(point, found)
        for a in own:
            label = rf"\multicolumn{{{width}}}{{@{{\quad}}l}}{{{a.label}}} \\*"
            rows += [label, " & ".join(["", *effect_cells(a), changed_orders(a)]) + r" \\[2pt]"]
        if not own:
            measurable = bool(point["parameters"])
            reason = latex.missing("ablation") if measurable else "no parameter: not measured"
            rows.append(rf"\multicolumn{{{width}}}{{@{{\quad}}l}}{{{reason}}} \\")
        rows.append(r"\addlinespace[5pt]")
    return latex.longtable(_COLUMNS, _head(), rows, caption, "tab:open-points")


def effect_cells(alternative: Alternative) -> list[str]:
    """Alternative - LDM on the same seeds, for each score and scenario of EFFECTS."""
    study = alternative.study
    cells = []
    for name, scenarios in EFFECTS:
        score = SCORES[name]
        for scenario in scenarios:
            changed, reference = (
                study.per_seed(scenario, method, name, point)
                for method, point in (alternative.entrant, alternative.reference)
            )
            found = paired(changed, reference, score.better).difference
            decimals = score.decimals + (score.unit == "%")
            cells.append(latex.stacked(found, decimals))
    return cells


def changed_orders(alternative: Alternative) -> str:
    """How many verdicts on Table 1's orders differ between the alternative and the LDM.

    Held against [11] with the same change where the study has it, else against [11] as it is.
    """
    study, (variant, point) = alternative.study, alternative.entrant
    if point or variant == BASELINE or BASELINE not in study.methods:
        return NOTHING
    changed = f"{BASELINE}_{variant}"
    baseline = changed if changed in study.methods else BASELINE
    usual = judge_orderings(study)
    claims = [replace(o.claim, method=variant, baseline=baseline) for o in usual]
    return str(sum(a.verdict != b.verdict for a, b in zip(usual, judge(study, claims))))


def _head() -> str:
    """Two lines: scores over their scenarios."""
    upper, lower = [""], [""]
    for name, scenarios in EFFECTS:
        score = SCORES[name]
        upper.append(
            rf"\multicolumn{{{len(scenarios)}}}{{c}}{{{_heading(score, len(scenarios))}}}"
        )
        lower += [scenario.replace("scenario", "S") for scenario in scenarios]
    return " & ".join([*upper, "orders"]) + r" \\" + "\n" + " & ".join([*lower, "changed"]) + r" \\"


def _of_study(study: Study, defaults: dict[str, object]) -> list[Alternative]:
    values = _parameters(study)
    # A sweep need not hold the LDM's own setting: then the point nearest to it is the reference.
    reference = min(values, key=lambda entrant: len(_changes(values[entrant], defaults)))
    found = []
    for entrant, of_entrant in values.items():
        changes = _changes(of_entrant, values[reference])
        if changes:
            found.append(Alternative(study, entrant, reference, changes))
    return found


def _parameters(study: Study) -> dict[Entrant, dict[str, object]]:
    """The parameters of each entrant that is an LDM; in an ablation all but the baselines are."""
    found = {}
    for record in study.records:
        if not record["method"].startswith(BASELINE):
            entrant = (record["method"], point_label(record["point"]))
            found.setdefault(entrant, record["parameters"])
    return found


def _changes(values: dict[str, object], reference: dict[str, object]) -> dict[str, object]:
    return {name: value for name, value in values.items()
            if value != reference.get(name) and name not in PER_TRIAL_PARAMETERS}  # fmt: skip


def _heading(score: Score, columns: int) -> str:
    if columns > 1:
        return latex.latex_text(score.axis_label)
    short = score.label.replace(" velocity", "")
    return rf"\shortstack{{{short}\\({latex.latex_text(score.unit)})}}"
