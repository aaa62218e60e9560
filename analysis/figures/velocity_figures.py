"""Figures 6 to 9 of the paper, and the velocity errors of all seeds in one figure.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/figures/: figure6 to figure9 and velocity_errors, each as .png, .pdf, caption .txt
Prints  the names of the pictures

The obstacle of Figure 6 is the static object of scenario2, that of Figures 7 to 9 the dynamic
object of scenario1 with the longest contiguous time in the map (of equally long ones the lowest
number), in the lowest replicate that has one. A rule picks it, not its looks.

Example: /usr/bin/python3 -m analysis.figures.velocity_figures --results results --study table1
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analysis.data.command_line import add_method, parser, run, study_of
from analysis.data.errors import InputError
from analysis.data.published import display_name
from analysis.data.records import Study
from analysis.data.series import ObjectSeries, longest_in_map, read_series
from analysis.figures.figure_style import (
    BLACK,
    BLUE,
    COLUMN_WIDTH,
    VERMILLION,
    legend_above,
    new_figure,
    save,
)
from analysis.figures.velocity_distribution import distribution_caption, distribution_figure

PAIR = ("ldm", "circular_buffer_pf_eq17")
"""Of the two readings of "[11] with PF" the one that comes nearer to the paper (docs/conditions.md)."""
NAMES = {"ldm": "LDM", "circular_buffer_pf_eq17": "[11] with PF"}
STATIC_SCENARIO, DYNAMIC_SCENARIO = "scenario2", "scenario1"
HEIGHT = 2.2  # [in]


@dataclass(frozen=True)
class Shown:
    """The obstacle that the figures show."""

    by_method: dict[str, ObjectSeries]
    rule: str  # which it is and why, for the caption

    @property
    def truth(self) -> ObjectSeries:
        """Any of the series: time and truth are the same in both."""
        return next(iter(self.by_method.values()))


def choose_shown(
    study: Study, scenario: str, dynamic: bool, pair: tuple[str, str] = PAIR
) -> Shown:
    """Pick the obstacle by the rule in the head of this file.

    Raises
    ------
    InputError
        If no replicate has both methods and such an object, or the records of the methods disagree
        on when it was in the map.
    """
    kind = "dynamic" if dynamic else "static"
    for replicate, files in _common_replicates(study, scenario, pair):
        chosen = {m: longest_in_map(read_series(file), dynamic) for m, file in files.items()}
        if all(found is None for found in chosen.values()):
            continue
        if not _same_stay(*chosen.values()):
            names = " and ".join(file.name for file in files.values())
            raise InputError(f"{study.folder}: {names} disagree on when objects were in the map")
        shown = chosen[pair[0]]
        rule = (
            f"{kind.capitalize()} object {shown.object} of {scenario}, replicate {replicate}: of "
            f"the {kind} objects the one with the longest contiguous time in the map "
            f"({shown.time[0]:.1f} s to {shown.time[-1]:.1f} s), in the lowest replicate that has "
            "one. "
            "A line is broken where no cluster was matched to the object. "
            f"Source: {study.source()}."
        )
        return Shown(chosen, rule)
    raise InputError(
        f"{study.folder}: no replicate of {scenario} has {pair[0]}, {pair[1]} and a {kind} object "
        "in the map"
    )


def error_figure(shown: Shown) -> Figure:
    """Figure 6: |velocity error| over time."""
    figure = new_figure(COLUMN_WIDTH, HEIGHT)
    axes = figure.subplots()
    for method, series in _paper_order(shown):
        axes.plot(series.time, series.error(), **_line(method), label=NAMES.get(method, method))
    axes.set(xlabel="time (s)", ylabel="velocity error (m/s)")
    axes.set_ylim(bottom=0)
    _finish(figure, axes, shown)
    return figure


def component_figure(shown: Shown, axis: int) -> Figure:
    """Figures 7, 8, 9: velocity along x (axis 0), y (1) or z (2) over time, and the truth."""
    figure = new_figure(COLUMN_WIDTH, HEIGHT)
    axes = figure.subplots()
    for method, series in _paper_order(shown):
        axes.plot(series.time, series.estimate[:, axis], **_line(method), label=NAMES.get(method, method))
    # Wide and behind: the estimates must stay visible where they are right.
    axes.plot(
        shown.truth.time, shown.truth.truth[:, axis], color=BLUE, linewidth=2.2, zorder=1.5,
        label="ground truth",
    )  # fmt: skip
    axes.set(xlabel="time (s)", ylabel=f"velocity in {'xyz'[axis]} (m/s)")
    _finish(figure, axes, shown)
    return figure


def _finish(figure: Figure, axes: Axes, shown: Shown) -> None:
    time = shown.truth.time
    axes.set_xlim(time[0], time[-1] if len(time) > 1 else time[0] + 0.1)
    legend_above(figure, axes, columns=3)


def _paper_order(shown: Shown) -> list[tuple[str, ObjectSeries]]:
    """[11] with PF first, so that the LDM is drawn over it."""
    return list(reversed(shown.by_method.items()))


def _line(method: str) -> dict:
    if method != PAIR[1]:
        return {"color": BLACK, "linestyle": "-", "linewidth": 1.0}
    return {"color": VERMILLION, "linestyle": ":", "linewidth": 1.4}


def _common_replicates(
    study: Study, scenario: str, pair: tuple[str, str]
) -> list[tuple[int, dict[str, Path]]]:
    """Replicates that have both methods, ascending, with the record of each method."""
    trials = study.trials[study.trials["scenario"] == scenario]
    files = {m: trials[trials["method"] == m].set_index("replicate")["file"] for m in pair}
    common = set.intersection(*(set(of_method.index) for of_method in files.values()))
    return [(r, {m: of_method[r] for m, of_method in files.items()}) for r in sorted(common)]


def _same_stay(a: ObjectSeries | None, b: ObjectSeries | None) -> bool:
    if a is None or b is None:
        return False
    return a.object == b.object and np.array_equal(a.frame, b.frame)


def draw(study: Study, folder: Path, method: str = PAIR[0]) -> list[Path]:
    """Make all figures of a study in `folder`; returns the pictures. Those of another method than the LDM
    have its name at the end of theirs."""
    pair, tail = (method, PAIR[1]), "" if method == PAIR[0] else f"_{method}"
    styles = f"Dotted: {display_name(pair[1])}; black: {display_name(pair[0])}"

    static = choose_shown(study, STATIC_SCENARIO, False, pair)
    caption = f"Figure 6. Estimated velocity error of a static obstacle. {styles}. {static.rule}"
    made = save(error_figure(static), folder / f"figure6{tail}", caption)
    dynamic = choose_shown(study, DYNAMIC_SCENARIO, True, pair)
    for axis in range(3):
        caption = (
            f"Figure {7 + axis}. Estimated {'xyz'[axis]} direction velocity of a dynamic obstacle. "
            f"{styles}; blue: ground truth. {dynamic.rule}"
        )
        made += save(component_figure(dynamic, axis), folder / f"figure{7 + axis}{tail}", caption)
    if tail:
        return made
    return made + save(
        distribution_figure(study), folder / "velocity_errors", distribution_caption(study)
    )


def main(argv: Sequence[str] | None = None) -> None:
    """Make the figures of one study."""
    args_parser = parser(__doc__, study="table1")
    add_method(args_parser, PAIR[0])
    args = args_parser.parse_args(argv)
    study = study_of(args, [args.method], swept=False)
    print(*draw(study, study.folder / "figures", args.method), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
