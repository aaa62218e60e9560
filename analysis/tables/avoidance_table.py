"""Who reaches the goal: success, its tests, and the other scores of the closed loop, per arm and world."""

from __future__ import annotations

from itertools import combinations
from typing import Mapping, Sequence

import numpy as np
import pandas as pd

from analysis.data.output import write_csv, write_text
from analysis.data.proportions import mcnemar_p, wilson
from analysis.data.records import Study
from analysis.data.statistics import SIGNIFICANCE, Interval, holm
from analysis.tables.text_table import NOTHING, aligned, latex_tabular, latex_text, number, p_value

CONTROLS = ("blind", "oracle", "oracle_future")
MEDIUM = ("moving10_05", "moving10_10")
"""Worlds of medium difficulty, which are also counted together."""

COUNTS = ("hit_static", "hit_moving", "hit_braking", "timed_out")
"""Ends of a flight that is no success: sums over seeds."""

MEANS = {
    "time_s": ("time (s)", 1),
    "length_ratio": ("length", 3),
    "jerk_integral_mps2": ("jerk (m/s2)", 0),
    "least_clearance_m": ("clearance (m)", 2),
    "brakings": ("brakings", 2),
    "hit_known_from_m": ("known from (m)", 2),
    "barn": ("BARN", 3),
}
"""Score -> head of its column and decimals: means over the seeds that have one."""

VIOLATIONS = ("speed_violations", "acceleration_violations")
TIMES = {"plan_ms": "plan (ms)", "map_ms": "map (ms)"}
"""Processor times: median of the flights' medians, and of their 95th percentiles."""


def arms(study: Study) -> list[str]:
    """Blind first, the oracles last, the maps between them in the study's order."""
    maps = [method for method in study.methods if method not in CONTROLS]
    found = set(study.methods)
    return [a for a in ("blind", *maps, "oracle", "oracle_future") if a in found]


def success(study: Study, world: str, arm: str, point: str = "") -> Interval:
    """Share of flights that reach the goal, with Wilson's interval."""
    values = study.per_seed(world, arm, "success", point)
    return wilson(int(values.sum()), len(values))


def flown(study: Study, worlds: Sequence[str], arm: str, point: str = "") -> pd.Series:
    """(world, seed) -> 1 if the flight reaches the goal, else 0."""
    return pd.concat({world: study.per_seed(world, arm, "success", point) for world in worlds})


def medium_success(study: Study, arm: str) -> Interval:
    """`success` over the worlds of medium difficulty together."""
    values = flown(study, MEDIUM, arm)
    return wilson(int(values.sum()), len(values))


def success_frame(study: Study) -> pd.DataFrame:
    """A row for each world, point and arm: share, interval, seeds, counts, means and times."""
    rows = []
    for (world, point, arm), flights in study.trials.groupby(["scenario", "point", "method"]):
        share = success(study, world, arm, point)
        row = {"world": world, "point": point, "arm": arm, "seeds": share.n,
               "success": share.mean, "low": share.low, "high": share.high}  # fmt: skip
        row |= {name: int(flights[name].sum()) for name in (*COUNTS, *VIOLATIONS)}
        row |= {name: flights[name].mean() for name in MEANS}
        rows.append(row | _times(study, flights))
    order = {arm: i for i, arm in enumerate(arms(study))}
    frame = pd.DataFrame(rows)
    return frame.sort_values(["world", "point", "arm"], ignore_index=True,
                             key=lambda c: c.map(order) if c.name == "arm" else c)  # fmt: skip


def _times(study: Study, flights: pd.DataFrame) -> dict[str, float]:
    files = set(flights["file"])
    timings = [record["timing"] for record in study.records if record["file"] in files]
    return {f"{name}_{part}": float(np.median([timing[name][part] for timing in timings]))
            for name in TIMES for part in ("median", "p95")}  # fmt: skip


def pair_frame(study: Study) -> pd.DataFrame:
    """A row for each pair of arms in each world: seeds won by one alone, exact p, and Holm's.

    Holm's correction is over all pairs of all worlds and points.
    """
    return _pairs(study, {world: (world,) for world in study.scenarios})


def medium_pairs(study: Study) -> pd.DataFrame:
    """The same over the worlds of medium difficulty together, with Holm's correction of its own."""
    return _pairs(study, {"medium": MEDIUM})


def _pairs(study: Study, groups: Mapping[str, Sequence[str]]) -> pd.DataFrame:
    rows = []
    for world, worlds in groups.items():
        for point in study.points:
            by_arm = {arm: flown(study, worlds, arm, point) for arm in arms(study)}
            for a, b in combinations(by_arm, 2):
                of_a, of_b = by_arm[a].align(by_arm[b], join="inner")
                if of_a.empty:
                    continue
                rows.append((world, point, a, b, len(of_a), int(((of_a == 1) & (of_b == 0)).sum()),
                             int(((of_a == 0) & (of_b == 1)).sum()), mcnemar_p(of_a, of_b)))  # fmt: skip
    columns = ["world", "point", "a", "b", "seeds", "only_a", "only_b", "p"]
    frame = pd.DataFrame(rows, columns=columns)
    frame["p_holm"] = holm(frame["p"].to_numpy())
    return frame


