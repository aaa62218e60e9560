"""Figures of the speed: time per stage, and growth against the memory bound.

Reads   DIR/bench.json
Writes  DIR/figures/bench_{stages,growth}.{png,pdf,txt}
Prints  the names of the pictures

Example: /usr/bin/python3 -m analysis.figures.bench_figures --results results
"""

from __future__ import annotations

import sys
from typing import Callable, NamedTuple, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analysis.data.bench import FEW_RAYS, Bench, Case, bound, ldm, load_bench, threads_text
from analysis.data.bench_command_line import parser
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.figures.figure_style import (
    BLACK, BLUE, GREY, PAGE_WIDTH, PLAIN_NUMBERS, SKY_BLUE, VERMILLION, legend_above, new_figure, save,
)  # fmt: skip


class Axis(NamedTuple):
    """One panel of the growth: the cases of `curve` are those along the axis."""

    label: str
    position: Callable[[Case], float]
    curves: list[tuple[str, str, Callable[[Case], bool]]]
    """Label, colour, and which cases lie on the curve."""


def is_ldm(**fixed) -> Callable[[Case], bool]:
    """True of our cases with these values."""
    return lambda c: c.subject == "ldm" and all(getattr(c, k) == v for k, v in fixed.items())


SHIFTS = (-0.2, 0, 0.2)
"""Up or down of the markers of a stage, so that none hides another."""
PAPER, LARGE = "32$^3$ voxels, 200,000 particles", "128$^3$ voxels, 1,000,000 particles"
AXES = [
    Axis("voxels of the map", lambda c: c.edge**3,
         [(PAPER, BLACK, is_ldm(particles=200_000, rays=FEW_RAYS, threads=1))]),
    Axis("particles", lambda c: c.particles, [(PAPER, BLACK, is_ldm(edge=32, rays=FEW_RAYS, threads=1))]),
    Axis("rays of a scan", lambda c: c.rays[0] * c.rays[1],
         [(PAPER, BLACK, is_ldm(edge=32, particles=200_000, threads=1))]),
    Axis("threads", lambda c: c.threads,
         [(PAPER, BLACK, is_ldm(edge=32, particles=200_000, rays=FEW_RAYS)),
          (LARGE, VERMILLION, is_ldm(edge=128, particles=1_000_000, rays=FEW_RAYS))]),
]  # fmt: skip


CAPTIONS = {
    "bench_stages": "Median wall time of each stage of a frame, 16x1024 rays; plain reference: the "
    "same method in ldm/plain/, one thread.",
    "bench_growth": "Median time of a whole frame along each axis, the others as in the legend, "
    "with 16x1024 rays and one thread; CPU time for one thread, wall time for more. B3: one pass "
    "and two copies of the particles' memory, from memory or from the cache.",
}


def growth_figure(bench: Bench) -> Figure:
    """Time of a frame along each axis; the bound of as many particles and threads below it."""
    figure = new_figure(PAGE_WIDTH, 4.6)
    panels = figure.subplots(2, 2, sharey=True)
    for panel, axis in zip(panels.flat, AXES):
        for label, colour, on_curve in axis.curves:
            _draw_curve(panel, bench, axis, on_curve, colour, label)
        panel.set_xscale("log")
        panel.set_yscale("log")
        panel.set_xlabel(axis.label)
        panel.yaxis.set_major_formatter(PLAIN_NUMBERS)
        _name_ticks(panel, bench, axis)
    for panel in panels[:, 0]:
        panel.set_ylabel("median time (ms)")
    legend_above(figure, panels.flat[-1], columns=2)
    return figure


def _draw_curve(panel: Axes, bench: Bench, axis: Axis, on_curve: Callable[[Case], bool], colour: str,
                label: str) -> None:
    cases = sorted(filter(on_curve, bench.median_ms), key=axis.position)
    positions = [axis.position(case) for case in cases]
    panel.plot(positions, [bench.median_ms[case] for case in cases], "o-", color=colour, markersize=4,
               label=label)
    for state, style, shade in (("memory", "--", GREY), ("cache", ":", SKY_BLUE)):
        limits = [bench.median_ms.get(bound(state, c.particles, c.threads), np.nan) for c in cases]
        panel.plot(positions, limits, style, marker=".", color=shade,
                   label=f"bound B3, particles from {state}" if colour == BLACK else None)


def _name_ticks(panel: Axes, bench: Bench, axis: Axis) -> None:
    """A tick where something was measured, written with k and M."""
    curves = [on_curve for _, _, on_curve in axis.curves]
    places = sorted({axis.position(c) for c in bench.median_ms if any(on(c) for on in curves)})
    panel.set_xticks(places, [_short(place) for place in places])
    panel.minorticks_off()


def _short(value: float) -> str:
    for unit, size in (("M", 1e6), ("k", 1e3)):
        if value >= size:
            return f"{value / size:.3g}{unit}"
    return f"{value:g}"


def stages_figure(bench: Bench) -> Figure:
    """Time of each stage: plain code and ours on the paper's map, ours on the large one."""
    small = [(Case("plain_ldm", 32, 200_000), "plain reference", BLUE, "D")]
    styles = ((1, BLACK, "o"), (2, VERMILLION, "s"))
    small += [(ldm(32, 200_000, threads=n), threads_text(n), colour, mark) for n, colour, mark in styles]
    large = [(ldm(128, 1_000_000, threads=n), threads_text(n), colour, mark) for n, colour, mark in styles]
    stages = list(bench.stages_ms[ldm(32, 200_000)])
    figure = new_figure(PAGE_WIDTH, 2.6)
    panels = figure.subplots(1, 2, sharey=True)
    for panel, curves, title in ((panels[0], small, PAPER), (panels[1], large, LARGE)):
        for shift, (case, label, colour, mark) in zip(SHIFTS[-len(curves):], curves):
            times = bench.stages_ms.get(case, {})
            panel.plot([times.get(stage, np.nan) for stage in stages], np.arange(len(stages)) + shift, mark,
                       color=colour, markersize=5, label=label)
        panel.set_xscale("log")
        panel.xaxis.set_major_formatter(PLAIN_NUMBERS)
        panel.set_xlabel("median wall time (ms)")
        panel.set_title(title)
        panel.set_yticks(np.arange(len(stages)), [stage.replace("_", " ") for stage in stages])
        panel.set_ylim(len(stages) - 0.5, -0.5)
    legend_above(figure, panels[0], columns=3)
    return figure


def main(argv: Sequence[str] | None = None) -> None:
    """Make both figures."""
    args = parser(__doc__).parse_args(argv)
    bench = load_bench(args.results)
    if not bench.stages_ms.get(ldm(32, 200_000)):
        raise InputError(f"{bench.file}: lacks {ldm(32, 200_000)}; run `make bench`")
    folder = args.results / "figures"
    for name, draw in (("bench_stages", stages_figure), ("bench_growth", growth_figure)):
        caption = f"{CAPTIONS[name]} {bench.source()}."
        print(*save(draw(bench), folder / name, caption), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
