"""The figures of the report, each with its caption, or what is missing in its place."""

from __future__ import annotations

import re
from pathlib import Path

from analysis.data.output import write_text
from analysis.data.scores import MAIN_SCORES, find_scores
from analysis.figures import (
    avoidance_figures,
    computation_time,
    figure5,
    flight_figures,
    outdoor_figures,
    sweep_figure,
    velocity_figures,
)
from analysis.report import latex
from analysis.report.evidence import FLIGHT, SWEEPS, WORLDS, Evidence
from analysis.tables.mean_table import mean_table

_STUDY = {
    "figure5": WORLDS,
    **{f"figure{number}": "table1" for number in (6, 7, 8, 9)},
    "velocity_errors": "table1",
    **{f"figure{number}": FLIGHT for number in (11, 12, 13)},
    **{name: "outdoor" for name in outdoor_figures.PERSONS},
    "computation_time": "timing",
    "avoidance": "avoidance",
    **{study: study for study in (*SWEEPS, "ablation")},
}
"""Figure -> what it is made of."""


def write_figures(evidence: Evidence, output: Path) -> None:
    """Draw what can be drawn, and write OUTPUT/figure-NAME.tex for every figure: picture, caption
    and label, for use within a `figure`."""
    folder = output / "figures"
    made = {path.stem for path in _draw_all(evidence, folder)}
    for name, study in _STUDY.items():
        if name in made:
            caption = _title(name) + (folder / f"{name}.txt").read_text(encoding="utf-8").strip()
            picture = rf"\plot{{{name}}}"
        else:
            caption, picture = _title(name) + "Missing.", rf"\framebox{{{latex.missing(study)}}}"
        text = f"{picture}\n\\caption{{{_caption(caption)}}}\\label{{fig:{name}}}\n"
        write_text(output / f"figure-{name.replace('_', '-')}.tex", text)


def _draw_all(evidence: Evidence, folder: Path) -> list[Path]:
    made: list[Path] = []
    if (worlds := evidence.folder(WORLDS)) is not None:
        made += figure5.draw(worlds, folder)
    if (study := evidence.study("table1")) is not None:
        made += velocity_figures.draw(study, folder)
    if (flight := evidence.folder(FLIGHT)) is not None:
        made += flight_figures.draw(flight, folder)
    if (study := evidence.study("outdoor")) is not None:
        made += outdoor_figures.draw(study, folder)
    if (study := evidence.study("avoidance")) is not None:
        made += avoidance_figures.draw(study, folder)
    if (study := evidence.study("timing")) is not None:
        records = computation_time.serial_records(study)
        table = computation_time.time_table(records, study.methods)
        made += computation_time.draw(study, records, table, folder)
    for name in (*SWEEPS, "ablation"):
        if (study := evidence.study(name)) is not None:
            scores = find_scores(list(MAIN_SCORES))
            table = mean_table(study, scores)
            scores = sweep_figure.shown_scores(table, scores, study)
            made += sweep_figure.draw(study, table, scores, folder / name)
    return made


def _title(name: str) -> str:
    """What a figure of a sweep is about; others say so themselves."""
    return f"{name.replace('_', ' ').capitalize()}. " if _STUDY[name] == name else ""


def _caption(text: str) -> str:
    """LaTeX numbers our figures itself: `Figure 6. ` of a caption is the paper's number."""
    ours = re.sub(r"^Figure (\d+)\. ", r"The paper's Figure \1: ", text)
    return latex.breakable(latex.plain(ours))
