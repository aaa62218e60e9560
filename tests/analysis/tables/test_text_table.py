"""Numbers and tables as text."""

import math

from analysis.data.statistics import Interval
from analysis.tables.text_table import aligned, interval, latex_tabular, latex_text, number, p_value


def test_numbers():
    assert number(1234.56, 1) == "1,234.6"
    assert number(-0.0001, 2, sign=True) == "+0.00"
    assert number(math.nan, 2) == number(None, 0) == "-"


def test_intervals():
    assert interval(Interval(1.25, 1.0, 1.5, 3), 2) == "1.25 [1.00, 1.50]"
    assert interval(Interval(1.25, math.nan, math.nan, 1), 2) == "1.25"
    assert interval(Interval(math.nan, math.nan, math.nan, 0), 2) == "-"


def test_p_values():
    found = [p_value(p) for p in (0.0004, 0.0123, 0.5, 1.0, math.nan)]
    assert found == ["<0.001", "0.012", "0.50", "1.00", "-"]


def test_columns_line_up():
    assert aligned(["a", "bb"], [["x", "1"], [], ["long", "22"]]) == (
        "a     bb\n--------\nx      1\n\nlong  22\n"
    )


def test_latex():
    assert latex_text("a_b & 5%") == r"a\_b \& 5\%"
    assert latex_tabular("lr", [r"a & b \\"], [["x", "1"], [], ["y", "2"]]) == (
        "\\begin{tabular}{lr}\n\\toprule\na & b \\\\\n\\midrule\nx & 1 \\\\\n\\midrule\n"
        "y & 2 \\\\\n\\bottomrule\n\\end{tabular}\n"
    )
