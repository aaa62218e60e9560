"""How every figure looks and is saved: readable at column width, same records, same bytes."""

from __future__ import annotations

from io import BytesIO
from pathlib import Path

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter

from analysis.data.output import write_bytes, write_text

COLUMN_WIDTH = 3.4
"""Width of a column of the paper [in]."""
PAGE_WIDTH = 7.0
"""Width of the text [in]."""

# Okabe and Ito's colours, told apart with any kind of colour blindness.
BLACK, BLUE, VERMILLION, GREEN = "#000000", "#0072B2", "#D55E00", "#009E73"
ORANGE, SKY_BLUE, PURPLE, GREY = "#E69F00", "#56B4E9", "#CC79A7", "#7F7F7F"

PLAIN_NUMBERS = FuncFormatter(lambda value, _: f"{value:g}")
"""Ticks of a logarithmic axis as 0.1, 1, 10 and not as powers."""

_METHOD_STYLES = {
    "ldm": (BLACK, "o"),
    "circular_buffer": (VERMILLION, "s"),
    "circular_buffer_pf": (ORANGE, "D"),
    "circular_buffer_pf_eq17": (SKY_BLUE, "X"),
    "circular_buffer_pf_free": (GREY, "<"),
    "circular_buffer_low_clamp": (PURPLE, "^"),
    "octomap": (BLUE, "v"),
    "current_scan": (GREEN, "P"),
}
_OTHER_STYLES = [("#882255", ">"), ("#44AA99", "*"), ("#999933", "p")]

matplotlib.rcParams.update(
    {
        "font.size": 8,
        "axes.labelsize": 8,
        "axes.titlesize": 8,
        "xtick.labelsize": 8,
        "ytick.labelsize": 8,
        "legend.fontsize": 8,
        "legend.frameon": False,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.linewidth": 0.6,
        "axes.grid": True,
        "axes.axisbelow": True,
        "grid.color": "#DDDDDD",
        "grid.linewidth": 0.5,
        "lines.linewidth": 1.2,
        "figure.dpi": 100,
        "savefig.dpi": 300,
        "pdf.fonttype": 42,  # text stays text
    }
)


def new_figure(width: float, height: float) -> Figure:
    """An empty figure of this size [in]; its layout makes room for all labels."""
    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def method_styles(methods: list[str]) -> dict[str, tuple[str, str]]:
    """Colour and marker of each method: known ones have their own, others take what is left."""
    others = [method for method in methods if method not in _METHOD_STYLES]
    styles = {other: _OTHER_STYLES[i % len(_OTHER_STYLES)] for i, other in enumerate(others)}
    return {method: _METHOD_STYLES.get(method) or styles[method] for method in methods}


def legend_above(figure: Figure, axes: Axes, columns: int) -> None:
    """A legend of `axes`' labels above all panels, in a band of its own: it covers no data. It has fewer
    columns where so many would be wider than the figure."""
    handles, labels = axes.get_legend_handles_labels()
    for count in range(columns, 0, -1):
        legend = figure.legend(
            handles, labels, loc="upper center", ncols=count, handlelength=2.2, columnspacing=1.2,
            borderaxespad=0.2,
        )  # fmt: skip
        size = legend.get_window_extent(figure.canvas.get_renderer())
        if size.width <= figure.bbox.width or count == 1:
            break
        legend.remove()
    band = (size.height / figure.dpi + 0.06) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, 0, 1, 1 - band))


def write_picture(figure: Figure, file: Path, **options: object) -> None:
    """Write `file` in the format that its name says; drawn before the file is there, so that a full
    disk leaves no empty one."""
    drawn = BytesIO()
    figure.savefig(drawn, format=file.suffix[1:], **options)
    write_bytes(file, drawn.getvalue())


def save(figure: Figure, stem: Path, caption: str) -> list[Path]:
    """Write STEM.png, STEM.pdf and the caption as STEM.txt; returns the two pictures.

    No date and no program version goes into the files.
    """
    png, pdf = stem.with_suffix(".png"), stem.with_suffix(".pdf")
    write_picture(figure, png, metadata={"Software": None})
    write_picture(figure, pdf, metadata={"CreationDate": None, "Creator": None, "Producer": None})
    write_text(stem.with_suffix(".txt"), caption + "\n")
    return [png, pdf]