def _percent(share: Interval) -> str:
    if share.n == 0:
        return NOTHING
    return f"{100 * share.mean:.0f} [{100 * share.low:.0f}, {100 * share.high:.0f}]"


def _success_rows(study: Study, frame: pd.DataFrame) -> list[list[str]]:
    """World and point in front, then a cell for each arm."""
    places = frame[["world", "point"]].drop_duplicates().itertuples(index=False)
    return [[world, point, *(_percent(success(study, world, arm, point)) for arm in arms(study))]
            for world, point in places]  # fmt: skip


def _detail_rows(frame: pd.DataFrame) -> list[list[str]]:
    rows = []
    for row in frame.to_dict("records"):
        cells = [row["world"], row["point"], row["arm"]]
        cells += [str(row[name]) for name in COUNTS]
        cells += [number(row[name], decimals) for name, (_, decimals) in MEANS.items()]
        cells.append(str(sum(row[name] for name in VIOLATIONS)))
        cells += [f"{row[f'{name}_median']:.1f} / {row[f'{name}_p95']:.1f}" for name in TIMES]
        rows.append(cells)
    return rows


def _without_empty(head: list[str], rows: list[list[str]], column: int) -> tuple:
    """Without a column that is empty everywhere, as that of the points is without a sweep."""
    if any(row[column] for row in rows):
        return head, rows
    return [h for i, h in enumerate(head) if i != column], [
        [c for i, c in enumerate(row) if i != column] for row in rows]  # fmt: skip


PAIR_HEAD = ["world", "point", "a", "b", "alone", "p", "p, Holm"]


def _told(tested: pd.DataFrame) -> list[list[str]]:
    """Rows of the pairs that differ."""
    return [[t.world, t.point, t.a, t.b, f"{t.only_a} : {t.only_b}", p_value(t.p), p_value(t.p_holm)]
            for t in tested.itertuples() if t.p_holm < SIGNIFICANCE]  # fmt: skip


def _medium_text(study: Study) -> list[str]:
    """The worlds of medium difficulty together, if the study has them."""
    if len(study.points) > 1 or not set(MEDIUM) <= set(study.scenarios):
        return []
    tested = medium_pairs(study)
    return [
        f"The worlds of medium difficulty together ({', '.join(MEDIUM)}), and the pairs of arms that",
        f"differ there (the same test, Holm over {len(tested)} pairs).\n",
        aligned(arms(study), [[_percent(medium_success(study, arm)) for arm in arms(study)]], left=0),
        aligned(*_without_empty(PAIR_HEAD, _told(tested), 1), left=3),
    ]


def tabular(study: Study) -> str:
    """Success per world and arm as LaTeX."""
    head, rows = _without_empty(
        ["world", "point", *arms(study)], _success_rows(study, success_frame(study)), 1)  # fmt: skip
    columns = "l" * (len(head) - len(arms(study))) + "c" * len(arms(study))
    tex_head = " & ".join(rf"\texttt{{{latex_text(cell)}}}" for cell in head) + r" \\"
    return latex_tabular(columns, [tex_head], [[latex_text(cell) for cell in row] for row in rows])


def write_table(study: Study) -> str:
    """Write avoidance.{txt,csv,tex} and avoidance_tests.csv of a study; returns the text."""
    frame, tested = success_frame(study), pair_frame(study)
    folder = study.folder / "tables"
    write_csv(folder / "avoidance.csv", frame)
    write_csv(folder / "avoidance_tests.csv", tested)

    shares = _without_empty(["world", "point", *arms(study)], _success_rows(study, frame), 1)
    details = _without_empty(
        ["world", "point", "arm", *(name.replace("_", " ") for name in COUNTS),
         *(head for head, _ in MEANS.values()), "violations", *TIMES.values()],
        _detail_rows(frame), 1)  # fmt: skip
    text = "\n".join([
        f"Flights that reach the goal (%) [95% Wilson interval]; {study.source()}.\n",
        aligned(*shares),
        "How the others ended (flights), and means: time, length over straight and jerk of those that",
        "arrive; clearance of all; distance at which what was hit was first known; BARN's metric.",
        "Violations: samples above a limit. Times of a plan and of a map's update: processor time,",
        "median / 95th percentile.\n",
        aligned(*details, left=2),
        f"Pairs of arms that differ (exact McNemar test, Holm over {len(tested)} pairs, p < 0.05): seeds",
        "that the one alone survives : the other alone.\n",
        aligned(*_without_empty(PAIR_HEAD, _told(tested), 1), left=3),
        *_medium_text(study),
    ])  # fmt: skip
    write_text(folder / "avoidance.txt", text)
    write_text(folder / "avoidance.tex", tabular(study))
    return text
