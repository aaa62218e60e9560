"""What a planner can trust: each goal of object_ldm beside what it and every other method attains.

A goal holds if the mean over seeds meets it. Beside it stand the other methods' means, and what the paired test
says of each pair: the signed-rank test over seeds with Holm's correction over all rows of the table.

Reads   DIR/NAME/records/*.json
Writes  DIR/NAME/tables/: objects.txt, objects.csv, objects.tex, objects_tests.csv
Prints  the table

Example: /usr/bin/python3 -m analysis.tables.objects_table --results results --study objects
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from typing import Sequence

import pandas as pd

from analysis.data.command_line import parser, run, study_of
from analysis.data.output import write_csv, write_text
from analysis.data.records import Study
from analysis.data.scores import SCORES, Score
from analysis.data.statistics import SIGNIFICANCE, Interval
from analysis.tables.beside import separate
from analysis.tables.mean_table import Means, mean_table
from analysis.tables.paired_table import all_pairs, paired_table
from analysis.tables.text_table import aligned, interval, latex_tabular, latex_text, number

METHOD = "object_ldm"
BEST = "exact_positions"
"""The oracle: no baseline to be below."""


@dataclass(frozen=True)
class Goal:
    """A score of a scenario, and what it should be."""

    scenario: str
    score: str
    least: float = -math.inf
    most: float = math.inf
    below_all: bool = False
    """Or below every baseline, whatever the value."""

    @property
    def text(self) -> str:
        """`<= 0.06`, `93 to 97` or `below all`."""
        if self.below_all:
            return "below all"
        if math.isinf(self.least):
            return f"<= {self.most:g}"
        return f">= {self.least:g}" if math.isinf(self.most) else f"{self.least:g} to {self.most:g}"

    def met(self, value: float, others: Sequence[float]) -> bool:
        """Whether the value meets it; NaN does not."""
        if self.below_all:
            return all(value < other for other in others if not math.isnan(other))
        return self.least <= value <= self.most


FAST = ("scenario1_fast", "scenario3_fast")
ALL = ("scenario1_fast", "scenario2", "scenario3_fast", "reversals", "outdoor1")
GOALS = (
    *(Goal(s, "dynamic_velocity_error_mps", most=0.055) for s in FAST),
    Goal("outdoor1", "dynamic_velocity_error_mps", most=0.115),
    Goal("reversals", "recovery_s", most=0.18),
    Goal("reversals", "recovery_p90_s", most=0.26),
    *(Goal(s, "static_velocity_error_mps", most=0.016) for s in ("scenario2", "scenario3_fast")),
    *(Goal(s, "static_velocity_error_p95_mps", most=0.05) for s in ("scenario2", "scenario3_fast")),
    *(Goal(s, "case_voxels_per_frame", below_all=True) for s in ALL),
    *(Goal(s, "mixed_voxels_per_frame", below_all=True) for s in ALL),
    *(Goal(s, "mover_voxels_found_pct", least=95) for s in (*FAST, "outdoor1")),
    *(Goal(s, "precision_near", least=0.98) for s in (*FAST, "outdoor1")),
    *(Goal(s, "ghost_voxels_per_frame", most=0.1) for s in (*FAST, "outdoor1")),
    *(Goal(s, "track_switches_per_minute", most=0.1) for s in ALL),
    *(Goal(s, "velocity_in_ellipse_pct", least=93, most=97) for s in (*FAST, "reversals", "outdoor1")),
)

FALSE_VOXELS = Score("case_voxels_per_frame", "false voxels, solid truth", "per frame", "lower", 1, 1.75)
"""Case 1 and case 2 together: no score of the records."""


def with_false_voxels(study: Study) -> Study:
    """The study, with FALSE_VOXELS as one more column."""
    trials = study.trials
    trials[FALSE_VOXELS.name] = (trials["case1_voxels"] + trials["case2_voxels"]) / study.frames
    return study


def score_of(name: str) -> Score:
    """How the score of a goal is shown."""
    return FALSE_VOXELS if name == FALSE_VOXELS.name else SCORES[name]


def scores_of_goals() -> list[Score]:
    """Each once, in the order of the goals."""
    return [score_of(name) for name in dict.fromkeys(goal.score for goal in GOALS)]


def baselines(study: Study) -> list[str]:
    """All methods but ours, the oracle last."""
    others = [m for m in study.methods if m not in (METHOD, BEST)]
    return others + [m for m in study.methods if m == BEST]


def goals_frame(study: Study) -> pd.DataFrame:
    """A row for each goal: what it is, whether it is met, and each method's mean."""
    means = Means(mean_table(study, scores_of_goals()))
    rows = []
    for goal in GOALS:
        found = {m: means.find(goal.scenario, m, goal.score) for m in (METHOD, *baselines(study))}
        ours = found[METHOD]
        if not ours.n:
            continue
        others = [value.mean for m, value in found.items() if m not in (METHOD, BEST)]
        rows.append({"scenario": goal.scenario, "score": goal.score, "goal": goal.text,
                     "met": goal.met(ours.mean, others), "low": ours.low, "high": ours.high,
                     "seeds": ours.n} | {m: value.mean for m, value in found.items()})  # fmt: skip
    return pd.DataFrame(rows)


