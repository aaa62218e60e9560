"""The paper's claims on its flight outdoors (Sec. 4.2.2) beside ours; `outdoor_figures` writes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import pandas as pd

from analysis.data import series_scores
from analysis.data.output import write_csv, write_text
from analysis.data.published import published
from analysis.data.records import Study
from analysis.data.statistics import Interval, mean_interval
from analysis.tables.text_table import aligned, interval

SCENARIO, FOLLOWING = "outdoor1", "outdoor2"
"""The UAV hovers among three people; the UAV and one person move the same way."""

Values = Callable[[Study, str, str], pd.Series]
"""Study, scenario, method -> a value for each replicate."""


def _of_series(score: series_scores.TrialScore) -> Values:
    return lambda study, scenario, method: series_scores.score_trials(
        study, scenario, method, score
    )


def _of_record(score: str) -> Values:
    return lambda study, scenario, method: study.per_seed(scenario, method, score)


@dataclass(frozen=True)
class Measure:
    """A number of ours that a claim is held against."""

    name: str
    label: str  # with unit
    paper: str
    scenario: str
    values: Values
    decimals: int


def measures() -> dict[str, Measure]:
    """All, by name, in the order of the paper's text."""
    bound = published()["outdoor"]["static"]["largest_error_mps"]
    right = f"direction right within {series_scores.RIGHT_WITHIN_DEG} deg (% of frames)"
    found = (
        Measure("static_largest", "standing person: largest error in any direction (m/s)",
                f"up to {bound}", SCENARIO, _of_series(series_scores.largest_static_error), 3),
        Measure("static_share", f"standing person: within {bound} m/s (% of frames)",
                "all", SCENARIO, _of_series(series_scores.static_share), 1),
        Measure("hidden_frames", "hidden person: how long (frames)",
                "", SCENARIO, _of_series(series_scores.hidden_frames), 1),
        Measure("hidden_matched", "hidden person: has a cluster (% of frames)",
                "cluster kept", SCENARIO, _of_record("hidden_with_cluster_pct"), 1),
        Measure("kept", "hidden person: same track before and after (% of occlusions)",
                "cluster kept", SCENARIO, _of_record("occlusions_kept_pct"), 1),
        Measure("tracks", "tracks of a person over the whole trial (1: never lost)",
                "", SCENARIO, _of_record("tracks_per_stay"), 2),
        Measure("direction", f"walking people: {right}",
                "right", SCENARIO, _of_series(series_scores.direction_share), 1),
        Measure("direction_following", f"person and UAV: {right}",
                "right", FOLLOWING, _of_series(series_scores.direction_share), 1),
    )  # fmt: skip
    return {measure.name: measure for measure in found}


def means(study: Study, measure: Measure) -> dict[str, Interval]:
    """Method -> mean over seeds; of 0 seeds where the method has no such value."""
    return {
        method: mean_interval(measure.values(study, measure.scenario, method).to_numpy())
        for method in study.methods
    }


def write_table(study: Study) -> str:
    """Write outdoor.txt and outdoor.csv of a study; returns the text."""
    rows, table = [], []
    for measure in measures().values():
        found = means(study, measure)
        rows.append([measure.label, measure.paper,
                     *(interval(found[method], measure.decimals) for method in study.methods)])
        table += [(measure.scenario, measure.name, method, i.mean, i.low, i.high, i.n)
                  for method, i in found.items()]  # fmt: skip
    text = "\n".join([
        "The flight outdoors (Sec. 4.2.2), the paper's claims beside ours: mean [95% bootstrap",
        f"interval] over seeds; {study.source()}.\n",
        aligned(["", "paper", *study.methods], rows, left=2),
    ])  # fmt: skip
    columns = ["scenario", "measure", "method", "mean", "low", "high", "seeds"]
    write_text(study.folder / "tables" / "outdoor.txt", text)
    write_csv(study.folder / "tables" / "outdoor.csv", pd.DataFrame(table, columns=columns))
    return text
