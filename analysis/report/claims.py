"""The claims ledger: every claim of the paper's evaluation, ours, a paired test, and a verdict."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import numpy as np

from analysis.data.statistics import holm
from analysis.report import latex
from analysis.report.claim_rows import Row
from analysis.report.claims_occupancy import cause_rows, table1_rows, time_row
from analysis.report.claims_outdoor import outdoor_rows
from analysis.report.claims_velocity import velocity_rows
from analysis.report.comparisons import NO, OPEN, PARTLY, YES
from analysis.report.evidence import Evidence

VERDICTS = (YES, PARTLY, NO, OPEN)
_COLUMNS = r"r>{\raggedright\arraybackslash}p{44mm}>{\raggedright\arraybackslash}p{20mm}" \
    r">{\raggedright\arraybackslash}p{57mm}rl"


def ledger(evidence: Evidence) -> list[Row]:
    """All claims, in the order of the paper; the p of all are corrected together (Holm)."""
    rows = table1_rows(evidence) + cause_rows(evidence) + [time_row(evidence)]
    rows += velocity_rows(evidence) + outdoor_rows(evidence)
    corrected = holm(np.array([row.p for row in rows]))
    return [replace(row, p=float(p)) for row, p in zip(rows, corrected)]


def counts(rows: list[Row]) -> dict[str, int]:
    """How many claims have each verdict."""
    found = Counter(row.verdict for row in rows)
    return {verdict: found[verdict] for verdict in VERDICTS}


def ledger_table(rows: list[Row], caption: str) -> str:
    """The ledger as LaTeX, with numbered claims."""
    head = r"& Claim, \textit{place, where to look} & Published & Ours & $p$ & Verdict \\"
    lines = []
    for number, row in enumerate(rows, start=1):
        claim = rf"{row.statement}. \textit{{{row.place}; {row.where}}}"
        ours = r" \newline ".join(row.ours)
        verdict = rf"\verdict{row.verdict.replace('reproduced', 'yes')}"
        cells = [str(number), claim, row.published, ours, latex.test(row.p), verdict]
        lines.append(" & ".join(cells) + r" \\[3pt]")
    return latex.longtable(_COLUMNS, head, lines, caption, "tab:ledger")
