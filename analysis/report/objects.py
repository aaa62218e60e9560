"""The section on objects: the table of goals, and the numbers that its text names."""

from __future__ import annotations

from analysis.report import latex
from analysis.report.evidence import Evidence
from analysis.tables.objects_table import METHOD, goals_frame, tabular, tests_frame, with_false_voxels

STUDY = "objects"
NAMED = (
    ("scenario1_fast", "dynamic_velocity_error_mps", 3),
    ("scenario3_fast", "dynamic_velocity_error_mps", 3),
    ("outdoor1", "dynamic_velocity_error_mps", 3),
    ("reversals", "recovery_s", 2),
)
"""Scenario, score and decimals of those that the text names, of each method in COLUMNS."""
COLUMNS = (METHOD, "ldm", "circular_buffer_pf", "centroid_kalman", "exact_positions")


def goals_table(evidence: Evidence, caption: str) -> str:
    """Each goal, and what each method attains."""
    study = evidence.study(STUDY)
    if study is None:
        return latex.table(latex.missing(STUDY), caption, "tab:objects")
    with_false_voxels(study)
    body = tabular(study, goals_frame(study), tests_frame(study)).strip()
    return latex.table(rf"\fitted{{{body}}}", caption, "tab:objects")


def objects_numbers(evidence: Evidence) -> dict[str, str]:
    """Key -> LaTeX text: goals met and in all, and the means that the text names."""
    keys = [f"{scenario}.{score}.{m}" for scenario, score, _ in NAMED for m in COLUMNS]
    study = evidence.study(STUDY)
    absent = latex.missing(STUDY) if study is None else "--"
    found = dict.fromkeys(("met", "goals", *keys), absent)
    if study is not None:
        with_false_voxels(study)
        frame = goals_frame(study)
        found |= {"met": str(frame["met"].sum()), "goals": str(len(frame))}
        for scenario, score, decimals in NAMED:
            for row in frame[(frame["scenario"] == scenario) & (frame["score"] == score)].to_dict("records"):
                for method in set(COLUMNS) & set(row):
                    found[f"{scenario}.{score}.{method}"] = latex.value(row[method], decimals)
    return {f"{STUDY}.{key}": text for key, text in found.items()}
