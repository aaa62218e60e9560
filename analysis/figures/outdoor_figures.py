"""Figures 14 to 16 of the paper, the velocities of the people outdoors, and its claims beside ours.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/figures/: figure14 to figure16, each as .png, .pdf, caption .txt
        DIR/NAME/tables/: outdoor.txt, outdoor.csv
Prints  the table and the names of the pictures

The figures show the persons of outdoor1, in the order of the scenario, in the lowest replicate of the
LDM: the first stands, the second and the third walk past one another and back.

Example: /usr/bin/python3 -m analysis.figures.outdoor_figures --results results --study outdoor
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analysis.data.command_line import add_method, parser, run, study_of
from analysis.data.errors import InputError
from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.series import ObjectSeries, read_series
from analysis.figures.figure_style import (
    BLACK,
    BLUE,
    COLUMN_WIDTH,
    GREY,
    legend_above,
    new_figure,
    save,
)
from analysis.tables.outdoor_table import SCENARIO, write_table

METHOD = "ldm"
PERSONS = {
    "figure14": "the standing person (Person1)",
    "figure15": "a walking person, the nearer to the UAV (Person2)",
    "figure16": "a walking person, the farther, whom Person2 hides when they pass (Person3)",
}
"""Figure -> whose velocity it shows, in the order of the objects of the scenario."""
HEIGHT = 3.6  # [in]


def person_figure(person: ObjectSeries, label: str = "LDM") -> Figure:
    """Estimated and true velocity along x, y and z over the frames, a panel each."""
    figure = new_figure(COLUMN_WIDTH, HEIGHT)
    panels = figure.subplots(3, 1, sharex=True)
    for axis, axes in enumerate(panels):
        _panel(axes, person, axis, label)
    panels[-1].set_xlabel("frame")
    panels[-1].set_xlim(person.frame[0], max(person.frame[-1], person.frame[0] + 1))
    legend_above(figure, panels[0], columns=3)
    return figure


def _panel(axes: Axes, person: ObjectSeries, axis: int, label: str) -> None:
    # Wide and behind: the estimate must stay visible where it is right.
    axes.plot(person.frame, person.truth[:, axis], color=BLUE, linewidth=2.2, zorder=1.5,
              label="ground truth")  # fmt: skip
    axes.plot(person.frame, person.estimate[:, axis], color=BLACK, linewidth=0.9, label=label)
    axes.set_ylabel(f"{'xyz'[axis]} (m/s)")
    if not person.dynamic:
        bound = published()["outdoor"]["static"]["largest_error_mps"]
        for sign in (-1, 1):
            axes.axhline(sign * bound, color=BLACK, linestyle="--", linewidth=0.7,
                         label=f"paper: {bound} m/s" if sign > 0 else None)  # fmt: skip
    for k, (begin, end) in enumerate(hidden_spans(person)):
        axes.axvspan(begin, end, color=GREY, alpha=0.35, linewidth=0,
                     label=None if k else "hidden")  # fmt: skip


def hidden_spans(person: ObjectSeries) -> list[tuple[float, float]]:
    """First and last frame of each time in which no ray met the person, half a frame wider."""
    return [(person.frame[a] - 0.5, person.frame[b - 1] + 0.5) for a, b in person.hidden_runs()]


def draw(study: Study, folder: Path, method: str = METHOD) -> list[Path]:
    """Make Figures 14 to 16 in `folder`; returns the pictures. Those of another method than the LDM have its
    name at the end of theirs.

    Raises
    ------
    InputError
        If there is no trial of the method in outdoor1, or it has not these persons.
    """
    trials = study.trials[
        (study.trials["scenario"] == SCENARIO) & (study.trials["method"] == method)
    ]
    if trials.empty:
        raise InputError(f"{study.folder}: holds no trial of {method} in {SCENARIO}")
    trial = trials.sort_values("replicate").iloc[0]
    persons = read_series(trial["file"])
    if len(persons) != len(PERSONS):
        raise InputError(f"{trial['file']}: series of {len(persons)} objects, not {len(PERSONS)}")
    made, tail = [], "" if method == METHOD else f"_{method}"
    label = "LDM" if method == METHOD else method
    for (name, who), person in zip(PERSONS.items(), persons):
        caption = (
            f"Figure {name.removeprefix('figure')}. Estimated velocity of {who} of {SCENARIO}, "
            f"replicate {trial['replicate']}, along x, y and z. A line is broken where no cluster "
            f"was matched. Source: {study.source()}."
        )
        made += save(person_figure(person, label), folder / f"{name}{tail}", caption)
    return made


def main(argv: Sequence[str] | None = None) -> None:
    """Make the figures and the table of one study."""
    args_parser = parser(__doc__, study="outdoor")
    add_method(args_parser, METHOD)
    args = args_parser.parse_args(argv)
    study = study_of(args, [args.method], swept=False)
    if args.method == METHOD:
        print(write_table(study))
    print(*draw(study, study.folder / "figures", args.method), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
