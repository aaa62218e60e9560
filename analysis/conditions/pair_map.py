"""Speed of the obstacles against Sigma: in which cells the claims on velocities hold.

Reads   DIR/conditions/STAGE/: conditions.csv, outcomes.csv (of analysis.conditions.rank)
Writes  DIR/conditions/figures/speed_sigma.{png,pdf,txt}, DIR/conditions/tables/speed_sigma.csv

Example: /usr/bin/python3 -m analysis.conditions.pair_map --stage stage1
"""

from __future__ import annotations

import sys
from typing import Sequence

import numpy as np
import pandas as pd
from scipy import stats

from analysis.conditions.claims import Claim, claims
from analysis.conditions.claims_map import label, read_leans
from analysis.conditions.command_line import argument_parser
from analysis.conditions.rank import read_conditions
from analysis.conditions.shares import share
from analysis.data.command_line import run
from analysis.data.output import write_csv
from analysis.figures.figure_style import PAGE_WIDTH, new_figure, save

SHOWN = ("static_order", "dynamic_order", "static_level", "dynamic_level", "outdoor_constancy",
         "outdoor_response")  # fmt: skip
ACROSS, UP = "sigma_mps", "speed_mps"
CELLS = 4
"""Along each axis, of equally many conditions."""
TRUE_SHARE = 0.8
"""Power of a cell: how likely the sign test at 5 % finds that the claim holds in more than half of its
conditions if it holds in this share of them."""


def main(argv: Sequence[str] | None = None) -> None:
    """Draw the maps and write their numbers."""
    parser = argument_parser(__doc__)
    parser.add_argument("--stage", default="stage1", help="a design that fills the space")
    args = parser.parse_args(argv)
    root = args.results / "conditions"
    leans = read_leans(root / args.stage)
    conditions = read_conditions(root / args.stage).loc[leans.columns]
    shown = [claim for claim in claims() if claim.name in SHOWN]
    edges = {name: np.quantile(conditions[name], np.linspace(0, 1, CELLS + 1)) for name in (ACROSS, UP)}
    tables = {claim.key: cells(leans.loc[claim.key].dropna(), conditions, edges) for claim in shown}
    write_csv(root / "tables" / "speed_sigma.csv",
              pd.concat([table.assign(claim=key) for key, table in tables.items()]))  # fmt: skip
    caption = (
        f"Share of the conditions of {args.stage} that lean the paper's way (%), and in brackets the power "
        f"of the cell (%): how likely a sign test finds more than half if {TRUE_SHARE:.0%} do."
    )
    for file in save(_draw(shown, tables, edges), root / "figures" / "speed_sigma", caption):
        print(file)


def cells(leans: pd.Series, conditions: pd.DataFrame, edges: dict[str, np.ndarray]) -> pd.DataFrame:
    """A row for each cell: its place on both axes, share with interval, conditions, power."""
    place = {name: np.clip(np.searchsorted(edges[name], conditions.loc[leans.index, name], "right") - 1,
                           0, CELLS - 1) for name in edges}  # fmt: skip
    rows = []
    for up in range(CELLS):
        for across in range(CELLS):
            inside = leans[(place[UP] == up) & (place[ACROSS] == across)]
            rows.append((up, across, *share(inside), len(inside), power(len(inside))))
    return pd.DataFrame(rows, columns=[UP, ACROSS, "share", "low", "high", "conditions", "power"])


def power(count: int) -> float:
    """Of the one-sided sign test with so many conditions, at TRUE_SHARE."""
    needed = stats.binom.isf(0.05, count, 0.5) + 1 if count else 1
    return float(stats.binom.sf(needed - 1, count, TRUE_SHARE))


def _draw(shown: list[Claim], tables: dict[str, pd.DataFrame], edges: dict[str, np.ndarray]):
    columns = 4
    figure = new_figure(PAGE_WIDTH, 1.9 * -(-len(shown) // columns))
    grid = figure.subplots(-(-len(shown) // columns), columns, squeeze=False)
    for axes in grid.flat[len(shown) :]:
        axes.set_visible(False)
    for axes, claim in zip(grid.flat, shown):
        table = tables[claim.key]
        image = axes.imshow(100 * table["share"].to_numpy().reshape(CELLS, CELLS), vmin=0, vmax=100,
                            cmap="cividis", origin="lower", aspect="auto")  # fmt: skip
        for row in table.itertuples():
            if row.conditions:
                axes.text(getattr(row, ACROSS), getattr(row, UP),
                          f"{100 * row.share:.0f}\n({100 * row.power:.0f})", ha="center", va="center",
                          fontsize=5, color="white" if row.share < 0.5 else "black")  # fmt: skip
        axes.set_title(label(claim), fontsize=6)
        ticks = np.arange(CELLS + 1) - 0.5
        axes.set_xticks(ticks, [f"{edge:.2g}" for edge in edges[ACROSS]], fontsize=5)
        axes.set_yticks(ticks, [f"{edge:.2g}" for edge in edges[UP]], fontsize=5)
        axes.grid(False)
    figure.supxlabel("Sigma (m/s)", fontsize=7)
    figure.supylabel("mean speed of the obstacles (m/s)", fontsize=7)
    figure.colorbar(image, ax=grid, label="lean the paper's way (%)", pad=0.01, shrink=0.6)
    return figure


if __name__ == "__main__":
    sys.exit(run(main))
