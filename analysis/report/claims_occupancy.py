"""The claims of Sec. 4.1.2: Table 1, its causes, and the computation time."""

from __future__ import annotations

from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.scores import SCORES
from analysis.data.statistics import Interval
from analysis.figures.computation_time import METHOD, TOTAL, serial_records, time_table
from analysis.report import latex
from analysis.report.claim_rows import Row, open_row, order_rows
from analysis.report.comparisons import NO, PARTLY, YES, compare
from analysis.report.evidence import Evidence
from analysis.tables.accuracy_table import PUBLISHED
from analysis.tables.beside import scenario_name


def table1_rows(evidence: Evidence) -> list[Row]:
    study = evidence.study("table1")
    return [
        row
        for scenario, values in published()["table1"].items()
        for score in PUBLISHED
        for row in order_rows(study, scenario, score, values[score.name], values["place"],
                              r"Table~\ref{tab:accuracy}")
    ]  # fmt: skip


def cause_rows(evidence: Evidence) -> list[Row]:
    causes = published()["causes"]
    study = evidence.study("ablation")
    rows = []
    for name, without, score_names in (
        ("prediction", "no_prediction", ("case1_voxels", "case2_voxels")),
        ("survival", "no_survival", ("accuracy_pct",)),
    ):
        for scenario in causes[name]["scenarios"]:
            statement = f"{scenario_name(scenario)}: {name} is the cause ({causes[name]['claim']})"
            rows.append(_cause_row(study, statement, causes[name]["place"], scenario, without,
                                   score_names))  # fmt: skip
    return rows


def _cause_row(
    study: Study | None, statement: str, place: str, scenario: str, without: str,
    score_names: tuple[str, ...],
) -> Row:  # fmt: skip
    """The LDM against itself without the ingredient: all of the scores must fall with it."""
    where = r"Table~\ref{tab:open-points}"
    if study is None:
        return open_row(statement, place, "in words", latex.missing("ablation"), where)
    found = {name: compare(study, scenario, name, "ldm", without) for name in score_names}
    if not all(c.difference.n for c in found.values()):
        return open_row(statement, place, "in words", latex.missing("ablation"), where)
    falls = [c.difference.high < 0 for c in found.values()]
    lines = tuple(
        f"{SCORES[name].label}: with $-$ without "
        + latex.interval(c.difference, SCORES[name].difference_decimals, sign=True)
        for name, c in found.items()
    )
    verdict = YES if all(falls) else PARTLY if any(falls) else NO
    p = max(c.p for c in found.values())
    return Row(statement, latex.plain(place), "in words", lines, verdict, where, p)


def time_row(evidence: Evidence) -> Row:
    entry = published()["computation_time"]
    bound = entry["total_ms"][METHOD]
    statement = "Average total computation time of an update"
    where = r"Table~\ref{tab:time}"
    study = evidence.study("timing")
    if study is None:
        return open_row(statement, entry["place"], f"{bound} ms", latex.missing("timing"), where)
    records = serial_records(study)
    table = time_table(records, study.methods).set_index(["method", "stage"])
    total = table.loc[(METHOD, TOTAL)]
    found = Interval(total["mean_ms"], total["low_ms"], total["high_ms"], int(total["trials"]))
    cpu = latex.latex_text(str(records[0]["provenance"]["cpu"]))
    lines = (latex.interval(found, 1) + " ms", f"another machine: {cpu}")
    verdict = PARTLY if found.mean <= bound else NO  # another machine than the paper's
    return Row(statement, latex.plain(entry["place"]), f"{bound} ms", lines, verdict, where)


