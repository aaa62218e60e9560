"""One world flown by several arms, from above: who hits what, where.

Reads   DIR/NAME/ARM/: flight.csv, obstacles.csv and summary.json of `ldm fly`, one folder an arm
Writes  DIR/NAME/flown.png, .pdf, caption .txt
Prints  the names of the pictures

A panel for each arm: obstacles at the end of its flight in grey, those that move with the way of the
last two seconds; where a flight ended on one, a cross, and the obstacle in red.

Example: /usr/bin/python3 -m analysis.figures.flown_world --results results --study flights
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Sequence

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from analysis.data.command_line import parser, run
from analysis.data.errors import InputError
from analysis.figures.figure_style import BLUE, GREY, PAGE_WIDTH, VERMILLION, new_figure, save
from analysis.tables.avoidance_table import CONTROLS

TRAIL_S = 2.0
"""How long a way of what moves is shown."""
COLUMNS = 2
PANEL_HEIGHT = 1.25  # [in]
MARGIN_M = 1.0


def read_flight(folder: Path) -> tuple[pd.DataFrame, pd.DataFrame, dict]:
    """Samples, obstacles and summary of one flight.

    Raises
    ------
    InputError
        Naming the file that cannot be read.
    """
    try:
        return (pd.read_csv(folder / "flight.csv"), pd.read_csv(folder / "obstacles.csv"),
                json.loads((folder / "summary.json").read_text(encoding="utf-8")))  # fmt: skip
    except (OSError, ValueError) as error:
        raise InputError(f"{folder}: no flight of `ldm fly`: {error}") from error


def draw_flight(axes: Axes, flight: pd.DataFrame, obstacles: pd.DataFrame, summary: dict) -> None:
    """The path, and the obstacles at its end."""
    end = flight.iloc[-1]
    now = obstacles[obstacles["time_s"] == obstacles["time_s"].max()]
    struck = summary["hit_obstacle"]
    for obstacle in now.itertuples():
        colour = VERMILLION if obstacle.id == struck else GREY
        if obstacle.dynamic:
            past = obstacles[(obstacles["id"] == obstacle.id)
                             & (obstacles["time_s"] >= obstacle.time_s - TRAIL_S)]  # fmt: skip
            axes.plot(past["x_m"], past["y_m"], color=colour, linewidth=0.8)
        axes.add_patch(Rectangle(
            (obstacle.x_m - obstacle.size_x_m / 2, obstacle.y_m - obstacle.size_y_m / 2),
            obstacle.size_x_m, obstacle.size_y_m, facecolor=colour, edgecolor="none",
            alpha=0.9 if obstacle.dynamic else 0.5))  # fmt: skip
    axes.plot(flight["x_m"], flight["y_m"], color=BLUE)
    if struck is None:
        axes.plot(end["x_m"], end["y_m"], "o", color=BLUE, markersize=3)
    else:
        axes.plot(end["x_m"], end["y_m"], "x", color="black", markersize=6, markeredgewidth=1.5)
    outcome = summary["outcome"].replace("_", " ")
    axes.set_title(f"{summary['method']}: {outcome} after {end['time_s']:.1f} s")


def flown_figure(flights: list[tuple[pd.DataFrame, pd.DataFrame, dict]]) -> Figure:
    """A panel for each flight, all with the same axes."""
    rows = -(-len(flights) // COLUMNS)
    figure = new_figure(PAGE_WIDTH, 0.4 + PANEL_HEIGHT * rows)
    panels = figure.subplots(rows, COLUMNS, sharex=True, sharey=True, squeeze=False).ravel()
    x = pd.concat([flight["x_m"] for flight, _, _ in flights])
    for axes, flown in zip(panels, flights):
        draw_flight(axes, *flown)
        axes.set_aspect("equal")
        axes.set_xlim(x.min() - MARGIN_M, max(x.max(), -x.min()) + MARGIN_M)
        axes.set_ylim(-3 - MARGIN_M, 3 + MARGIN_M)
    for axes in panels[len(flights):]:
        axes.set_visible(False)
    for axes in panels[max(0, len(flights) - COLUMNS):len(flights)]:
        axes.tick_params(labelbottom=True)  # the lowest of its column
    figure.supxlabel("x (m)", fontsize=8)
    figure.supylabel("y (m)", fontsize=8)
    return figure


def _order(name: str) -> tuple:
    first = ["blind", "current_scan", "octomap", "circular_buffer", "circular_buffer_pf", "ldm", "object_ldm"]
    place = first.index(name) if name in first else len(first)
    return (name in CONTROLS[1:], place, name)


def main(argv: Sequence[str] | None = None) -> None:
    args = parser(__doc__, "flights").parse_args(argv)
    folder = args.results / args.study
    found = sorted((f.parent for f in folder.glob("*/summary.json")), key=lambda f: _order(f.name))
    if not found:
        raise InputError(f"{folder}: holds no flight (*/summary.json); `ldm fly` makes one")
    flights = [read_flight(one) for one in found]
    summary = flights[0][2]
    caption = (
        f"One world ({summary['scenario']}, seed {summary['seeds']['scenario']}) flown by each arm, from "
        "left to right, seen from above. Obstacles as they are when the flight ends, what moves with its "
        "way of the last two seconds; where a flight ends on one, a cross, and the obstacle in red."
    )
    for picture in save(flown_figure(flights), folder / "flown", caption):
        print(picture)


if __name__ == "__main__":
    sys.exit(run(main))
