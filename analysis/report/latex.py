"""LaTeX text for numbers, intervals, missing studies and captions."""

from __future__ import annotations

import math
import re

from analysis.data.statistics import Interval
from analysis.report.evidence import command
from analysis.tables.text_table import NOTHING, latex_text, number, p_value


def missing(study: str) -> str:
    """What stands where a study is missing."""
    return rf"\missing{{{latex_text(command(study))}}}"


def code(text: str) -> str:
    """A name as the program writes it; it may break after an underscore, a dot or a slash."""
    broken = re.sub(r"(?<=[_./])", r"\\allowbreak ", text).replace("_", r"\_")
    return rf"\code{{{broken}}}"


def plain(text: str) -> str:
    """Text with minus signs instead of hyphens before digits, and special characters escaped."""
    return re.sub(r"-(?=\d)", "$-$", latex_text(text))


def value(found: float | None, decimals: int, sign: bool = False) -> str:
    """A number, or "-"."""
    return plain(number(found, decimals, sign))


def interval(found: Interval, decimals: int, sign: bool = False) -> str:
    """Mean and interval in one line."""
    mean, bounds = interval_parts(found, decimals, sign)
    return f"{mean} {bounds}" if bounds else mean


def stacked(found: Interval, decimals: int) -> str:
    """Mean and, below it in small print, the interval; for narrow columns."""
    mean, bounds = interval_parts(found, decimals, sign=False)
    return rf"\stacked{{{mean}}}{{{bounds}}}" if bounds else mean


def interval_parts(found: Interval, decimals: int, sign: bool = False) -> tuple[str, str]:
    """Mean, and `[low, high]` in small print; the second is empty without an interval."""
    mean = value(found.mean, decimals, sign)
    if math.isnan(found.low):
        return mean, ""
    low, high = (value(bound, decimals, sign) for bound in (found.low, found.high))
    return mean, rf"\bounds{{{low}}}{{{high}}}"


def test(p: float) -> str:
    """A p-value."""
    text = p_value(p)
    return text if text == NOTHING else text.replace("<", r"$<$")


def longtable(columns: str, head: str, rows: list[str], caption: str, label: str) -> str:
    """A table that may run over pages; `head` and `rows` are whole lines with their `\\\\`."""
    return "\n".join(
        [rf"\begin{{longtable}}{{{columns}}}",
         rf"\caption{{{caption}}}\label{{{label}}}\\",
         r"\toprule", head, r"\midrule", r"\endfirsthead",
         r"\toprule", head, r"\midrule", r"\endhead",
         r"\bottomrule", r"\endlastfoot", *rows, r"\end{longtable}"]
    ) + "\n"  # fmt: skip


def table(body: str, caption: str, label: str) -> str:
    """A floating table around a tabular."""
    return "\n".join([r"\begin{table}[!htb]", r"\centering\small", rf"\caption{{{caption}}}",
                      rf"\label{{{label}}}", body.strip(), r"\end{table}"]) + "\n"  # fmt: skip


def breakable(text: str) -> str:
    """LaTeX text in which long names may break after an underscore."""
    return text.replace(r"\_", r"\_\allowbreak ")
