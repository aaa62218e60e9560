"""Who reaches the goal, over the obstacles' number, speed and reversals; table and tests beside it.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/figures/: avoidance.png, .pdf, caption .txt
        DIR/NAME/tables/: avoidance.txt, avoidance.csv, avoidance.tex, avoidance_tests.csv
Prints  the table and the names of the pictures

Example: /usr/bin/python3 -m analysis.figures.avoidance_figures --results results --study avoidance
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Sequence

from matplotlib.figure import Figure

from analysis.data.command_line import parser, run, study_of
from analysis.data.records import Study
from analysis.figures.figure_style import GREY, PAGE_WIDTH, legend_above, method_styles, new_figure, save
from analysis.tables.avoidance_table import arms, success, write_table

PANELS = (
    ("obstacles that move straight on, and four that stand", r"(?:moving|still)\d+(?:_\d+)?"),
    ("10 that turn back at 1 m/s", r"reversing_\d+|moving10_10"),
)
"""Title of a panel, and the names of the worlds in it."""
HEIGHT = 2.9  # [in]
SPREAD = 0.75
"""Share of the distance of two worlds over which the arms' dots are spread."""


def world_label(world: str, reversing: bool) -> str:
    """`10 at 0.5 m/s`; among those that turn, how often they do a second."""
    number, tenths = (re.search(r"(\d+)(?:_(\d+))?", world) or re.match("", "")).groups()
    if reversing:
        return "never" if world.startswith("moving") else f"{int(number) / 10:g} /s"
    return f"{number}, at rest" if tenths is None else f"{number} at\n{int(tenths) / 10:g} m/s"


def _order(world: str) -> tuple:
    digits = [int(digits) for digits in re.findall(r"\d+", world)]
    return (world.startswith("reversing"), len(digits) > 1, digits)


def success_figure(study: Study) -> Figure:
    """A panel for each list of worlds, an arm a colour: share with its interval."""
    shown = arms(study)
    # Colours are for eight; blind flight is no map's.
    styles = method_styles([arm for arm in shown if arm != "blind"]) | {"blind": (GREY, "x")}
    worlds = [[w for w in sorted(study.scenarios, key=_order) if re.fullmatch(pattern, w)]
              for _, pattern in PANELS]  # fmt: skip
    kept = [i for i, found in enumerate(worlds) if found]
    figure = new_figure(PAGE_WIDTH, HEIGHT)
    panels = figure.subplots(1, len(kept), sharey=True, squeeze=False,
                             width_ratios=[len(worlds[i]) for i in kept])[0]  # fmt: skip
    for axes, i in zip(panels, kept):
        for k, arm in enumerate(shown):
            colour, marker = styles[arm]
            shares = [success(study, world, arm) for world in worlds[i]]
            offset = SPREAD * ((k + 0.5) / len(shown) - 0.5)
            errors = [[100 * (s.mean - s.low) for s in shares], [100 * (s.high - s.mean) for s in shares]]
            axes.errorbar([x + offset for x in range(len(shares))], [100 * s.mean for s in shares],
                          yerr=errors, color=colour, marker=marker, markersize=4, linestyle="none",
                          elinewidth=0.8, label=arm)  # fmt: skip
        axes.set_title(PANELS[i][0])
        axes.set_xticks(range(len(worlds[i])), [world_label(w, i == 1) for w in worlds[i]])
        axes.set_xlim(-0.5, len(worlds[i]) - 0.5)
        axes.grid(False, axis="x")
        axes.set_ylim(-3, 103)
    panels[0].set_ylabel("flights that reach the goal (%)")
    legend_above(figure, panels[0], columns=4)
    return figure


def draw(study: Study, folder: Path) -> list[Path]:
    """Draw the figure of a study without a sweep into a folder; returns the pictures."""
    caption = (
        "Flights that reach their goal 20 m away, with 95% Wilson intervals: one planner, what it "
        f"knows differs. {study.source()}."
    )
    return save(success_figure(study), folder / "avoidance", caption)


def main(argv: Sequence[str] | None = None) -> None:
    args = parser(__doc__, "avoidance").parse_args(argv)
    study = study_of(args)
    print(write_table(study))
    if len(study.points) > 1:
        return  # a sweep is a table alone
    print(*draw(study, study.folder / "figures"), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
