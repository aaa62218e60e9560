"""The velocity errors of Sec. 4.1.3 beside the paper's; `table1` writes them."""

from __future__ import annotations

from analysis.data.published import PF_READINGS, paper_name, published
from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.tables.beside import all_methods, scenario_name, side_by_side
from analysis.tables.mean_table import Means
from analysis.tables.orderings import Ordering, judge, orderings_text, published_claims
from analysis.tables.text_table import interval, latex_tabular, latex_text, number

COLUMNS = ("ldm", *PF_READINGS)
PUBLISHED = [SCORES["static_velocity_error_mps"], SCORES["dynamic_velocity_error_mps"]]
SHOWN = [
    *PUBLISHED,
    SCORES["static_velocity_error_steady_mps"],
    SCORES["dynamic_velocity_error_steady_mps"],
    SCORES["time_to_converge_s"],
]


def published_cell(scenario: str, score: str, method: str) -> float | None:
    """The value of Sec. 4.1.3, or None where the paper has none."""
    for entry in published()["velocity"].values():
        if entry.get("scenario") == scenario and score in entry:
            return entry[score].get(method)
    return None


def judge_orderings(study: Study) -> list[Ordering]:
    """Proposed against both readings of [11] with PF: the static and the dynamic velocity error."""
    claims = [
        claim
        for entry in published()["velocity"].values()
        for score in PUBLISHED
        if score.name in entry
        for claim in published_claims(entry["scenario"], score.name, entry[score.name])
    ]
    return judge(study, claims)


def table_text(study: Study, means: Means, found: list[Ordering]) -> str:
    """The whole of velocity.txt."""
    parts = [
        "Velocity error (Sec. 4.1.3), the paper's beside ours: mean [95% bootstrap interval] over",
        f"seeds; {study.source()}.",
        "The paper shows one obstacle of each kind and does not say of which scenario: its values",
        "stand at the scenario that has this kind alone.\n",
        side_by_side(means, COLUMNS, _lines(study, means), published_cell),
        "Orderings: the paper says Proposed is better than [11] with PF; ours is the difference",
        "to each reading of it (Eq. 17 or not), paired by seed, mean [95% bootstrap interval].\n",
        orderings_text(found),
        "All methods with velocities: mean [95% bootstrap interval] over seeds.\n",
        all_methods(means, study.methods, study.scenarios, SHOWN),
    ]
    return "\n".join(parts)


def tabular(study: Study, means: Means) -> str:
    """The side-by-side table as LaTeX (booktabs)."""
    names = [latex_text(paper_name(method)) for method in COLUMNS]
    head = [
        "& & " + " & ".join(rf"\multicolumn{{2}}{{c}}{{{name}}}" for name in names) + r" \\",
        " ".join(rf"\cmidrule(lr){{{k}-{k + 1}}}" for k in range(3, 3 + 2 * len(names), 2)),
        "&" + " & paper & ours" * len(names) + r" \\",
    ]
    rows = []
    for scenario, score in _lines(study, means):
        row = [scenario_name(scenario), latex_text(score.axis_label)]
        for method in COLUMNS:
            row.append(number(published_cell(scenario, score.name, method), score.decimals))
            row.append(interval(means.find(scenario, method, score.name), score.decimals))
        rows.append(row)
    return latex_tabular("ll" + "rl" * len(names), head, rows)


def _lines(study: Study, means: Means) -> list[tuple]:
    """(scenario, score) wherever one of the methods has a value: a scenario may lack a kind."""
    return [
        (scenario, score)
        for scenario in study.scenarios
        for score in PUBLISHED
        if any(means.find(scenario, method, score.name).n for method in COLUMNS)
    ]
