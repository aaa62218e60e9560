"""Under which conditions each claim holds: one small multiple, claims by unknowns.

Reads   DIR/conditions/STAGE/: conditions.csv, outcomes.csv (of analysis.conditions.rank)
Writes  DIR/conditions/figures/claims_map.{png,pdf,txt}, DIR/conditions/tables/: claims.csv, decides.csv
Prints  for each claim the share of conditions in which it leans the paper's way, and what decides it

Example: /usr/bin/python3 -m analysis.conditions.claims_map --stage stage1
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes

from analysis.conditions.claims import Claim, claims, pf_readings
from analysis.conditions.command_line import argument_parser
from analysis.conditions.rank import read_conditions
from analysis.conditions.shares import PARTS, parts_of, ranking, share
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.output import write_csv
from analysis.figures.figure_style import PAGE_WIDTH, new_figure, save

NAMES = {
    "order": "order", "size": "size", "static_order": "static error, order",
    "dynamic_order": "dynamic error, order", "static_size": "static error, size",
    "dynamic_size": "dynamic error, size", "static_level": "static error up to 0.02 m/s",
    "dynamic_level": "dynamic error up to 0.15 m/s", "convergence": "time to converge alike",
    "constancy_order": "steadier", "static_times": "static better at 95 % of times",
    "outdoor_static": "person stands within 0.05 m/s", "outdoor_hidden": "hidden person kept",
    "outdoor_direction": "direction right", "outdoor_constancy": "walker within 0.1 m/s",
    "outdoor_response": "walker within 1 s",
}  # fmt: skip
MEASURES = {"accuracy_pct": "accuracy", "case1_voxels": "case 1", "case2_voxels": "case 2",
            "hidden_with_cluster_pct": "cluster", "occlusions_kept_pct": "track"}  # fmt: skip
READINGS = dict(zip(pf_readings(), ("PF Eq. 17", "PF free")))


def main(argv: Sequence[str] | None = None) -> None:
    """Draw the map and write its numbers."""
    parser = argument_parser(__doc__)
    parser.add_argument("--stage", default="stage1", help="a design that fills the space")
    args = parser.parse_args(argv)
    root = args.results / "conditions"
    conditions = read_conditions(root / args.stage)
    leans = read_leans(root / args.stage)
    table, deciding = summaries(leans, conditions)
    write_csv(root / "tables" / "claims.csv", table)
    write_csv(root / "tables" / "decides.csv", deciding)
    for row in table.itertuples():
        print(f"{row.label:<44} {100 * row.share:3.0f} % [{100 * row.low:.0f}, {100 * row.high:.0f}]"
              f"  {row.decided_by}")  # fmt: skip
    caption = (
        f"Share of {leans.shape[1]} conditions of {args.stage} in which a claim leans the paper's way, "
        "by the part of each unknown: the lowest, middle and highest third of a number, or each word."
    )
    figure = draw(leans, conditions)
    for file in save(figure, root / "figures" / "claims_map", caption):
        print(file)


def read_leans(folder: Path) -> pd.DataFrame:
    """A row for each claim (its key), a column for each condition: 1 where it leans the paper's way,
    0 where not, NaN without a trial."""
    try:
        found = pd.read_csv(folder / "outcomes.csv")
    except OSError as error:
        raise InputError(f"{folder / 'outcomes.csv'}: {error.strerror}; rank the stage") from error
    found["leans"] = found["leans"].astype(float).where(found["n"] > 0)
    return found.pivot(index="claim", columns="condition", values="leans")


def summaries(leans: pd.DataFrame, conditions: pd.DataFrame) -> tuple[pd.DataFrame, pd.DataFrame]:
    """For each claim its share; and for each claim and unknown how much that unknown decides."""
    rows, deciding = [], []
    for claim in claims():
        values = leans.loc[claim.key].dropna()
        found = ranking(values, conditions)
        deciding.append(found.assign(claim=claim.key))
        first = found[found["low"] > 0].head(3)
        by = ", ".join(f"{row.unknown} {row.index_:.2f}" for row in
                       first.rename(columns={"index": "index_"}).itertuples())  # fmt: skip
        rows.append((claim.key, label(claim), len(values), *share(values), by))
    columns = ["claim", "label", "conditions", "share", "low", "high", "decided_by"]
    return pd.DataFrame(rows, columns=columns), pd.concat(deciding, ignore_index=True)


def label(claim: Claim) -> str:
    """As short as a row of a figure needs it."""
    parts = [NAMES[claim.name], MEASURES.get(claim.measure, ""), READINGS.get(claim.baseline, "")]
    place = claim.scenario.replace("scenario", "S").replace("outdoor", "O")
    return f"{place} " + ", ".join(filter(None, parts))


def draw(leans: pd.DataFrame, conditions: pd.DataFrame):
    """Rows are claims, columns unknowns, each in its parts; the first column is the share in all."""
    found = claims()
    figure = new_figure(PAGE_WIDTH, 0.135 * len(found) + 1.3)
    axes = figure.add_subplot()
    cells, edges, ticks = _cells(leans, conditions)
    image = axes.imshow(cells, vmin=0, vmax=100, cmap="cividis", aspect="auto",
                        interpolation="nearest")  # fmt: skip
    for edge in edges:
        axes.axvline(edge - 0.5, color="white", linewidth=2)
    for k in range(1, len(found)):
        if found[k].group != found[k - 1].group:
            axes.axhline(k - 0.5, color="white", linewidth=2)
    _label(axes, found, ticks)
    figure.colorbar(image, ax=axes, label="conditions that lean the paper's way (%)", pad=0.01)
    return figure


def _cells(leans: pd.DataFrame, conditions: pd.DataFrame):
    ordered = leans.loc[[claim.key for claim in claims()]]
    columns, edges, ticks = [ordered.mean(axis=1)], [1], [(0, "all")]
    for unknown in conditions:
        part = parts_of(conditions.loc[ordered.columns, unknown])
        names = sorted(part.unique())
        ticks.append((len(columns) + (len(names) - 1) / 2, unknown))
        columns += [ordered.loc[:, part == name].mean(axis=1) for name in names]
        edges.append(len(columns))
    return 100 * np.column_stack(columns), edges[:-1], ticks


def _label(axes: Axes, found: tuple[Claim, ...], ticks: list[tuple[float, str]]) -> None:
    axes.set_yticks(range(len(found)), [label(claim) for claim in found], fontsize=5.5)
    axes.set_xticks([place for place, _ in ticks], [name for _, name in ticks], fontsize=5.5,
                    rotation=60, ha="right", rotation_mode="anchor")  # fmt: skip
    axes.grid(False)
    axes.tick_params(length=0)
    axes.spines[:].set_visible(False)
    axes.set_xlabel(f"unknowns, each from its lowest to its highest {PARTS} parts, or its words",
                    fontsize=6)  # fmt: skip


if __name__ == "__main__":
    sys.exit(run(main))
