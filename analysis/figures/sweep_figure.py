"""One figure and one table for a study that sweeps parameters or compares variants.

A swept number gives small multiples of scores (rows) and scenarios (columns) with a line for each
method; swept words, and a study without a sweep, give a dot for each variant. Bars are 95%
bootstrap intervals over seeds.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/figures/NAME.{png,pdf,txt} and DIR/NAME/tables/NAME.{txt,csv}
Prints  the table

Example: /usr/bin/python3 -m analysis.figures.sweep_figure --results results --study particles
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import pandas as pd
from matplotlib.figure import Figure

from analysis.data.command_line import add_scores, parser, run, study_of
from analysis.data.errors import InputError
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study
from analysis.data.scores import MAIN_SCORES, Score, find_scores
from analysis.data.statistics import Interval
from analysis.data.sweep_axis import sweep_axis
from analysis.figures.figure_style import save
from analysis.figures.sweep_plots import dot_figure, line_figure
from analysis.tables.beside import scenario_name
from analysis.tables.mean_table import mean_table
from analysis.tables.text_table import NOTHING, aligned, interval


def sweep_figure(study: Study, table: pd.DataFrame, scores: list[Score]) -> Figure:
    """Lines where a number is swept, dots otherwise."""
    axis = sweep_axis(study.points)
    if axis.numeric:
        return line_figure(table, axis, study.methods, scores)
    if len(study.points) == 1:
        point = next(iter(study.points))
        return dot_figure(table, {(m, point): m for m in study.methods}, [], scores)
    names = {(m, point): name for point, name in axis.names.items() for m in study.methods}
    told_apart = study.methods if len(study.methods) > 1 else []
    return dot_figure(table, names, told_apart, scores)


def table_text(study: Study, table: pd.DataFrame, scores: list[Score]) -> str:
    """One line for each scenario, method and point, a column for each score."""
    axis = sweep_axis(study.points)
    found = {
        (row.scenario, row.method, row.point, row.score): Interval(
            row.mean, row.low, row.high, row.seeds
        )
        for row in table.itertuples()
    }
    rows: list[list[str]] = []
    for scenario in study.scenarios:
        for method in study.methods:
            for point in axis.order:
                cells = [_cell(found.get((scenario, method, point, s.name)), s) for s in scores]
                rows.append([*filter(None, [scenario_name(scenario), method, point]), *cells])
        rows.append([])
    left = ["", "method", "point"] if any(study.points) else ["", "method"]
    head = [*left, *(score.axis_label for score in scores)]
    title = f"Mean [95% bootstrap interval] over seeds; {study.source()}.\n"
    notes = [f"Note: {note}" for note in study.notes]
    return "\n".join([title, aligned(head, rows[:-1], left=len(left)), *notes])


def shown_scores(table: pd.DataFrame, scores: list[Score], study: Study) -> list[Score]:
    """Those of `scores` that some trial has.

    Raises
    ------
    InputError
        If there is none.
    """
    found = [score for score in scores if (table["score"] == score.name).any()]
    if not found:
        names = ", ".join(score.name for score in scores)
        raise InputError(f"{study.folder}: no trial has {names}")
    return found


def _cell(value: Interval | None, score: Score) -> str:
    return NOTHING if value is None else interval(value, score.decimals)


def draw(study: Study, table: pd.DataFrame, scores: list[Score], stem: Path) -> list[Path]:
    """Make the figure STEM.png, STEM.pdf; returns the pictures."""
    caption = (
        "Mean over seeds with its 95% bootstrap interval; all methods meet the same worlds. "
        f"Source: {study.source()}."
    )
    return save(sweep_figure(study, table, scores), stem, caption)


def main(argv: Sequence[str] | None = None) -> None:
    """Make figure and table of one study."""
    args_parser = parser(__doc__, study="ablation")
    add_scores(args_parser, MAIN_SCORES, "to show")
    args = args_parser.parse_args(argv)
    scores = find_scores(args.scores)
    study = study_of(args)
    table = mean_table(study, scores)
    scores = shown_scores(table, scores, study)
    text = table_text(study, table, scores)
    points = pd.DataFrame([{"point": label} | point for label, point in study.points.items()])
    write_text(study.folder / "tables" / f"{study.name}.txt", text)
    write_csv(study.folder / "tables" / f"{study.name}.csv", table.merge(points, on="point"))
    print(text, *draw(study, table, scores, study.folder / "figures" / study.name), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
