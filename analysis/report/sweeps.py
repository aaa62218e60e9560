"""What each sweep does to the LDM from its first point to its last, in one table."""

from __future__ import annotations

from analysis.data.records import Study
from analysis.data.scores import MAIN_SCORES, SCORES
from analysis.data.sweep_axis import sweep_axis
from analysis.report import latex
from analysis.report.comparisons import paired
from analysis.report.evidence import SWEEPS, Evidence
from analysis.tables.beside import scenario_name
from analysis.tables.text_table import latex_tabular

METHOD = "ldm"


def ends_table(evidence: Evidence, caption: str) -> str:
    """One row for each sweep and scenario: score at the last point - score at the first."""
    rows: list[list[str]] = []
    for name in SWEEPS:
        study = evidence.study(name)
        if rows:
            rows.append([])
        if study is None:
            rows.append([latex.code(name), rf"\multicolumn{{5}}{{l}}{{{latex.missing(name)}}}"])
        else:
            rows += _study_rows(study)
    head = ["study, from", "scenario", *(_short(name) for name in MAIN_SCORES)]
    body = latex_tabular("llrrrr", [" & ".join(head) + r" \\"], rows)
    return latex.table(r"\fitted{" + body.strip() + "}", caption, "tab:sweeps")


def _study_rows(study: Study) -> list[list[str]]:
    axis = sweep_axis(study.points)
    ordered = sorted(study.points, key=lambda point: (axis.line[point], axis.place[point]))
    first, last = ordered[0], ordered[-1]
    names = [latex.code(study.name), *_ends(study, first, last)]
    rows = []
    for scenario in study.scenarios:
        cells = []
        for score in map(SCORES.get, MAIN_SCORES):
            a, b = (study.per_seed(scenario, METHOD, score.name, p) for p in (last, first))
            difference = paired(a, b, score.better).difference
            cells.append(latex.interval(difference, score.difference_decimals, sign=True))
        rows.append([names.pop(0) if names else "", scenario_name(scenario), *cells])
    return rows + [[name, "", "", "", "", ""] for name in names]


def _ends(study: Study, first: str, last: str) -> list[str]:
    """`name: first to last` for each swept parameter, as LaTeX."""
    a, b = study.points[first], study.points[last]
    return [
        rf"{latex.code(name.rpartition('.')[2])}: {latex.plain(str(a[name]))} to "
        + latex.plain(str(b[name]))
        for name in a
        if a[name] != b[name]
    ]


def _short(name: str) -> str:
    return latex.latex_text(SCORES[name].axis_label)
