"""Every claim at one condition: the paper's number, ours with its 90 % interval, and the verdict.

Reads   DIR/conditions/STAGE/: ranking.csv, measures.csv (of analysis.conditions.rank)
Writes  DIR/conditions/tables/: verdicts_STAGE_CONDITION.txt, .csv
Prints  the table

Example: /usr/bin/python3 -m analysis.conditions.verdict_table stage3 --results results
"""

from __future__ import annotations

import math
import sys
from typing import Sequence

import pandas as pd

from analysis.conditions.claims_map import label
from analysis.conditions.command_line import argument_parser
from analysis.conditions.verdicts import HOLDS, Outcome, distance, outcomes
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.output import write_csv, write_text
from analysis.data.statistics import Interval
from analysis.tables.text_table import NOTHING, aligned, interval, number


def main(argv: Sequence[str] | None = None) -> None:
    """Write and print the table of one condition."""
    parser = argument_parser(__doc__)
    parser.add_argument("stage", help="folder in DIR/conditions")
    parser.add_argument("--condition", metavar="NAME", help="instead of the nearest to the paper")
    args = parser.parse_args(argv)
    folder = args.results / "conditions" / args.stage
    try:
        measures = pd.read_csv(folder / "measures.csv")
        name = args.condition or pd.read_csv(folder / "ranking.csv")["condition"][0]
    except (OSError, KeyError) as error:
        raise InputError(f"{folder}: {error}; rank the stage") from error
    found = outcomes(measures[measures["condition"] == name])
    if not any(outcome.n for outcome in found):
        raise InputError(f"--condition: {name!r}: allowed: a condition of {args.stage} with records")
    stem = args.results / "conditions" / "tables" / f"verdicts_{args.stage}_{name}"
    write_text(stem.with_suffix(".txt"), text(args.stage, name, found))
    write_csv(stem.with_suffix(".csv"), frame(found))
    print(text(args.stage, name, found), end="")


def text(stage: str, name: str, found: list[Outcome]) -> str:
    """The table with a head that says what it rests on."""
    away, reading = distance(found)
    worlds = max(outcome.n for outcome in found)
    orders = [outcome for outcome in found if outcome.claim.name == "order"]
    held = sum(outcome.verdict == HOLDS for outcome in orders)
    head = (f"Condition {name} of {stage}, {worlds} worlds: distance {number(away, 2)} "
            f"(reading {reading or NOTHING}), {held} of {len(orders)} orders of Table 1 hold.\n"
            "Differences to the baseline; counts in % of it; mean [90% interval].\n\n")  # fmt: skip
    rows = []
    for k, outcome in enumerate(found):
        claim = outcome.claim
        if k and claim.group != found[k - 1].claim.group:
            rows.append([])
        decimals = 1 if claim.relative or claim.measure.endswith("_pct") and not claim.baseline else 3
        bounds = [NOTHING if math.isinf(b) else number(b, decimals) for b in (claim.low, claim.high)]
        paper = number(claim.paper, decimals) if claim.name != "constancy_order" else NOTHING
        ours = interval(Interval(outcome.mean, outcome.low, outcome.high, outcome.n), decimals)
        power = NOTHING if math.isnan(outcome.power) else f"{outcome.power:.2f}"
        rows.append([label(claim), paper, " to ".join(bounds), ours, power, outcome.verdict])
    columns = ["", "paper", "must lie in", "ours", "power", "verdict"]
    return head + aligned(columns, rows, last_left=True)


def frame(found: list[Outcome]) -> pd.DataFrame:
    """The same as plain values."""
    return pd.DataFrame(
        [
            {"claim": o.claim.key, "paper": o.claim.paper, "from": o.claim.low, "to": o.claim.high}
            | {"mean": o.mean, "low": o.low, "high": o.high, "worlds": o.n, "power": o.power}
            | {"verdict": o.verdict}
            for o in found
        ]
    )


if __name__ == "__main__":
    sys.exit(run(main))
