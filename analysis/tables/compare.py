"""Paired comparison of methods over the same seeds.

For each scenario, point of a sweep, score and pair of methods: the mean difference with its 95%
bootstrap interval, the share of seeds won (ties count half), Wilcoxon's signed-rank test with
Holm's correction over the whole table, and the number of seeds that the smallest interesting
difference would need (power 80% at the 5% level; analysis/data/scores.py holds the differences).

Reads   DIR/NAME/records/*.json; a method that NAME lacks: DIR/NAME+METHOD/records/*.json
Writes  DIR/NAME/tables/compare.{txt,csv}
Prints  the text

Example: /usr/bin/python3 -m analysis.tables.compare --results results --study table1 --methods ldm,mine
"""

from __future__ import annotations

import math
import sys
from typing import Sequence

import pandas as pd

from analysis.data.command_line import name_list, parser, report_notes, run
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study, load_study
from analysis.data.scores import SCORES, find_scores
from analysis.data.statistics import SIGNIFICANCE, Interval
from analysis.tables.beside import scenario_name
from analysis.tables.paired_table import all_pairs, paired_table
from analysis.tables.text_table import aligned, interval, number, p_value

DEFAULT_SCORES = (
    "accuracy_pct",
    "case1_voxels",
    "case2_voxels",
    "mixed_voxels_per_frame",
    "f1",
    "static_velocity_error_mps",
    "dynamic_velocity_error_mps",
)


def table_text(study: Study, table: pd.DataFrame) -> str:
    """The whole of compare.txt."""
    parts = [
        "Paired comparison over the same seeds: method - baseline, mean [95% bootstrap interval];",
        f"p of the signed-rank test, corrected (Holm) over {len(table)} rows; {study.source()}.",
        "better, worse: the interval, which is not corrected, excludes 0; needs: seeds for the",
        "smallest interesting difference (analysis/data/scores.py) at a power of 80%.",
        *_too_few_seeds(study, len(table)),
        "",
        _rows(table),
        *(f"Note: {note}" for note in study.notes),
    ]
    return "\n".join(parts)


def verdict(row: pd.Series) -> str:
    """`better` or `worse` for the method if the interval of the difference excludes 0, else `-`."""
    if not Interval(row["difference"], row["low"], row["high"], row["seeds"]).excludes_zero:
        return "-"
    higher = row["difference"] > 0
    return "better" if higher == (SCORES[row["score"]].better == "higher") else "worse"


def _rows(table: pd.DataFrame) -> str:
    head = [
        "", "score", "method", "baseline", "method", "baseline", "difference", "seeds", "won",
        "p (Holm)", "needs", "",
    ]  # fmt: skip
    rows: list[list[str]] = []
    place = None
    for _, row in table.iterrows():
        score = SCORES[row["score"]]
        if place not in (None, (row["scenario"], row["score"])):
            rows.append([])
        place = (row["scenario"], row["score"])
        difference = Interval(row["difference"], row["low"], row["high"], row["seeds"])
        rows.append(
            [
                " ".join(filter(None, [scenario_name(row["scenario"]), row["point"]])),
                score.axis_label,
                row["method"],
                row["baseline"],
                number(row["mean_method"], score.decimals),
                number(row["mean_baseline"], score.decimals),
                interval(difference, score.difference_decimals, sign=True),
                str(row["seeds"]),
                f"{row['won']:.0%}",
                p_value(row["p_holm"]),
                "-" if pd.isna(row["seeds_needed"]) else str(row["seeds_needed"]),
                verdict(row),
            ]
        )
    return aligned(head, rows, left=4, last_left=True)


def _too_few_seeds(study: Study, rows: int) -> list[str]:
    """A line that warns if Holm's correction leaves no p below 5%, whatever the data."""
    smallest = rows * 2.0 ** (1 - study.seeds)
    if smallest <= SIGNIFICANCE:
        return []
    needed = math.ceil(1 + math.log2(rows / SIGNIFICANCE))
    return [
        f"With {study.seeds} seeds and {rows} rows no corrected p can fall below {SIGNIFICANCE}: "
        f"it takes {needed} seeds or fewer rows."
    ]


def main(argv: Sequence[str] | None = None) -> None:
    """Make the table of one study."""
    args_parser = parser(__doc__, study="table1")
    args_parser.add_argument(
        "--methods",
        type=name_list,
        metavar="NAMES",
        help="methods to hold against every other one (default: each pair of all methods)",
    )
    args_parser.add_argument(
        "--scores",
        type=name_list,
        default=list(DEFAULT_SCORES),
        metavar="NAMES",
        help=f"scores to compare (default: {', '.join(DEFAULT_SCORES)})",
    )
    args = args_parser.parse_args(argv)
    scores = find_scores(args.scores)
    study = load_study(args.results, args.study, args.methods or ())
    report_notes(study)
    table = paired_table(study, all_pairs(study, args.methods or study.methods), scores)
    text = table_text(study, table)
    write_text(study.folder / "tables" / "compare.txt", text)
    write_csv(study.folder / "tables" / "compare.csv", table)
    print(text)


if __name__ == "__main__":
    sys.exit(run(main))
