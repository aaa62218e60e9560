"""Figures 11 to 13 of the paper: the flight outdoors from above, and what the LDM made of it.

Reads   DIR/NAME/SCENARIO.truth.csv and SCENARIO.frames.csv, which stand beside each recorded log, and
        DIR/NAME/SCENARIO.frameN.png, which `ldm render` draws
Writes  DIR/NAME/figures/: figure11 to figure13, each as .png, .pdf, caption .txt
Prints  the names of the pictures

Example: /usr/bin/python3 -m analysis.figures.flight_figures --results results --study flight
"""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Sequence

import matplotlib.image
import numpy as np
from matplotlib.figure import Figure

from analysis.data.command_line import parser, run
from analysis.data.errors import InputError
from analysis.data.recorded import source
from analysis.figures.figure5 import read_world, worlds_figure
from analysis.figures.figure_style import new_figure, save

SCENARIOS = {"figure12": "outdoor1", "figure13": "outdoor2"}
"""Figure -> the scenario of its pictures."""
MAP = np.s_[40:690, 450:1170]
"""Rows and columns of a picture of `ldm render` that the map fills."""
WORDS = (np.s_[:112, :530], np.s_[545:, :515])
"""Those of its heading and its legend, which reach into them: they stand in the caption instead."""
WORLDS_WIDTH, PICTURES_WIDTH = 4.6, 6.4
"""Of Figure 11, and of Figures 12 and 13 [in]."""
LEGEND = (
    "Black dots: LiDAR returns; cubes: occupied voxels, a colour for each cluster; red arrows: "
    "velocity of clusters that the LDM calls dynamic, as long as their motion in 1 s; dark: the UAV."
)


def pictures_of(folder: Path, scenario: str) -> dict[int, Path]:
    """Frame -> picture, in the order of the frames.

    Raises
    ------
    InputError
        If there is none.
    """
    found = {
        int(match[1]): file
        for file in folder.glob(f"{scenario}.frame*.png")
        if (match := re.fullmatch(r".*\.frame(\d+)\.png", file.name))
    }
    if not found:
        raise InputError(f"{folder}: holds no {scenario}.frameN.png; `make figures` draws them")
    return dict(sorted(found.items()))


def sequence_figure(pictures: dict[int, Path]) -> Figure:
    """The maps of all pictures, two in a row, numbered in the order of time."""
    rows = (len(pictures) + 1) // 2
    figure = new_figure(PICTURES_WIDTH, 0.49 * PICTURES_WIDTH * rows)
    panels = figure.subplots(rows, 2, squeeze=False).ravel()
    for axes in panels:
        axes.set_axis_off()
    for number, (axes, (frame, file)) in enumerate(zip(panels, pictures.items()), start=1):
        axes.imshow(_map_of(file))
        axes.set_title(f"{number}: frame {frame}")
    return figure


def _map_of(file: Path) -> np.ndarray:
    picture = np.array(matplotlib.image.imread(file))
    for words in WORDS:
        picture[words] = 1  # white
    return picture[MAP]


def draw(worlds: Path, folder: Path) -> list[Path]:
    """Draw Figures 11 to 13 from one folder into another; returns the pictures.

    Raises
    ------
    InputError
        If a world or a picture is missing.
    """
    truths = {name: worlds / f"{name}.truth.csv" for name in SCENARIOS.values()}
    caption = (
        "Figure 11. The scenarios of the flight outdoors from above: bounding boxes at the first "
        "frame, blue standing, green walking; arrows: from the start to the point farthest from it. "
        f"Vermillion: path of the UAV, from the dot. {source([*truths.values()])}"
    )
    worlds_read = {name: read_world(file) for name, file in truths.items()}
    figure = worlds_figure(worlds_read, WORLDS_WIDTH)
    made = save(figure, folder / "figure11", caption)
    for name, scenario in SCENARIOS.items():
        pictures = pictures_of(worlds, scenario)
        caption = (
            f"Figure {name.removeprefix('figure')}. The LDM in {scenario}; numbers are the order of "
            f"time. {LEGEND} {source([*pictures.values()])}"
        )
        made += save(sequence_figure(pictures), folder / name, caption)
    return made


def main(argv: Sequence[str] | None = None) -> None:
    """Draw the figures of one folder."""
    args = parser(__doc__, study="flight").parse_args(argv)
    folder = args.results / args.study
    print(*draw(folder, folder / "figures"), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
