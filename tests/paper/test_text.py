"""No number is typed: the hand-written text of the report has digits in a few known places alone."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
TEXTS = sorted((ROOT / "paper" / "sections").glob("*.tex"))
OPEN_POINTS = ROOT / "analysis" / "report" / "open_points.toml"

MATHS = re.compile(r"\\begin\{(equation|gather)\}.*?\\end\{\1\}", re.DOTALL)
COMMENT = re.compile(r"(?<!\\)%.*")
ALLOWED = [
    re.compile(pattern)
    for pattern in (
        r"\\(?:ref|label|cite|val|home|input|sweep|halfpicture)\{[^}]*\}",  # names, not text
        r"\\hspace\{[^}]*\}|\[[\d.]+pt\]",  # lengths
        r"(?:Sec\.|Fig\.|Eq\.|Eqs\.)[~ ]\d[\d.]*(?:, ?\d[\d.]*)*",  # places of the paper
        r"(?:Figures?|Tables?)[~ ]\d+(?:--\d+)?",
        r"[Ss]cenarios? \d",  # names of the paper
        r"\\code\{outdoor[12]\}",  # names of ours
        r"\[(?:9|11|9,11)\]",  # its references
        r"[Cc]ase[~ ][12]",
        r"TX2",
        r"F1\b",  # the score
    )
]
# From three on, a number in words is a result, or could be one.
WORDS = re.compile(
    r"\b(three|four|five|six|seven|eight|nine|ten|eleven|twelve|\w+teen|twenty|\w+ty-\w+|hundred|"
    r"thousand|million|percent|twice|thrice|double)\b",
    re.IGNORECASE,
)


def typed_numbers(text: str) -> list[str]:
    """Each digit or number word in LaTeX text, with what stands around it."""
    text = MATHS.sub("", COMMENT.sub("", text))
    for allowed in ALLOWED:
        text = allowed.sub("", text)
    found = [*re.finditer(r"\d+", text), *WORDS.finditer(text)]
    return [text[max(0, m.start() - 20) : m.end() + 20] for m in found]


def large_digits(text: str) -> list[str]:
    """Digits in equations other than the equations' own numbers, 0, 1 and 2."""
    formulas = "".join(match.group() for match in MATHS.finditer(text))
    return re.findall(r"[3-9]|\d\d", re.sub(r"\\tag\{[^}]*\}", "", formulas))


def test_there_is_text():
    assert len(TEXTS) >= 9


@pytest.mark.parametrize("file", TEXTS, ids=lambda file: file.stem)
def test_no_number_is_typed(file):
    text = file.read_text(encoding="utf-8")
    assert typed_numbers(text) == []
    assert large_digits(text) == []


def test_no_number_is_typed_in_the_open_points():
    lines = OPEN_POINTS.read_text(encoding="utf-8").splitlines()
    written = [line for line in lines if line.startswith(("question", "settled"))]
    assert written and typed_numbers("\n".join(re.sub(r"\{[\w.]+\}", "", w) for w in written)) == []


@pytest.mark.parametrize(
    "typed", ["an error of 0.12 m/s", "of nine orders", "99.5\\,\\%", "Section~4", "$2.5$", "200,000"]
)
def test_typed_numbers_are_found(typed):
    assert typed_numbers(typed)


@pytest.mark.parametrize(
    "typed", ["Sec.~4.1.3", "the paper's Figures 6--9", "scenario 2", "[11]", r"\val{parameter.x_2}"]
)
def test_places_and_names_are_none(typed):
    assert typed_numbers(typed) == []
