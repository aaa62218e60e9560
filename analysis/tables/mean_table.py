"""Mean and 95% interval over seeds of every score, method, scenario and point of a study."""

from __future__ import annotations

from typing import Iterable

import pandas as pd

from analysis.data.records import Study
from analysis.data.scores import Score
from analysis.data.statistics import Interval, mean_interval

def mean_table(study: Study, scores: Iterable[Score]) -> pd.DataFrame:
    """One row for each scenario, point, method and score that some seed has a value of."""
    scores = [score for score in scores if score.name in study.trials]
    rows = []
    for group, trials in study.trials.groupby(["scenario", "method", "point"], sort=False):
        for score in scores:
            found = mean_interval(trials[score.name].to_numpy())
            if found.n:
                rows.append((*group, score.name, found.mean, found.low, found.high, found.n))
    columns = ["scenario", "method", "point", "score", "mean", "low", "high", "seeds"]
    return pd.DataFrame(rows, columns=columns)


class Means:
    """Look-up of a mean table of a study without a sweep."""

    def __init__(self, table: pd.DataFrame) -> None:
        """Index `table`, which is what `mean_table` gives, by scenario, method and score."""
        self._intervals = {
            (row.scenario, row.method, row.score): Interval(row.mean, row.low, row.high, row.seeds)
            for row in table.itertuples()
        }

    def find(self, scenario: str, method: str, score: str) -> Interval:
        """The interval, or one of 0 seeds if the study has none."""
        nothing = Interval(float("nan"), float("nan"), float("nan"), 0)
        return self._intervals.get((scenario, method, score), nothing)
