"""How readings differ on a person who walks at a constant speed: Figure 15, reading by reading.

Reads   records of outdoor1, one a condition
Writes  DIR/conditions/figures/walker.{png,pdf,txt}

Example: /usr/bin/python3 -m analysis.conditions.walker --records shipped=a.json near=b.json
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

from analysis.conditions.command_line import argument_parser
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.series import ObjectSeries, read_series
from analysis.data.series_scores import fluctuation, response
from analysis.figures.figure_style import BLACK, BLUE, PAGE_WIDTH, legend_above, new_figure, save


def main(argv: Sequence[str] | None = None) -> None:
    """Draw the first walker of each record, one panel each."""
    parser = argument_parser(__doc__)
    parser.add_argument("--records", nargs="+", required=True, metavar="NAME=FILE")
    args = parser.parse_args(argv)
    found = dict(_named(text) for text in args.records)
    figure = new_figure(PAGE_WIDTH, 1.5 * len(found) + 0.5)
    panels = figure.subplots(len(found), sharex=True, sharey=True, squeeze=False)[:, 0]
    for axes, (name, walker) in zip(panels, found.items()):
        axes.plot(walker.time, walker.truth[:, 0], color=BLUE, label="truth")
        axes.plot(walker.time, walker.estimate[:, 0], color=BLACK, label="estimate")
        axes.set_title(f"{name}: varies by {fluctuation([walker]):.3f} m/s, "
                       f"follows in {response([walker]):.1f} s", loc="left")  # fmt: skip
        axes.set_ylabel("$v_x$ (m/s)")
    panels[-1].set_xlabel("time (s)")
    legend_above(figure, panels[0], 2)
    caption = ("Velocity of a person who walks there and back, estimated under several readings of the "
               "method: root-mean-square deviation while the truth is constant, and time until 80 % of it "
               "are estimated.")  # fmt: skip
    for file in save(figure, args.results / "conditions" / "figures" / "walker", caption):
        print(file)


def _named(text: str) -> tuple[str, ObjectSeries]:
    name, found, file = text.partition("=")
    if not found:
        raise InputError(f"--records: {text!r}: allowed: NAME=FILE")
    walkers = [series for series in read_series(Path(file)) if series.dynamic]
    if not walkers:
        raise InputError(f"{file}: series: holds no moving object")
    return name, walkers[0]


if __name__ == "__main__":
    sys.exit(run(main))
