"""The computation time of each stage of the LDM and of every method, as a table."""

from __future__ import annotations

from analysis.data.published import published
from analysis.data.statistics import Interval
from analysis.figures.computation_time import METHOD, TOTAL, serial_records, time_table
from analysis.report import latex
from analysis.report.evidence import Evidence
from analysis.tables.text_table import latex_tabular

LABEL = "tab:time"


def stages_table(evidence: Evidence, caption: str) -> str:
    """Stages of the LDM, then the totals of all methods [ms]."""
    study = evidence.study("timing")
    if study is None:
        return latex.table(latex.missing("timing"), caption, LABEL)
    found = time_table(serial_records(study), study.methods)
    stages = found[(found["method"] == METHOD) & (found["stage"] != TOTAL)]
    totals = found[found["stage"] == TOTAL]
    paper = published()["computation_time"]["total_ms"]
    rows = [[latex.plain(row.stage.replace("_", " ")), *_times(row), ""]
            for row in stages.itertuples()]  # fmt: skip
    rows.append([])
    rows += [[rf"total of {latex.code(row.method)}", *_times(row),
              latex.value(paper.get(row.method), 0)]
             for row in totals.itertuples()]  # fmt: skip
    body = latex_tabular("lrrr", [r"stage & median (ms) & mean (ms) & paper (ms) \\"], rows)
    return latex.table(body, caption, LABEL)


def _times(row) -> list[str]:
    mean = Interval(row.mean_ms, row.low_ms, row.high_ms, row.trials)
    return [latex.value(row.median_ms, 3), latex.interval(mean, 3)]
