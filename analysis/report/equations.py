"""The index of equations (tests/equations.py --json), for the report: files and test of each."""

from __future__ import annotations

import json
from pathlib import Path
from typing import NamedTuple

from analysis.data.errors import InputError
from analysis.report import latex
from analysis.tables.text_table import latex_tabular


class Equation(NamedTuple):
    """One row of the index."""

    number: str
    symbol: str
    file: str
    plain: str  # the file that computes it in plain words; empty for a score
    test: str


def read_index(file: Path) -> list[Equation]:
    """The equations of the printed index.

    Raises
    ------
    InputError
        If the file is not such an index.
    """
    try:
        return [
            Equation(
                number=str(row["number"]),
                symbol=row["fast"]["symbol"],
                file=row["fast"]["file"],
                plain=row.get("plain", {}).get("file", ""),
                test=row["tests"]["symbol"],
            )
            for row in json.loads(file.read_text(encoding="utf-8"))
        ]
    except (OSError, ValueError, TypeError, KeyError) as error:
        raise InputError(f"{file}: not the index of tests/equations.py --json: {error!r}") from error


def index_table(equations: list[Equation], caption: str) -> str:
    """The index as a table."""
    rows = [
        [equation.number, *(latex.code(text) if text else "" for text in
                            (equation.plain, equation.symbol, equation.file, equation.test))]
        for equation in equations
    ]
    head = r"Eq. & in plain words & symbol & declared in & test \\"
    body = latex_tabular("rllll", [head], rows)
    return latex.table(r"\fitted{\footnotesize " + body.strip() + "}", caption, "tab:equations")
