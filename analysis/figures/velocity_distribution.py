"""Velocity errors of all seeds, per method and scenario; `velocity_figures` writes the figure."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analysis.data.errors import InputError
from analysis.data.records import Study
from analysis.data.scores import Score
from analysis.data.statistics import mean_interval
from analysis.figures.figure_style import (
    BLUE,
    COLUMN_WIDTH,
    legend_above,
    method_styles,
    new_figure,
)
from analysis.tables import velocity_table
from analysis.tables.beside import scenario_name

SPREAD = 0.7
"""Share of a scenario's place on the axis that its methods take up."""


def distribution_figure(study: Study) -> Figure:
    """One panel for static and one for dynamic objects: each seed, mean and 95% interval.

    A blue bar stands where the paper gives a value.

    Raises
    ------
    InputError
        If no trial has a velocity error.
    """
    names = [score.name for score in velocity_table.PUBLISHED]
    has_values = study.trials.groupby("method")[names].count().sum(axis=1) > 0
    methods = [method for method in study.methods if has_values[method]]
    if not methods:
        raise InputError(f"{study.folder}: no trial has {' or '.join(names)}")
    figure = new_figure(COLUMN_WIDTH, 3.6)
    panels = figure.subplots(len(names), 1)
    for axes, score in zip(panels, velocity_table.PUBLISHED):
        _panel(axes, study, methods, score)
    legend_above(figure, panels[0], columns=2)
    return figure


def distribution_caption(study: Study) -> str:
    """What the figure shows and where it is from."""
    return (
        "Velocity errors over seeds. Small marks: one seed each; large marks: mean with its 95% "
        "bootstrap interval; blue bars: the values of Sec. 4.1.3 of the paper. "
        f"Source: {study.source()}."
    )


def _panel(axes: Axes, study: Study, methods: list[str], score: Score) -> None:
    styles = method_styles(methods)
    step = SPREAD / len(methods)
    for k, method in enumerate(methods):
        colour, marker = styles[method]
        axes.plot([], [], marker, color=colour, markersize=4, label=method)
        for place, scenario in enumerate(study.scenarios):
            x = place + (k - (len(methods) - 1) / 2) * step
            of_method = study.trials[
                (study.trials["scenario"] == scenario) & (study.trials["method"] == method)
            ]
            values = of_method[score.name].dropna().to_numpy()
            shift = np.linspace(-0.2, 0.2, len(values)) * step
            axes.plot(x + shift, values, ".", color=colour, markersize=2.5, alpha=0.6)
            mean = mean_interval(values)
            if mean.n:
                axes.errorbar(
                    x, mean.mean, [[mean.mean - mean.low], [mean.high - mean.mean]], fmt=marker,
                    color=colour, markersize=4, capsize=2, elinewidth=1,
                )  # fmt: skip
            paper = velocity_table.published_cell(scenario, score.name, method)
            if paper is not None:
                axes.hlines(paper, x - 0.45 * step, x + 0.45 * step, color=BLUE, linewidth=2)
    axes.plot([], [], color=BLUE, linewidth=2, label="paper")
    axes.set_xticks(range(len(study.scenarios)), [scenario_name(s) for s in study.scenarios])
    axes.set_xlim(-0.5, len(study.scenarios) - 0.5)
    axes.set_ylim(bottom=0)
    axes.set_ylabel(score.axis_label.replace(" (", "\n("))
    axes.grid(False, axis="x")
