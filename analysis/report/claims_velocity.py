"""The claims of Sec. 4.1.3: velocities."""

from __future__ import annotations

from analysis.data import series_scores
from analysis.data.published import PF_READINGS, paper_name, published
from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.data.statistics import mean_interval
from analysis.report import latex
from analysis.report.claim_rows import (
    Row,
    difference_line,
    open_row,
    order_rows,
    pair_lines,
    share_row,
)
from analysis.report.comparisons import NO, PARTLY, YES, compare, paired
from analysis.report.evidence import Evidence
from analysis.tables.beside import scenario_name
from analysis.tables.velocity_table import PUBLISHED

METHOD = "ldm"
Pair = tuple[str, str]
"""The method, and a reading of "[11] with PF"."""


def velocity_rows(evidence: Evidence) -> list[Row]:
    study = evidence.study("table1")
    entries = published()["velocity"]
    rows = [
        row
        for entry in entries.values() for score in PUBLISHED if score.name in entry
        for row in order_rows(study, entry["scenario"], score, entry[score.name], entry["place"],
                              r"Table~\ref{tab:velocity}")
    ]  # fmt: skip
    static, dynamic = (entries[kind]["scenario"] for kind in ("static", "dynamic"))
    for reading in PF_READINGS:
        pair = (METHOD, reading)
        rows.append(_static_times_row(study, static, pair, entries["static_times"]))
        rows.append(_convergence_row(study, dynamic, pair, entries["convergence"]))
        rows.append(_constancy_row(study, dynamic, pair, entries["constancy"]))
    return rows


def _static_times_row(study: Study | None, scenario: str, pair: Pair, entry: dict) -> Row:
    statement = f"{scenario_name(scenario)}: static error smaller than that of {paper_name(pair[1])}"
    where = r"Figure~\ref{fig:figure6}"
    if study is None:
        return open_row(statement, entry["place"], entry["claim"], latex.missing("table1"), where)
    shares = series_scores.better_share(study, scenario, pair)
    return share_row(statement, entry, shares, "of the frames", where)


def _convergence_row(study: Study | None, scenario: str, pair: Pair, entry: dict) -> Row:
    """Similar: the whole interval of the difference is smaller than the least one that matters."""
    score = SCORES["time_to_converge_s"]
    statement = f"{scenario_name(scenario)}: {score.label} as that of {paper_name(pair[1])}"
    where = r"Figure~\ref{fig:figure7}"
    if study is None:
        return open_row(statement, entry["place"], entry["claim"], latex.missing("table1"), where)
    found = compare(study, scenario, score.name, *pair)
    low, high, margin = found.difference.low, found.difference.high, score.smallest_difference
    within = -margin <= low and high <= margin
    touches = low <= margin and high >= -margin
    lines = pair_lines(study, scenario, score, pair)
    lines += (difference_line(found, 2) + f" s, similar within {margin} s",)
    verdict = YES if within else PARTLY if touches else NO
    return Row(statement, latex.plain(entry["place"]), entry["claim"], lines, verdict, where,
               found.p)  # fmt: skip


def _constancy_row(study: Study | None, scenario: str, pair: Pair, entry: dict) -> Row:
    statement = (
        f"{scenario_name(scenario)}: the estimate of a constant velocity fluctuates less than "
        f"that of {paper_name(pair[1])}"
    )
    where = r"Figures~\ref{fig:figure7}--\ref{fig:figure9}"
    if study is None:
        return open_row(statement, entry["place"], entry["claim"], latex.missing("table1"), where)
    ours, theirs = (
        series_scores.score_trials(study, scenario, method, series_scores.fluctuation)
        for method in pair
    )
    found = paired(ours, theirs, "lower")
    lines = tuple(
        f"{paper_name(method)} {latex.interval(mean_interval(values.to_numpy()), 3)} m/s"
        for method, values in zip(pair, (ours, theirs))
    ) + (difference_line(found, 3),)
    verdict = YES if found.difference.high < 0 else NO
    return Row(statement, latex.plain(entry["place"]), entry["claim"], lines, verdict, where,
               found.p)  # fmt: skip