def tests_frame(study: Study) -> pd.DataFrame:
    """object_ldm against every other method, for each score and scenario that has a goal."""
    table = paired_table(study, all_pairs(study, [METHOD]), scores_of_goals())
    wanted = {(goal.scenario, goal.score) for goal in GOALS}
    chosen = [(row.scenario, row.score) in wanted for row in table.itertuples()]
    return table[chosen].reset_index(drop=True)


def _mark(tests: pd.DataFrame, scenario: str, score: str, other: str, mean: float, decimals: int) -> str:
    """The other's mean: `+` where ours is better beyond chance, `-` where it is worse."""
    text = number(mean, decimals)
    row = tests[(tests["scenario"] == scenario) & (tests["score"] == score) & (tests["baseline"] == other)]
    if row.empty or not row["p_holm"].iloc[0] < SIGNIFICANCE:
        return text
    better = (row["difference"].iloc[0] < 0) == (score_of(score).better == "lower")
    return text + ("+" if better else "-")


def cells(study: Study, frame: pd.DataFrame, tests: pd.DataFrame) -> list[list[str]]:
    """Rows of the table as text."""
    rows = []
    for row in frame.to_dict("records"):
        score = score_of(row["score"])
        ours = Interval(row[METHOD], row["low"], row["high"], row["seeds"])
        rows.append([row["scenario"], score.axis_label, row["goal"], interval(ours, score.decimals),
                     "yes" if row["met"] else "no",
                     *(_mark(tests, row["scenario"], row["score"], m, row[m], score.decimals)
                       for m in baselines(study))])  # fmt: skip
    return sorted(rows, key=lambda cell: ALL.index(cell[0]))


def tabular(study: Study, frame: pd.DataFrame, tests: pd.DataFrame) -> str:
    """The table as LaTeX."""
    head = ["scenario", "score", "goal", METHOD, "met", *baselines(study)]
    tex_head = " & ".join(rf"\texttt{{{latex_text(cell)}}}" for cell in head) + r" \\"
    rows = [[latex_text(cell).replace("<=", r"$\le$").replace(">=", r"$\ge$") for cell in row]
            for row in separate(cells(study, frame, tests))]  # fmt: skip
    return latex_tabular("lll" + "c" * (len(head) - 3), [tex_head], rows)


def write_table(study: Study) -> str:
    """Write objects.{txt,csv,tex} and objects_tests.csv of a study; returns the text."""
    with_false_voxels(study)
    frame, tests = goals_frame(study), tests_frame(study)
    folder = study.folder / "tables"
    write_csv(folder / "objects.csv", frame)
    write_csv(folder / "objects_tests.csv", tests)
    write_text(folder / "objects.tex", tabular(study, frame, tests))
    text = "\n".join([
        f"Goals of {METHOD} and what is attained, mean [95% bootstrap interval]; {study.source()}.",
        f"+ {METHOD} is better beyond chance, - worse (signed-rank test, Holm over {len(tests)} rows,",
        f"p < {SIGNIFICANCE}). {BEST} is the oracle, centroid_kalman the yardstick.\n",
        aligned(["scenario", "score", "goal", METHOD, "met", *baselines(study)],
                separate(cells(study, frame, tests)), left=3),
    ])  # fmt: skip
    write_text(folder / "objects.txt", text)
    return text


def main(argv: Sequence[str] | None = None) -> None:
    """Make the table of one study."""
    args = parser(__doc__, "objects").parse_args(argv)
    study = study_of(args)
    print(write_table(study))


if __name__ == "__main__":
    sys.exit(run(main))
