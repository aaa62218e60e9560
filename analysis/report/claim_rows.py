"""Rows of the claims ledger, and the kinds of claims that come more than once."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import pandas as pd

from analysis.data.published import paper_name, published
from analysis.data.records import Study
from analysis.data.scores import Score
from analysis.data.statistics import PairedComparison, mean_interval
from analysis.report import latex
from analysis.report.comparisons import NO, OPEN, PARTLY, YES, compare, verdict_on_order
from analysis.tables.beside import scenario_name
from analysis.tables.orderings import Claim, published_claims

MOST_PCT = 95
"""What we take "almost all times" and "the direction is right" to mean [% of the frames]."""


@dataclass(frozen=True)
class Row:
    """One claim; all text is LaTeX already."""

    statement: str
    place: str
    published: str
    ours: tuple[str, ...]  # lines
    verdict: str
    where: str  # to look
    p: float = math.nan  # NaN: no paired test


def open_row(statement: str, place: str, published_text: str, reason: str, where: str) -> Row:
    return Row(statement, latex.plain(place), published_text, (reason,), OPEN, where)


def pair_lines(
    study: Study, scenario: str, score: Score, pair: tuple[str, str]
) -> tuple[str, ...]:
    return tuple(
        f"{paper_name(method)} "
        + latex.interval(mean_interval(study.per_seed(scenario, method, score.name)),
                         score.decimals)
        for method in pair
    )  # fmt: skip


def difference_line(found: PairedComparison, decimals: int) -> str:
    """How much the first method is above the second."""
    return "difference " + latex.interval(found.difference, decimals, sign=True)


def order_rows(
    study: Study | None, scenario: str, score: Score, values: dict[str, float], place: str,
    where: str,
) -> list[Row]:  # fmt: skip
    """The order of two published values and the size of their difference, for each reading of the baseline."""
    return [
        _order_row(study, claim, score, values, place, where)
        for claim in published_claims(scenario, score.name, values)
    ]


def _order_row(
    study: Study | None, claim: Claim, score: Score, values: dict[str, float], place: str,
    where: str,
) -> Row:  # fmt: skip
    scenario = claim.scenario
    pair = (claim.method, claim.baseline)
    names = " than ".join(paper_name(method) for method in pair).replace(" than", " is %s than")
    statement = f"{scenario_name(scenario)}, {score.label}: " + names % claim.word
    unit = latex.latex_text(f" {score.unit}" if score.unit else "")
    shown = " and ".join(latex.value(v, score.decimals) for v in (values[m] for m in pair)) + unit
    if study is None:
        return open_row(statement, place, shown, latex.missing("table1"), where)
    found = compare(study, scenario, score.name, *pair)
    ours, theirs = (study.per_seed(scenario, method, score.name) for method in pair)
    lines = pair_lines(study, scenario, score, pair)
    lines += (difference_line(found, score.difference_decimals),)
    verdict = verdict_on_order(_scaled(claim, score, study), found, (ours - theirs).dropna())
    return Row(statement, latex.plain(place), shown, lines, verdict, where, found.p)


def share_row(statement: str, entry: dict, shares: pd.Series, what: str, where: str) -> Row:
    """A share of frames that must be nearly all; partly if it is at least more than half."""
    found = mean_interval(shares.to_numpy())
    verdict = YES if found.low >= MOST_PCT else PARTLY if found.low > 50 else NO
    text = latex.latex_text(entry.get("claim", ""))
    line = latex.interval(found, 1) + rf"\,\% {what}"
    return Row(statement, latex.plain(entry["place"]), text, (line,), verdict, where)


def _scaled(claim: Claim, score: Score, study: Study) -> Claim:
    """A sum over the paper's frames as one over the study's."""
    factor = study.frames / published()["setup"]["frames"]["value"] if score.summed else 1
    return replace(claim, published_difference=claim.published_difference * factor)


