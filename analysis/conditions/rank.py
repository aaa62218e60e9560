"""The conditions of one stage of the search, nearest to the paper first.

Reads   DIR/conditions/STAGE/conditions.csv, */records/*.json; with --kept no record, but what was kept of
        an earlier search: conditions.csv and measures.csv.gz in FOLDER/STAGE
Writes  DIR/conditions/STAGE/: measures.csv, outcomes.csv, ranking.csv
Prints  the nearest ones

Example: /usr/bin/python3 -m analysis.conditions.rank stage1 --results results
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import pandas as pd

from analysis.conditions.command_line import argument_parser
from analysis.conditions.measures import measures
from analysis.conditions.verdicts import Outcome, distance, of_reading, outcomes
from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.output import write_csv

SHOWN = 16


def main(argv: Sequence[str] | None = None) -> None:
    """Measure, judge and rank all conditions of a stage."""
    parser = argument_parser(__doc__)
    parser.add_argument("stage", help="folder in DIR/conditions")
    parser.add_argument("--kept", type=Path, metavar="FOLDER", help="of an earlier search")
    args = parser.parse_args(argv)
    folder = args.results / "conditions" / args.stage
    if args.kept:
        write_csv(folder / "conditions.csv", read_conditions(args.kept / args.stage).reset_index())
        found = pd.read_csv(args.kept / args.stage / "measures.csv.gz")
    else:
        found, notes = measured(folder, list(read_conditions(folder).index))
        for note in notes:
            print(note, file=sys.stderr)
    judged = {name: outcomes(of_one) for name, of_one in found.groupby("condition", sort=False)}
    write_csv(folder / "measures.csv", found)
    write_csv(folder / "outcomes.csv", outcomes_frame(judged))
    ranking = ranked(judged)
    write_csv(folder / "ranking.csv", ranking)
    print(ranking.head(SHOWN).to_string(index=False, float_format="%.3f"))


def read_conditions(folder: Path) -> pd.DataFrame:
    """The unknowns of each condition, by its name. @raises InputError without such a file."""
    try:
        return pd.read_csv(folder / "conditions.csv", index_col="condition")
    except OSError as error:
        raise InputError(f"{folder / 'conditions.csv'}: {error.strerror}; run the stage") from error


def measured(folder: Path, conditions: list[str]) -> tuple[pd.DataFrame, list[str]]:
    """The measures of all conditions that have a record, with a column `condition`; and notes."""
    parts, notes = [], []
    for name in conditions:
        part, more = measures(folder / name / "records")
        notes += more
        if len(part):
            parts.append(part.assign(condition=name))
    if not parts:
        raise InputError(f"{folder}: holds no usable record (CONDITION/records/*.json)")
    return pd.concat(parts, ignore_index=True), notes


def ranked(judged: dict[str, list[Outcome]]) -> pd.DataFrame:
    """Condition, distance, nearer reading of "[11] with PF", and how many claims against it lean the
    paper's way; conditions without a distance are left out."""
    rows = []
    for name, found in judged.items():
        away, reading = distance(found)
        if reading:
            counted = of_reading(found, reading)
            rows.append((name, away, reading,
                         sum(o.leans for o in counted if o.claim.name == "order"),
                         sum(o.leans for o in counted), len(counted)))  # fmt: skip
    columns = ["condition", "distance", "reading", "orders", "claims", "of"]
    table = pd.DataFrame(rows, columns=columns)
    return table.sort_values("distance", kind="stable", ignore_index=True)


def outcomes_frame(judged: dict[str, list[Outcome]]) -> pd.DataFrame:
    """A row for each condition and claim."""
    return pd.DataFrame(
        [
            {"condition": name, "claim": o.claim.key, "mean": o.mean, "low": o.low, "high": o.high}
            | {"n": o.n, "verdict": o.verdict, "leans": o.leans, "power": o.power}
            for name, found in judged.items()
            for o in found
        ]
    )


if __name__ == "__main__":
    sys.exit(run(main))
