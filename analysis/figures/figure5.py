"""Figure 5 of the paper: the worlds of the scenarios from above, with all trajectories.

Reads   DIR/NAME/SCENARIO.truth.csv and SCENARIO.frames.csv, which stand beside each recorded log:
        ldm simulate SCENARIO --seed N -o DIR/NAME/SCENARIO.rawlog
Writes  DIR/NAME/figures/figure5.{png,pdf,txt}

Example: /usr/bin/python3 -m analysis.figures.figure5 --results results --study worlds
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from analysis.data.command_line import parser, run
from analysis.data.errors import InputError
from analysis.data.recorded import source
from analysis.figures.figure_style import (
    BLACK,
    BLUE,
    GREEN,
    PAGE_WIDTH,
    VERMILLION,
    legend_above,
    new_figure,
    save,
)
from analysis.tables.beside import scenario_name

TRUTH_COLUMNS = ["frame", "id", "dynamic", "x_m", "y_m", "sx_m", "sy_m"]
FRAMES_COLUMNS = ["frame", "x_m", "y_m"]


def read_world(truth_file: Path) -> tuple[pd.DataFrame, pd.DataFrame]:
    """Truth of the objects, a row for each object and frame, and path of the UAV, a row a frame.

    Raises
    ------
    InputError
        Naming the file that is missing, unreadable, empty, or lacks a column.
    """
    frames_file = truth_file.with_name(truth_file.name.replace(".truth.csv", ".frames.csv"))
    return _read(truth_file, TRUTH_COLUMNS), _read(frames_file, FRAMES_COLUMNS)


def worlds_figure(
    worlds: dict[str, tuple[pd.DataFrame, pd.DataFrame]], width: float = PAGE_WIDTH
) -> Figure:
    """One panel for each scenario name -> what `read_world` gives; all to the same scale.

    `width` of the whole figure [in].
    """
    panel_width = (width - 0.6) / len(worlds)
    figure = new_figure(width, 0.9 + panel_width * _height_by_width(worlds))
    panels = figure.subplots(1, len(worlds), sharex=True, sharey=True, squeeze=False)[0]
    for axes, (scenario, (truth, uav)) in zip(panels, worlds.items()):
        for _, of_object in truth.groupby("id"):
            _draw_object(axes, of_object)
        axes.plot(uav["x_m"], uav["y_m"], color=VERMILLION, linewidth=1.0, zorder=3)
        axes.plot(uav["x_m"].iloc[0], uav["y_m"].iloc[0], "o", color=VERMILLION, markersize=4)
        axes.set_title(scenario_name(scenario))
        axes.set_xlabel("x (m)")
        axes.set_aspect("equal")
        axes.margins(0.03)
    panels[0].set_ylabel("y (m)")
    _name_colours(panels[0])
    legend_above(figure, panels[0], columns=4 if width >= PAGE_WIDTH else 2)
    return figure


def _draw_object(axes: Axes, rows: pd.DataFrame) -> None:
    """The bounding box at the first frame; of a moving object also its path and first leg."""
    path = rows[["x_m", "y_m"]].to_numpy()
    size = rows[["sx_m", "sy_m"]].iloc[0].to_numpy()
    moves = bool(rows["dynamic"].iloc[0])
    colour = GREEN if moves else BLUE
    axes.add_patch(Rectangle(path[0] - size / 2, *size, facecolor=colour, edgecolor="none"))
    if moves:
        axes.plot(*path.T, color=GREEN, linewidth=0.6, alpha=0.7)
        # Most obstacles go to and fro: an arrow to the farthest point is where they set out for.
        farthest = path[np.argmax(np.linalg.norm(path - path[0], axis=1))]
        arrow = {"arrowstyle": "-|>", "color": BLACK, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
        axes.annotate("", xy=farthest, xytext=path[0], arrowprops=arrow, zorder=4)


def _height_by_width(worlds: dict[str, tuple[pd.DataFrame, pd.DataFrame]]) -> float:
    """Of the box around everything that a panel shows, within what a page can take."""
    both = pd.concat([table[["x_m", "y_m"]] for world in worlds.values() for table in world])
    width, height = np.ptp(both.to_numpy(), axis=0)
    return float(np.clip(height / width if width else 1.0, 0.2, 1.5))


def _name_colours(axes: Axes) -> None:
    axes.plot([], [], "s", color=BLUE, label="static obstacle")
    axes.plot([], [], "s", color=GREEN, label="dynamic obstacle")
    axes.plot([], [], color=BLACK, linewidth=0.8, marker=">", markersize=4, label="its first leg")
    axes.plot([], [], color=VERMILLION, marker="o", markersize=4, label="UAV and its start")


def _read(file: Path, columns: list[str]) -> pd.DataFrame:
    try:
        table = pd.read_csv(file, dtype=float)
    except (OSError, ValueError) as error:
        raise InputError(f"{file}: unreadable: {str(error).splitlines()[0]}") from error
    for column in columns:
        if column not in table:
            raise InputError(f"{file}: column {column} is missing")
    if table.empty or not np.isfinite(table.to_numpy()).all():
        raise InputError(f"{file}: {'no row' if table.empty else 'a value is missing'}")
    return table


def draw(worlds_folder: Path, folder: Path) -> list[Path]:
    """Draw all worlds of one folder into another; returns the pictures.

    Raises
    ------
    InputError
        If there is no world.
    """
    files = sorted(worlds_folder.glob("*.truth.csv"))
    if not files:
        raise InputError(f"{worlds_folder}: holds no *.truth.csv; `ldm simulate` writes them")
    worlds = {file.name.removesuffix(".truth.csv"): read_world(file) for file in files}
    caption = (
        "Figure 5. Simulation scenarios from above: bounding boxes at the first frame, blue "
        "static, green dynamic. Green lines: paths of the dynamic obstacles; arrows: from their "
        "start to the point they get farthest to; vermillion: path of the UAV, from the dot. "
        f"{source(files)}"
    )
    return save(worlds_figure(worlds), folder / "figure5", caption)


def main(argv: Sequence[str] | None = None) -> None:
    """Draw all worlds of one folder."""
    args = parser(__doc__, study="worlds").parse_args(argv)
    folder = args.results / args.study
    print(*draw(folder, folder / "figures"), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
