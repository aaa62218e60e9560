"""Blocks of text with published values beside ours, and with the methods the paper lacks."""

from __future__ import annotations

from typing import Callable, Iterable, Sequence

import pandas as pd

from analysis.data.published import PAPER_NAMES
from analysis.data.scores import Score
from analysis.tables.mean_table import Means
from analysis.tables.text_table import aligned, interval, number

PublishedCell = Callable[[str, str, str], "float | None"]
"""(scenario, score, method) -> the paper's value, or None where it has none."""


def scenario_name(scenario: str) -> str:
    """`scenario1` as the paper writes it; other names as they are."""
    return scenario.replace("scenario", "Scenario ")


def side_by_side(
    means: Means,
    columns: Sequence[str],
    lines: Iterable[tuple[str, Score]],
    published_cell: PublishedCell,
) -> str:
    """One line for each (scenario, score): the paper's value and ours, for each method of `columns`; the
    paper's once where neighbours are readings of one name."""
    head = ["", ""]
    for method, begins in zip(columns, _begins(columns)):
        head += [f"{PAPER_NAMES[method]}: paper"] if begins else []
        head.append(f"ours ({method})")
    rows = []
    for scenario, score in lines:
        row = [scenario_name(scenario), score.axis_label]
        for method, begins in zip(columns, _begins(columns)):
            if begins:
                row.append(number(published_cell(scenario, score.name, method), score.decimals))
            row.append(interval(means.find(scenario, method, score.name), score.decimals))
        rows.append(row)
    return aligned(head, separate(rows), left=2)


def _begins(columns: Sequence[str]) -> list[bool]:
    """Whether a method is the first of its name in the paper."""
    names = [PAPER_NAMES[method] for method in columns]
    return [name not in names[:k] for k, name in enumerate(names)]


def all_methods(
    means: Means, methods: Sequence[str], scenarios: Sequence[str], scores: Sequence[Score]
) -> str:
    """One line for each scenario and method that has one of the scores, a column for each score."""
    rows = []
    for scenario in scenarios:
        for method in methods:
            found = [means.find(scenario, method, score.name) for score in scores]
            if any(value.n for value in found):
                cells = [interval(v, s.decimals) for v, s in zip(found, scores)]
                rows.append([scenario_name(scenario), method, *cells])
    if not rows:
        return "none in this study\n"
    return aligned(["", "", *(s.axis_label for s in scores)], separate(rows), left=2)


def long_table(
    table: pd.DataFrame, scores: Sequence[Score], published_cell: PublishedCell
) -> pd.DataFrame:
    """The rows of a mean table that hold `scores`, with the paper's value as one more column."""
    shown = table[table["score"].isin([score.name for score in scores])].drop(columns="point")
    cells = [published_cell(row.scenario, row.score, row.method) for row in shown.itertuples()]
    return shown.assign(published=pd.array(cells, dtype="Float64"))


def separate(rows: list[list[str]]) -> list[list[str]]:
    """Put an empty row between rows of different scenarios, their first cell."""
    spaced: list[list[str]] = []
    for row in rows:
        if spaced and spaced[-1][0] != row[0]:
            spaced.append([])
        spaced.append(row)
    return spaced
