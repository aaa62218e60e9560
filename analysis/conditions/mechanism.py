"""Why the claims fail under the readings under which they fail: two figures from runs of the program.

Reads   DIR/conditions/mechanism/: outdoor1.truth.csv and scenario1.truth.csv of recorded worlds; and of each
        READING of the command line the runs READING.outdoor1/clusters.csv and
        READING.scenario1/{frames.csv, maps/frame_N.occupied.ply}
Writes  DIR/conditions/figures/: swing and behind, each as .png, .pdf, caption .txt

`make mechanism` makes the runs. Example:
/usr/bin/python3 -m analysis.conditions.mechanism --results results --readings residual_no_gate defaults --frame 200
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

from analysis.conditions.command_line import argument_parser
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.figures.figure_style import (
    BLACK,
    BLUE,
    GREY,
    PAGE_WIDTH,
    VERMILLION,
    legend_above,
    new_figure,
    save,
)

WALKER = 1
"""Object of outdoor1: the nearer of the two who walk."""
TIMES = (6.0, 14.0)
"""What is shown of it [s]: walking at one speed, a turn, and back."""
NEAR_M = 0.6
"""A cluster so near to the walker's centre, in the horizontal, is the walker's."""
VOXEL_M = 0.15
PLY_TYPES = {"float": "<f4", "uchar": "u1", "int": "<i4"}


def main(argv: Sequence[str] | None = None) -> None:
    """Draw both figures."""
    parser = argument_parser(__doc__)
    parser.add_argument("--readings", nargs="+", required=True, metavar="NAME")
    parser.add_argument("--frame", type=int, required=True, help="of the saved maps of scenario1")
    args = parser.parse_args(argv)
    folder = args.results / "conditions" / "mechanism"
    figures = args.results / "conditions" / "figures"
    walker = _read(folder / "outdoor1.truth.csv").query("id == @WALKER")
    of_reading = {
        name: clusters_of(walker, _read(folder / f"{name}.outdoor1" / "clusters.csv"))
        for name in args.readings
    }
    caption = ("A walker of outdoor1 frame by frame: estimated velocity, where the centroid of its "
               "cluster is against its true centre, both along x, and the number of its occupied voxels.")  # fmt: skip
    made = save(swing_figure(walker, of_reading), figures / "swing", caption)
    truth = _read(folder / "scenario1.truth.csv").query("frame == @args.frame")
    maps = {name: folder / f"{name}.scenario1" for name in args.readings}
    caption = (f"Occupied voxels of frame {args.frame} of scenario1, from above. Wrong: the centre is not within a "
               "voxel of an obstacle's box. Star: the UAV.")  # fmt: skip
    made += save(behind_figure(truth, maps, args.frame), figures / "behind", caption)
    print(*made, sep="\n")


def clusters_of(walker: pd.DataFrame, clusters: pd.DataFrame) -> pd.DataFrame:
    """In each frame the cluster nearest to the walker: time, vx, offset of its centroid [m], voxels."""
    both = clusters.merge(walker, on="frame", suffixes=("", "_true"))
    both["away"] = np.hypot(both["x_m"] - both["x_m_true"], both["y_m"] - both["y_m_true"])
    near = both[both["away"] < NEAR_M].sort_values("away").drop_duplicates("frame").sort_values("frame")
    return near.assign(offset=near["x_m"] - near["x_m_true"])[["time_s", "vx_mps", "offset", "voxels"]]


def swing_figure(walker: pd.DataFrame, of_reading: dict[str, pd.DataFrame]) -> Figure:
    """A column for each reading."""
    figure = new_figure(PAGE_WIDTH, 4.0)
    panels = figure.subplots(3, len(of_reading), sharex=True, sharey="row", squeeze=False)
    for column, (name, found) in zip(panels.T, of_reading.items()):
        column[0].set_title(name, loc="left")
        column[0].plot(walker["time_s"], walker["vx_mps"], color=BLUE, label="truth")
        column[0].plot(found["time_s"], found["vx_mps"], color=BLACK, label="estimate")
        column[1].axhline(0, color=BLUE)
        column[1].plot(found["time_s"], found["offset"], color=BLACK)
        column[2].plot(found["time_s"], found["voxels"], color=BLACK)
        column[2].set_xlabel("time (s)")
    panels[0, 0].set_xlim(TIMES)
    panels[2, 0].set_ylim(bottom=0)
    for axes, label in zip(panels[:, 0], ("$v_x$ (m/s)", "centroid - truth (m)", "occupied voxels")):
        axes.set_ylabel(label)
    figure.align_ylabels(panels[:, 0])
    legend_above(figure, panels[0, 0], 2)
    return figure


def behind_figure(truth: pd.DataFrame, maps: dict[str, Path], frame: int) -> Figure:
    """A map from above for each reading: right and wrong occupied voxels."""
    figure = new_figure(PAGE_WIDTH, 0.8 + PAGE_WIDTH / len(maps))
    panels = figure.subplots(1, len(maps), sharex=True, sharey=True, squeeze=False)[0]
    for axes, (name, run_folder) in zip(panels, maps.items()):
        voxels = read_ply(run_folder / "maps" / f"frame_{frame:06d}.occupied.ply")
        right = within(voxels, truth)
        axes.set_title(f"{name}: {np.sum(~right)} wrong of {len(right)}", loc="left")
        for row in truth.itertuples():
            axes.add_patch(Rectangle((row.x_m - row.sx_m / 2, row.y_m - row.sy_m / 2), row.sx_m, row.sy_m,
                                     facecolor="none", edgecolor=BLUE))  # fmt: skip
        _voxels(axes, voxels[right], GREY, "right")
        _voxels(axes, voxels[~right], VERMILLION, "wrong")
        place = _read(run_folder / "frames.csv").query("frame == @frame").iloc[0]
        axes.plot(place["uav_x_m"], place["uav_y_m"], "*", color=BLACK, markersize=8)
        low = place[["map_x_m", "map_y_m"]].to_numpy()
        size = place[["map_size_x_m", "map_size_y_m"]].to_numpy()
        axes.set(xlim=(low[0], low[0] + size[0]), ylim=(low[1], low[1] + size[1]), xlabel="x (m)")
        axes.set_aspect("equal")
    panels[0].set_ylabel("y (m)")
    legend_above(figure, panels[0], 2)
    return figure


def within(voxels: np.ndarray, truth: pd.DataFrame) -> np.ndarray:
    """Which centres, N x 3 [m], lie in a box of the truth that is grown by a voxel on all sides."""
    inside = np.zeros(len(voxels), dtype=bool)
    for row in truth.itertuples():
        half = np.array([row.sx_m, row.sy_m, row.sz_m]) / 2 + VOXEL_M
        inside |= np.all(np.abs(voxels - [row.x_m, row.y_m, row.z_m]) <= half, axis=1)
    return inside


def read_ply(file: Path) -> np.ndarray:
    """Positions of the points, N x 3 [m]. @raises InputError if it is not such a file."""
    try:
        head, _, body = file.read_bytes().partition(b"end_header\n")
        lines = [line.split() for line in head.decode("ascii").splitlines()]
        types = np.dtype([(line[2], PLY_TYPES[line[1]]) for line in lines if line[0] == "property"])
        (count,) = (int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
        points = np.frombuffer(body, dtype=types, count=count)
        return np.column_stack([points["x"], points["y"], points["z"]]).astype(float)
    except OSError as error:
        raise InputError(f"{file}: {error.strerror}") from error
    except (ValueError, KeyError, IndexError) as error:
        raise InputError(f"{file}: is not a map that `ldm run --save-frames` wrote: {error}") from error


def _voxels(axes: Axes, voxels: np.ndarray, colour: str, label: str) -> None:
    # Many above one another are one square.
    columns = np.unique(np.round(voxels[:, :2], 3), axis=0)
    axes.plot(columns[:, 0], columns[:, 1], "s", color=colour, markersize=3, linestyle="none", label=label)


def _read(file: Path) -> pd.DataFrame:
    try:
        return pd.read_csv(file)
    except (OSError, ValueError) as error:
        raise InputError(f"{file}: {error}; `make mechanism` writes it") from error


if __name__ == "__main__":
    sys.exit(run(main))
