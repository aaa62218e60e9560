"""The velocity errors of Sec. 4.1.3 beside the paper's, of a study that has these methods alone.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/tables/: velocity.txt, velocity.csv, velocity.tex, velocity_orderings.csv
Prints  the text

Example: /usr/bin/python3 -m analysis.tables.velocity --results results --study velocity
"""

from __future__ import annotations

import sys
from typing import Sequence

from analysis.data.command_line import parser, run, study_of
from analysis.tables import velocity_table
from analysis.tables.table1 import write_part


def main(argv: Sequence[str] | None = None) -> None:
    """Make the table of one study."""
    args = parser(__doc__, study="velocity").parse_args(argv)
    study = study_of(args, swept=False)
    print(write_part("velocity", velocity_table, study))


if __name__ == "__main__":
    sys.exit(run(main))
