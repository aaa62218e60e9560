"""Table 1 of the paper: ours beside the published values, for every method of the study.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/tables/: table1.txt, table1.csv, table1.tex, table1_orderings.csv, and the velocity
        errors of Sec. 4.1.3 as velocity.txt, velocity.csv, velocity.tex, velocity_orderings.csv
Prints  both texts

Example: /usr/bin/python3 -m analysis.tables.table1 --results results --study table1
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Sequence

from analysis.data.command_line import parser, run, study_of
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study
from analysis.tables import accuracy_table, velocity_table
from analysis.tables.beside import long_table
from analysis.tables.mean_table import Means, mean_table
from analysis.tables.orderings import orderings_frame


def write_part(name: str, part: ModuleType, study: Study) -> str:
    """Write the files NAME of one table, `accuracy_table` or `velocity_table`; its text."""
    table = mean_table(study, part.SHOWN)
    means = Means(table)
    found = part.judge_orderings(study)
    text = part.table_text(study, means, found)
    folder = study.folder / "tables"
    write_text(folder / f"{name}.txt", text)
    write_csv(folder / f"{name}.csv", long_table(table, part.SHOWN, part.published_cell))
    write_csv(folder / f"{name}_orderings.csv", orderings_frame(found))
    write_text(folder / f"{name}.tex", part.tabular(study, means))
    return text


def main(argv: Sequence[str] | None = None) -> None:
    """Make the tables of one study."""
    args = parser(__doc__, study="table1").parse_args(argv)
    study = study_of(args, swept=False)
    print(write_part("table1", accuracy_table, study))
    print(write_part("velocity", velocity_table, study))


if __name__ == "__main__":
    sys.exit(run(main))
