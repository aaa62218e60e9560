"""Paired comparison of methods over the same seeds.

Prints one screen: is the method better? The file has, for each scenario, point of a sweep, score and
pair of methods, the mean difference with its 95% bootstrap interval, the share of seeds won (ties
count half), Wilcoxon's signed-rank test with Holm's correction over the whole table, and the number
of seeds that the smallest interesting difference would need (power 80% at the 5% level;
analysis/data/scores.py holds the differences). Below five seeds there are differences alone.

Reads   DIR/NAME/records/*.json; a method that NAME lacks: DIR/NAME+METHOD/records/*.json
Writes  DIR/NAME/tables/compare.{txt,csv}
Prints  the answer, and where the tables are

Example: /usr/bin/python3 -m analysis.tables.compare --results results --study table1 --methods ldm,mine
"""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Sequence

import pandas as pd

from analysis.data.command_line import add_scores, name_list, parser, run, study_of
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study
from analysis.data.scores import SCORES, Score, find_scores
from analysis.data.statistics import LEAST_SEEDS, SIGNIFICANCE, Interval
from analysis.tables.beside import scenario_name
from analysis.tables.paired_table import all_pairs, paired_table
from analysis.tables.text_table import aligned, interval, number, p_value

DEFAULT_SCORES = (
    "accuracy_pct",
    "case1_voxels",
    "case2_voxels",
    "mixed_voxels_per_frame",
    "f1",
    "iou_visible",
    "static_velocity_error_mps",
    "dynamic_velocity_error_mps",
)


UNDECIDED, TOO_FEW = "-", ""
"""Verdicts beside `better` and `worse`."""

MOST_PAIRS, MOST_SCENARIOS = 8, 4
"""What a screen holds."""


def comparison(study: Study, methods: list[str], scores: list[Score]) -> pd.DataFrame:
    """The paired table with its verdicts; below LEAST_SEEDS seeds without interval, p and verdict."""
    table = paired_table(study, all_pairs(study, methods), scores)
    table.loc[table["seeds"] < LEAST_SEEDS, ["low", "high", "p", "p_holm"]] = math.nan
    table["verdict"] = [verdict(row) for _, row in table.iterrows()]
    return table


def answer_text(study: Study, table: pd.DataFrame, file: Path) -> str:
    """One screen: the first pair score by score, a line for each pair, where the rest is."""
    pairs = list(dict.fromkeys(zip(table["method"], table["baseline"])))
    parts = [f"Paired differences over the same seeds; {study.source()}.", *_few_seeds(study), ""]
    for method, baseline in pairs[:1]:
        found = table[(table["method"] == method) & (table["baseline"] == baseline)]
        if len(study.scenarios) <= MOST_SCENARIOS and len(study.points) == 1:
            parts += [f"{method} - {baseline}:", _score_by_score(study, found)]
    parts += [_pair_line(table, *pair) for pair in pairs[:MOST_PAIRS]]
    if len(pairs) > MOST_PAIRS:
        parts.append(f"... and {len(pairs) - MOST_PAIRS} more pairs")
    return "\n".join([*parts, f"Intervals, tests and seeds needed: {file}"])


def _score_by_score(study: Study, table: pd.DataFrame) -> str:
    """A line for each score, a column for each scenario: difference and verdict."""
    cells = {
        (row["score"], row["scenario"]): " ".join(filter(None, [
            number(row["difference"], SCORES[row["score"]].difference_decimals, sign=True),
            row["verdict"] and row["verdict"].rjust(6),
        ]))
        for _, row in table.iterrows()
    }  # fmt: skip
    rows = [
        [SCORES[score].axis_label, *(cells.get((score, s), UNDECIDED) for s in study.scenarios)]
        for score in dict.fromkeys(table["score"])
    ]
    return aligned(["", *map(scenario_name, study.scenarios)], rows)


def _pair_line(table: pd.DataFrame, method: str, baseline: str) -> str:
    """How often which of two methods is better."""
    found = table[(table["method"] == method) & (table["baseline"] == baseline)]["verdict"]
    if (found == TOO_FEW).all():
        return f"{method} against {baseline}: no verdict"
    counts = (found == "better").sum(), (found == "worse").sum()
    return (
        f"{method} against {baseline}: better in {counts[0]}, worse in {counts[1]} "
        f"of {len(found)} comparisons of a score"
    )


def table_text(study: Study, table: pd.DataFrame) -> str:
    """The whole of compare.txt."""
    parts = [
        "Paired comparison over the same seeds: method - baseline, mean [95% bootstrap interval];",
        f"p of the signed-rank test, corrected (Holm) over {len(table)} rows; {study.source()}.",
        "better, worse: the interval, which is not corrected, excludes 0; needs: seeds for the",
        "smallest interesting difference (analysis/data/scores.py) at a power of 80%.",
        *_few_seeds(study),
        *_too_few_seeds(study, len(table)),
        "",
        _rows(table),
        *(f"Note: {note}" for note in study.notes),
    ]
    return "\n".join(parts)


def verdict(row: pd.Series) -> str:
    """`better` or `worse` for the method if the interval of the difference excludes 0, else `-`; empty
    below LEAST_SEEDS seeds."""
    if row["seeds"] < LEAST_SEEDS:
        return TOO_FEW
    if not Interval(row["difference"], row["low"], row["high"], row["seeds"]).excludes_zero:
        return UNDECIDED
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
                row["verdict"],
            ]
        )
    return aligned(head, rows, left=4, last_left=True)


def _few_seeds(study: Study) -> list[str]:
    """A line that says why there is no verdict."""
    if study.seeds >= LEAST_SEEDS:
        return []
    return [f"With fewer than {LEAST_SEEDS} seeds there are differences and no verdicts: SEEDS={LEAST_SEEDS}."]


def _too_few_seeds(study: Study, rows: int) -> list[str]:
    """A line that warns if Holm's correction leaves no p below 5%, whatever the data."""
    smallest = rows * 2.0 ** (1 - study.seeds)
    if smallest <= SIGNIFICANCE or study.seeds < LEAST_SEEDS:
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
    add_scores(args_parser, DEFAULT_SCORES, "to compare")
    args = args_parser.parse_args(argv)
    scores = find_scores(args.scores)
    study = study_of(args, args.methods or ())
    table = comparison(study, args.methods or study.methods, scores)
    file = study.folder / "tables" / "compare.txt"
    write_text(file, table_text(study, table))
    write_csv(file.with_suffix(".csv"), table)
    print(answer_text(study, table, file))


if __name__ == "__main__":
    sys.exit(run(main))
