"""The table, tests and figures of the closed loop, from records and flights made by hand."""

import json

import matplotlib.image
import pandas as pd
import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.records import load_study
from analysis.figures import flown_world
from analysis.figures.avoidance_figures import main, world_label
from analysis.tables.avoidance_table import (
    MEDIUM, arms, medium_pairs, medium_success, pair_frame, success, success_frame)  # fmt: skip

SCORES = {"hit_static": 0, "hit_moving": 0, "hit_braking": 0, "timed_out": 0, "brakings": 1,
          "length_ratio": 1.05, "jerk_integral_mps2": 60, "least_clearance_m": 0.2, "barn": 0.5,
          "speed_violations": 0, "acceleration_violations": 0}  # fmt: skip
TIMES = {name: {"median": 1.25, "mean": 1.3, "p95": 2.75, "max": 4.0}
         for name in ("map_ms", "field_ms", "solve_ms", "plan_ms")}  # fmt: skip
ARRIVES = {"ldm": range(1, 11), "circular_buffer": (1, 2), "blind": (), "oracle": range(1, 11)}
"""Arm -> the seeds of `moving10_10` that it survives; `still8` all do."""


def flight(arm, world, seed):
    arrives = world == "still8" or seed in ARRIVES[arm]
    scores = SCORES | {"success": int(arrives), "hit_moving": int(not arrives),
                       "time_s": 12.5 if arrives else None,
                       "hit_known_from_m": None if arrives else 3.5}  # fmt: skip
    record = make_record(arm, seed, study="avoidance", scenario=world, frames=400)
    return record | {"scores": scores, "timing": {"serial": False} | TIMES}


@pytest.fixture
def results(tmp_path):
    return write_records(tmp_path, [flight(arm, world, seed) for arm in ARRIVES
                                    for world in ("still8", "moving10_10") for seed in range(1, 11)])  # fmt: skip


def test_shares_have_wilson_intervals(results):
    study = load_study(results, "avoidance")
    share = success(study, "moving10_10", "circular_buffer")
    assert (share.mean, share.n) == (0.2, 10)
    assert (share.low, share.high) == pytest.approx((0.0567, 0.5098), abs=1e-4)


def test_arms_stand_between_blind_and_oracle(results):
    assert arms(load_study(results, "avoidance")) == ["blind", "ldm", "circular_buffer", "oracle"]


def test_counts_and_means_leave_out_what_has_no_meaning(results):
    frame = success_frame(load_study(results, "avoidance")).set_index(["world", "arm"])
    row = frame.loc["moving10_10", "circular_buffer"]
    assert (row["hit_moving"], row["time_s"], row["hit_known_from_m"]) == (8, 12.5, 3.5)
    assert (row["plan_ms_median"], row["plan_ms_p95"]) == (1.25, 2.75)
    assert pd.isna(frame.loc["moving10_10", "blind"]["time_s"])


def test_pairs_are_tested_over_the_seeds_in_which_they_differ(results):
    tested = pair_frame(load_study(results, "avoidance")).set_index(["world", "a", "b"])
    assert len(tested) == 12
    pair = tested.loc["moving10_10", "ldm", "circular_buffer"]
    assert (pair["only_a"], pair["only_b"]) == (8, 0)
    assert pair["p"] == pytest.approx(2 / 2**8)
    # Smaller are blind against ldm and against oracle, 2 / 2^10 each: third of 12.
    assert pair["p_holm"] == pytest.approx(10 * 2 / 2**8)
    assert tested.loc["still8", "blind", "oracle"]["p"] == 1


def test_writes_table_tests_and_figure(results, capsys):
    assert run(main, ["--results", str(results)]) == 0
    out = capsys.readouterr().out
    assert "20 [6, 51]" in out and "1.2 / 2.8" in out
    folder = results / "avoidance"
    for name in ("avoidance.txt", "avoidance.csv", "avoidance.tex", "avoidance_tests.csv"):
        assert (folder / "tables" / name).stat().st_size > 100, name
    assert r"\texttt{circular\_buffer}" in (folder / "tables" / "avoidance.tex").read_text()
    assert matplotlib.image.imread(folder / "figures" / "avoidance.png").shape[1] == 2100


def test_worlds_of_medium_difficulty_are_counted_together(tmp_path, capsys):
    records = [flight(arm, "moving10_10", seed) | {"scenario": world, "id": f"{world}.{arm}.{seed}"}
               for arm in ARRIVES for world in MEDIUM for seed in range(1, 11)]  # fmt: skip
    study = load_study(write_records(tmp_path, records), "avoidance")
    share = medium_success(study, "circular_buffer")
    assert (share.mean, share.n) == (0.2, 20)
    pair = medium_pairs(study).set_index(["a", "b"]).loc["ldm", "circular_buffer"]
    assert (pair["only_a"], pair["only_b"], pair["seeds"]) == (16, 0, 20)
    assert pair["p"] == pytest.approx(2 / 2**16)
    # Smaller are blind against ldm and against oracle: third of 6.
    assert pair["p_holm"] == pytest.approx(4 * 2 / 2**16)
    assert run(main, ["--results", str(tmp_path)]) == 0
    assert "20 [8, 42]" in capsys.readouterr().out


def test_worlds_are_named_by_what_differs():
    assert world_label("still8", False) == "8, at rest"
    assert world_label("moving20_15", False) == "20 at\n1.5 m/s"
    assert (world_label("moving10_10", True), world_label("reversing_03", True)) == ("never", "0.3 /s")


def write_flight(folder, arm, outcome):
    folder.mkdir(parents=True)
    (folder / "flight.csv").write_text("time_s,x_m,y_m\n0,-10,0\n4,1,0.5\n")
    (folder / "obstacles.csv").write_text(
        "time_s,id,dynamic,x_m,y_m,size_x_m,size_y_m\n3.8,0,0,0.4,0.5,0.5,0.5\n3.8,1,1,1.4,0.6,0.4,0.4\n")
    (folder / "summary.json").write_text(json.dumps(
        {"outcome": outcome, "hit_obstacle": 1 if outcome.startswith("hit") else None, "method": arm,
         "scenario": "moving10_10", "seeds": {"scenario": "1"}}))  # fmt: skip


def test_one_world_flown_by_all_is_drawn(tmp_path, capsys):
    write_flight(tmp_path / "flights" / "oracle", "oracle", "reached")
    write_flight(tmp_path / "flights" / "blind", "blind", "hit_moving")
    assert run(flown_world.main, ["--results", str(tmp_path)]) == 0
    assert capsys.readouterr().out.splitlines()[0].endswith("flown.png")
    assert "moving10_10, seed 1" in (tmp_path / "flights" / "flown.txt").read_text()


def test_a_struck_obstacle_is_red(tmp_path):
    write_flight(tmp_path / "blind", "blind", "hit_moving")
    figure = flown_world.flown_figure([flown_world.read_flight(tmp_path / "blind")])
    red = [p.get_x() for p in figure.axes[0].patches
           if p.get_facecolor()[:3] == pytest.approx((0xD5 / 255, 0x5E / 255, 0))]  # fmt: skip
    assert red == pytest.approx([1.2])


def test_a_folder_without_flights_is_refused(tmp_path, capsys):
    assert run(flown_world.main, ["--results", str(tmp_path)]) == 2
    assert "holds no flight" in capsys.readouterr().err
    (tmp_path / "flights" / "ldm").mkdir(parents=True)
    (tmp_path / "flights" / "ldm" / "summary.json").write_text("{}")
    assert run(flown_world.main, ["--results", str(tmp_path)]) == 2
    assert "no flight of `ldm fly`" in capsys.readouterr().err
