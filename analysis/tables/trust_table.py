"""How far each map is trusted: the point of the study of margins that each arm takes.

Of all points an arm takes the one at which most of its flights arrive; of equals the first, whose
values are the smaller ones.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/tables/: trust.txt, trust.csv
Prints  the table

Example: /usr/bin/python3 -m analysis.tables.trust_table --results results --study avoidance_trust
"""

from __future__ import annotations

import sys
from typing import Sequence

import pandas as pd

from analysis.data.command_line import parser, run, study_of
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study
from analysis.tables.avoidance_table import arms
from analysis.tables.text_table import aligned


def arrivals(study: Study) -> pd.DataFrame:
    """A row for each arm and point, in the study's order of both: flights, and how many arrive."""
    flown = study.trials.groupby(["method", "point"])["success"].agg(["size", "sum"])
    return pd.DataFrame([(arm, point, *flown.loc[arm, point].astype(int))
                         for arm in arms(study) for point in study.points],
                        columns=["arm", "point", "flights", "arrive"])  # fmt: skip


def chosen(table: pd.DataFrame) -> pd.Series:
    """Arm -> its point, by the rule above."""
    best = table.loc[table.groupby("arm", sort=False)["arrive"].idxmax()]
    return best.set_index("arm")["point"]


def write_table(study: Study) -> str:
    """Write trust.{txt,csv} of a study; returns the text."""
    table = arrivals(study)
    taken = chosen(table)
    table["taken"] = table["point"] == table["arm"].map(taken)
    write_csv(study.folder / "tables" / "trust.csv", table)
    rows = [[arm, *(f"{row.arrive}{'*' if row.taken else ''}" for row in points.itertuples()),
             str(points["flights"].max())] for arm, points in table.groupby("arm", sort=False)]  # fmt: skip
    text = (f"Flights that arrive, of those at the right; *: what the arm takes; {study.source()}.\n\n"
            + aligned(["arm", *study.points, "of"], rows))  # fmt: skip
    write_text(study.folder / "tables" / "trust.txt", text)
    return text


def main(argv: Sequence[str] | None = None) -> None:
    args = parser(__doc__, "avoidance_trust").parse_args(argv)
    study = study_of(args)
    print(write_table(study))


if __name__ == "__main__":
    sys.exit(run(main))
