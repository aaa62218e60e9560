"""The index that `make equations` prints, for the report: the file and the test of each equation."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from analysis.data.errors import InputError
from analysis.report import latex
from analysis.tables.text_table import latex_tabular


class Equation(NamedTuple):
    """One row of the index."""

    number: str
    symbol: str
    place: str  # file:line
    test: str

    @property
    def file(self) -> str:
        """The file without the line."""
        return self.place.partition(":")[0]


def read_index(file: Path) -> list[Equation]:
    """The equations of the printed index.

    Raises
    ------
    InputError
        If the file is not such an index.
    """
    try:
        _, *lines = file.read_text(encoding="utf-8").splitlines()
        return [Equation(*line.split()) for line in lines]
    except (OSError, ValueError, TypeError) as error:
        raise InputError(f"{file}: not what `make equations` prints: {error}") from error


def index_table(equations: list[Equation], caption: str) -> str:
    """The index as a table."""
    rows = [
        [equation.number, *map(latex.code, (equation.symbol, equation.file, equation.test))]
        for equation in equations
    ]
    head = r"Eq. & symbol & declared in & test \\"
    body = latex_tabular("rlll", [head], rows)
    return latex.table(r"\fitted{\footnotesize " + body.strip() + "}", caption, "tab:equations")
