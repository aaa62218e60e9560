"""Tables as aligned text and as LaTeX, and numbers as both show them."""

from __future__ import annotations

import math
from typing import Sequence

from analysis.data.statistics import Interval

NOTHING = "-"
"""What a cell without a value shows."""


def number(value: float | None, decimals: int, sign: bool = False) -> str:
    """`1,234.5`; "-" for None and NaN; never "-0.00"."""
    if value is None or math.isnan(value):
        return NOTHING
    value = round(value, decimals) + 0.0
    return f"{value:{'+' if sign else ''},.{decimals}f}"


def interval(value: Interval, decimals: int, sign: bool = False) -> str:
    """`1.2 [1.1, 1.3]`; the mean alone if there is no interval."""
    mean = number(value.mean, decimals, sign)
    if math.isnan(value.low):
        return mean
    low, high = (number(bound, decimals, sign) for bound in (value.low, value.high))
    return f"{mean} [{low}, {high}]"


def p_value(p: float) -> str:
    """Two significant digits, `<0.001` below; "-" for NaN."""
    if math.isnan(p):
        return NOTHING
    return "<0.001" if p < 0.001 else f"{p:.2g}" if p < 0.1 else f"{p:.2f}"


def aligned(
    head: Sequence[str], rows: Sequence[Sequence[str]], left: int = 1, last_left: bool = False
) -> str:
    """Text with columns of one width; an empty row becomes an empty line.

    The first `left` columns are flush left, and the last one with `last_left`; the others right.
    """
    widths = [max(len(row[i]) for row in [head, *rows] if row) for i in range(len(head))]
    flush_left = [i < left or (last_left and i == len(head) - 1) for i in range(len(head))]

    def line(row: Sequence[str]) -> str:
        cells = zip(row, widths, flush_left)
        return "  ".join(c.ljust(w) if flush else c.rjust(w) for c, w, flush in cells).rstrip()

    rule = "-" * (sum(widths) + 2 * (len(widths) - 1))
    return "\n".join([line(head), rule, *(line(row) for row in rows)]) + "\n"


def latex_text(text: str) -> str:
    """Text with LaTeX's special characters escaped."""
    for character in "&%#_":
        text = text.replace(character, "\\" + character)
    return text


def latex_tabular(columns: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A booktabs tabular; `head` are whole lines, an empty row becomes a \\midrule.

    Cells are LaTeX already: escape text with `latex_text` first.
    """
    body = [" & ".join(row) + r" \\" if row else r"\midrule" for row in rows]
    lines = [rf"\begin{{tabular}}{{{columns}}}", r"\toprule", *head, r"\midrule", *body]
    return "\n".join([*lines, r"\bottomrule", r"\end{tabular}"]) + "\n"
