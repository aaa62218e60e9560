"""Small multiples of scores: lines along a swept number, or dots for variants side by side."""

from __future__ import annotations

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullFormatter

from analysis.data.scores import Score
from analysis.data.sweep_axis import SweepAxis, spans_decades
from analysis.figures.figure_style import (
    PAGE_WIDTH,
    PLAIN_NUMBERS,
    legend_above,
    method_styles,
    new_figure,
)
from analysis.tables.beside import scenario_name

MOST_TICKS = 6
_LINE_STYLES = ["-", "--", ":", "-."]


def line_figure(
    table: pd.DataFrame, axis: SweepAxis, methods: list[str], scores: list[Score]
) -> Figure:
    """A row of panels for each score, a column for each scenario, a line for each method.

    Parameters
    ----------
    table : what `mean_table` gives for the study
    """
    scenarios = sorted(table["scenario"].unique())
    figure = new_figure(PAGE_WIDTH, 0.7 + 1.45 * len(scores))
    panels = figure.subplots(len(scores), len(scenarios), sharex=True, sharey="row", squeeze=False)
    for row, score in zip(panels, scores):
        of_score = table[table["score"] == score.name]
        for axes, scenario in zip(row, scenarios):
            _lines(axes, of_score[of_score["scenario"] == scenario], axis, methods)
        row[0].set_ylabel(_two_lines(score.axis_label))
        if not score.name.endswith("_pct") and spans_decades(list(of_score["mean"])):
            row[0].set_yscale("log")
            row[0].yaxis.set_major_formatter(PLAIN_NUMBERS)
    for axes, scenario in zip(panels[0], scenarios):
        axes.set_title(scenario_name(scenario))
    if axis.logarithmic:
        panels[0][0].set_xscale("log")
        panels[0][0].xaxis.set_major_formatter(PLAIN_NUMBERS)
        panels[0][0].xaxis.set_minor_formatter(NullFormatter())
        if not spans_decades(axis.values):  # powers of ten alone would be one tick, or none
            panels[0][0].set_xticks(axis.values[:: 1 + len(axis.values) // MOST_TICKS])
    figure.supxlabel(axis.label, fontsize=8)
    figure.align_ylabels()
    _mark_empty(panels)
    _legend(figure, panels[0][0], axis, methods)
    return figure


def dot_figure(
    table: pd.DataFrame,
    names: dict[tuple[str, str], str],
    styles_of: list[str],
    scores: list[Score],
) -> Figure:
    """A row of panels for each scenario, a column for each score, a line of dots for each variant.

    Parameters
    ----------
    table : what `mean_table` gives for the study
    names : (method, point) -> name of the variant, in the order from above; several methods of one
        name share a line
    styles_of : methods that are told apart by colour and marker; empty if the lines do that
    """
    scenarios = sorted(table["scenario"].unique())
    lines = list(dict.fromkeys(names.values()))
    table = table.assign(line=[lines.index(names[r.method, r.point]) for r in table.itertuples()])
    rows = 0.16 * len(lines) * max(1, 0.6 * len(styles_of))
    figure = new_figure(PAGE_WIDTH, 0.7 + len(scenarios) * (rows + 0.35))
    panels = figure.subplots(len(scenarios), len(scores), sharex="col", sharey=True, squeeze=False)
    for row, scenario in zip(panels, scenarios):
        for axes, score in zip(row, scores):
            chosen = (table["scenario"] == scenario) & (table["score"] == score.name)
            _dots(axes, table[chosen], styles_of)
        row[0].set_title(scenario_name(scenario), loc="left")
        row[0].set_yticks(range(len(lines)), lines)
        row[0].set_ylim(len(lines) - 0.5, -0.5)
    for axes, score in zip(panels[-1], scores):
        axes.set_xlabel(_two_lines(score.axis_label))
        axes.xaxis.set_major_locator(MaxNLocator(3, min_n_ticks=2))
        axes.ticklabel_format(axis="x", useOffset=False)
    _mark_empty(panels)
    if styles_of:
        for method, (colour, marker) in method_styles(styles_of).items():
            panels[0][0].plot([], [], marker, color=colour, markersize=4, label=method)
        legend_above(figure, panels[0][0], columns=min(4, len(styles_of)))
    return figure


def _dots(axes: Axes, table: pd.DataFrame, styles_of: list[str]) -> None:
    """Mean and interval of each row at its `line`; methods that share one stand closely below."""
    styles = method_styles(styles_of)
    step = 0.7 / max(1, len(styles_of))
    for mean in table.itertuples():
        colour, marker = styles.get(mean.method, ("black", "o"))
        shift = (styles_of.index(mean.method) + 0.5) * step - 0.35 if styles_of else 0
        y = mean.line + shift
        axes.plot(mean.mean, y, marker, color=colour, markersize=3.5)
        axes.plot([mean.low, mean.high], [y, y], color=colour)


def _lines(axes: Axes, table: pd.DataFrame, axis: SweepAxis, methods: list[str]) -> None:
    styles = method_styles(methods)
    others = list(dict.fromkeys(axis.line.values()))
    for method in methods:
        colour, marker = styles[method]
        for k, other in enumerate(others):
            on_line = table["point"].map(axis.line) == other
            found = table[on_line & (table["method"] == method)]
            found = found.assign(x=found["point"].map(axis.place)).sort_values("x")
            spread = np.nan_to_num([found["mean"] - found["low"], found["high"] - found["mean"]])
            if len(found):
                axes.errorbar(
                    found["x"], found["mean"], spread, color=colour, marker=marker, markersize=3,
                    linestyle=_LINE_STYLES[k % len(_LINE_STYLES)], capsize=1.5, elinewidth=0.8,
                )  # fmt: skip


def _mark_empty(panels: np.ndarray) -> None:
    """Say in a panel without data that it has none: a scenario may lack a kind of obstacle."""
    for axes in panels.flat:
        if not axes.lines:
            axes.text(0.5, 0.5, "not defined", transform=axes.transAxes, ha="center", color="grey")


def _legend(figure: Figure, axes: Axes, axis: SweepAxis, methods: list[str]) -> None:
    for method, (colour, marker) in method_styles(methods).items():
        axes.plot([], [], marker=marker, color=colour, markersize=3, label=method)
    others = list(dict.fromkeys(axis.line.values()))
    if len(others) > 1:
        for k, other in enumerate(others):
            style = _LINE_STYLES[k % len(_LINE_STYLES)]
            axes.plot([], [], style, color="grey", label=other)
    legend_above(figure, axes, columns=4)


def _two_lines(label: str) -> str:
    """Break a label before its unit."""
    return label.replace(" (", "\n(", 1)
