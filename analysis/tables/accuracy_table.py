"""Table 1 of the paper: occupancy grid accuracy and false voxels; `table1` writes it."""

from __future__ import annotations

from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.scores import SCORES, Score
from analysis.data.statistics import Interval
from analysis.tables.beside import all_methods, scenario_name, side_by_side
from analysis.tables.mean_table import Means
from analysis.tables.orderings import Ordering, judge, orderings_text, published_claims
from analysis.tables.text_table import interval, latex_tabular, latex_text, number

PAIR = ("ldm", "circular_buffer")
PUBLISHED = [SCORES[name] for name in ("accuracy_pct", "case1_voxels", "case2_voxels")]
OURS = [
    SCORES[name]
    for name in (
        "mixed_voxels_per_frame",
        "f1",
        "iou_visible",
        "ghost_voxels_per_frame",
        "seconds_to_clear",
    )
]
"""The paper has no values for them. F1 and IoU are 0 for a map of nothing, which accuracy favours."""
SHOWN = [*PUBLISHED, *OURS]
CAVEAT = (
    "Accuracy (Eq. 18) cannot tell a good map from none: unknown voxels count as free, and 0.2 to\n"
    "0.5% of all are solid. empty_map, which knows nothing, shows what silence earns; F1 (against\n"
    "solid voxels) and IoU (against visible ones) are 0 for it.\n"
)


def published_cell(scenario: str, score: str, method: str) -> float | None:
    """The value of Table 1, or None where the paper has none."""
    return published()["table1"].get(scenario, {}).get(score, {}).get(method)


def judge_orderings(study: Study) -> list[Ordering]:
    """The nine orderings of Table 1, Proposed against [11]."""
    claims = [
        claim
        for scenario, values in published()["table1"].items()
        for score in PUBLISHED
        for claim in published_claims(scenario, score.name, values[score.name])
    ]
    return judge(study, claims)


def table_text(study: Study, means: Means, found: list[Ordering]) -> str:
    """The whole of table1.txt."""
    lines = [(scenario, score) for scenario in study.scenarios for score in SHOWN]
    others = [method for method in study.methods if method not in PAIR]
    parts = [
        "Table 1. Occupancy grid accuracy, the paper's beside ours: mean [95% bootstrap interval]",
        f"over seeds; {study.source()}.\n",
        side_by_side(means, PAIR, lines, published_cell),
        *_frames_note(study),
        CAVEAT,
        "Orderings of Table 1: the paper says Proposed is better or worse than [11]; ours is the",
        "difference ldm - circular_buffer, paired by seed, mean [95% bootstrap interval].\n",
        orderings_text(found),
        "Other methods: mean [95% bootstrap interval] over seeds.\n",
        all_methods(means, others, study.scenarios, SHOWN),
        *(f"Note: {note}" for note in study.notes),
    ]
    return "\n".join(parts)


def tabular(study: Study, means: Means) -> str:
    """The paper's arrangement as LaTeX (booktabs), with the other methods below.

    Columns: scenarios x (Proposed, [11]). A score has a row of published values and two of ours,
    mean and interval; another method has mean and interval side by side.
    """
    columns = 2 * len(study.scenarios)
    head = [
        "& "
        + " & ".join(rf"\multicolumn{{2}}{{c}}{{{scenario_name(s)}}}" for s in study.scenarios)
        + r" \\",
        " ".join(rf"\cmidrule(lr){{{i}-{i + 1}}}" for i in range(2, columns + 2, 2)),
        "& " + " & ".join(["Proposed & [11]"] * len(study.scenarios)) + r" \\",
    ]
    rows: list[list[str]] = []
    for score in SHOWN:
        rows += _score_rows(study, means, score)
    others = [method for method in study.methods if method not in PAIR]
    for method in others:
        rows.append([])
        rows.append([rf"\texttt{{{latex_text(method)}}}"] + [""] * columns)
        rows += [_method_row(study, means, method, score) for score in SHOWN]
    return latex_tabular("l" + "c" * columns, head, rows)


def _frames_note(study: Study) -> list[str]:
    frames = published()["setup"]["frames"]["value"]
    if study.frames == frames:
        return []
    return [
        f"Case 1 and case 2 are sums over {study.frames} frames here, over {frames} in the paper:",
        "compare the order of the methods alone.\n",
    ]


def _score_rows(study: Study, means: Means, score: Score) -> list[list[str]]:
    cells = [(scenario, method) for scenario in study.scenarios for method in PAIR]
    paper = [published_cell(s, score.name, m) for s, m in cells]
    ours = [means.find(s, m, score.name) for s, m in cells]
    rows = []
    if any(value is not None for value in paper):
        rows.append(["published"] + [number(value, score.decimals) for value in paper])
    rows.append(["ours"] + [number(value.mean, score.decimals) for value in ours])
    rows.append([""] + [_small_interval(value, score) for value in ours])
    return [[latex_text(score.axis_label)] + [""] * len(cells)] + rows


def _method_row(study: Study, means: Means, method: str, score: Score) -> list[str]:
    found = [means.find(scenario, method, score.name) for scenario in study.scenarios]
    return [latex_text(score.axis_label)] + [
        cell
        for value in found
        for cell in (number(value.mean, score.decimals), _small_interval(value, score))
    ]


def _small_interval(value: Interval, score: Score) -> str:
    _, _, bounds = interval(value, score.decimals).partition(" ")
    return rf"{{\scriptsize {bounds}}}" if bounds else ""
