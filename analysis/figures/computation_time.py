"""Computation time of one update, per stage, beside the paper's 98 ms.

Only records whose `timing.serial` is true count: trials that ran beside others measure the machine.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/tables/computation_time.{txt,csv}
        DIR/NAME/figures/computation_time.{png,pdf,txt}
Prints  the text

Example: /usr/bin/python3 -m analysis.figures.computation_time --results results --study timing
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Sequence

import numpy as np
import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analysis.data.command_line import parser, run, study_of
from analysis.data.errors import InputError
from analysis.data.output import write_csv, write_text
from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.statistics import Interval, mean_interval
from analysis.figures.figure_style import (
    BLUE,
    COLUMN_WIDTH,
    PLAIN_NUMBERS,
    method_styles,
    new_figure,
    save,
)
from analysis.tables.text_table import aligned, interval, number

TOTAL = "total"
METHOD = "ldm"
"""The method whose stages the figure shows."""


def serial_records(study: Study) -> list[dict]:
    """The records with valid timings.

    Raises
    ------
    InputError
        If there is none, or they are of different processors.
    """
    records = [r for r in study.records if r.get("timing", {}).get("serial") is True]
    if not records:
        raise InputError(f"{study.folder}: no record has timing.serial true; run `make timing`")
    processors = sorted({str(record["provenance"].get("cpu")) for record in records})
    if len(processors) > 1:
        raise InputError(
            f"{study.folder}: timings of different processors: {' and '.join(processors)}"
        )
    return records


def time_table(records: list[dict], methods: list[str]) -> pd.DataFrame:
    """One row for each method and stage, in the order of the stages, then the total [ms].

    `mean` with its interval `low`, `high` is over trials of each trial's mean; `median` is over
    trials of each trial's median.
    """
    rows = []
    for method in methods:
        timings = [r["timing"] for r in records if r["method"] == method]
        stages: dict[str, list[dict]] = {}
        for timing in timings:
            for stage, values in timing["stages_ms"].items():
                stages.setdefault(stage, []).append(values)
            stages.setdefault(TOTAL, []).append(timing["update_time_ms"])
        stages[TOTAL] = stages.pop(TOTAL, [])
        for stage, values in stages.items():
            if values:
                mean = mean_interval(np.array([value["mean"] for value in values]))
                median = float(np.median([value["median"] for value in values]))
                rows.append((method, stage, median, mean.mean, mean.low, mean.high, mean.n))
    return pd.DataFrame(
        rows, columns=["method", "stage", "median_ms", "mean_ms", "low_ms", "high_ms", "trials"]
    )


def table_text(study: Study, records: list[dict], table: pd.DataFrame) -> str:
    """The whole of computation_time.txt."""
    rows: list[list[str]] = []
    for method, of_method in table.groupby("method", sort=False):
        for row in of_method.itertuples():
            mean = Interval(row.mean_ms, row.low_ms, row.high_ms, row.trials)
            paper = _paper_ms(method) if row.stage == TOTAL else None
            rows.append(
                [method, row.stage, number(row.median_ms, 3), interval(mean, 3), number(paper, 0)]
            )
        rows.append([])
    head = ["method", "stage", "median (ms)", "mean (ms) [95% over trials]", "paper (ms)"]
    return "\n".join(
        [
            "Computation time of one update, serial runs, warm-up left out;",
            f"{records[0]['provenance']['cpu']}; {study.source()}.",
            "The paper's value is the average total of Sec. 4.1.2; it does not name the machine.\n",
            aligned(head, rows[:-1], left=2),
        ]
    )


def time_figure(table: pd.DataFrame) -> Figure:
    """Above the stages of the LDM, below every method's total beside the paper's."""
    stages = table[(table["method"] == METHOD) & (table["stage"] != TOTAL)]
    totals = table[table["stage"] == TOTAL]
    figure = new_figure(COLUMN_WIDTH, 1.3 + 0.17 * (len(stages) + len(totals)))
    upper, lower = figure.subplots(
        2, 1, height_ratios=[max(len(stages), 1) + 1, len(totals) + 2]
    )
    styles = method_styles(list(totals["method"]))
    colours = {method: colour for method, (colour, _) in styles.items()}
    places = np.arange(len(stages))
    upper.barh(places, stages["mean_ms"], color=colours.get(METHOD), height=0.7)
    _name(upper, stages["stage"], f"mean time of a stage of {METHOD} (ms)")
    for place, row in enumerate(totals.itertuples()):
        lower.plot(row.mean_ms, place, "o", color=colours[row.method], markersize=5)
        lower.plot([row.low_ms, row.high_ms], [place, place], color=colours[row.method])
    _name(lower, totals["method"], "mean time of an update (ms)")
    lower.set_xscale("log")
    lower.xaxis.set_major_formatter(PLAIN_NUMBERS)
    paper = _paper_ms(METHOD)
    lower.axvline(paper, color=BLUE, linestyle="--")
    lower.set_title(f"dashed: the paper's {paper} ms", color=BLUE, loc="right", pad=3)
    return figure


def _name(axes: Axes, names: pd.Series, label: str) -> None:
    axes.set_yticks(np.arange(len(names)), [name.replace("_", " ") for name in names])
    axes.set_ylim(len(names) - 0.4, -0.6)
    axes.set_xlabel(label)


def _paper_ms(method: str) -> float | None:
    return published()["computation_time"]["total_ms"].get(method)


def draw(study: Study, records: list[dict], table: pd.DataFrame, folder: Path) -> list[Path]:
    """Make the figure in `folder`; returns the pictures."""
    caption = (
        f"Computation time of one update on {records[0]['provenance']['cpu']}: mean over trials "
        "with its 95% bootstrap interval. Above: stages of ldm; below: all methods. "
        f"Source: {study.source()}."
    )
    return save(time_figure(table), folder / "computation_time", caption)


def main(argv: Sequence[str] | None = None) -> None:
    """Make the table and the figure of one study."""
    args = parser(__doc__, study="timing").parse_args(argv)
    study = study_of(args, swept=False)
    records = serial_records(study)
    table = time_table(records, study.methods)
    text = table_text(study, records, table)
    write_text(study.folder / "tables" / "computation_time.txt", text)
    write_csv(study.folder / "tables" / "computation_time.csv", table)
    print(text, *draw(study, records, table, study.folder / "figures"), sep="\n")


if __name__ == "__main__":
    sys.exit(run(main))
