"""Goals beside what is attained, worked by hand."""

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.records import load_study
from analysis.tables import objects_table
from analysis.tables.objects_table import Goal, goals_frame, main, with_false_voxels

ERRORS = {"object_ldm": 0.05, "ldm": 0.4, "current_scan": 0.3, "exact_positions": 0.01}
FALSE = {"object_ldm": 60, "ldm": 90, "current_scan": 80, "exact_positions": 30}  # case 1 and case 2 of a trial


@pytest.fixture
def results(tmp_path):
    """Twelve seeds, so that Holm's correction leaves something; all methods worsen from seed to seed."""
    records = []
    for method in ERRORS:
        for seed in range(1, 13):
            record = make_record(method, seed, study="objects", scenario="scenario1_fast", frames=10)
            records.append(record | {"scores": {
                "dynamic_velocity_error_mps": ERRORS[method] * (1 + 0.01 * seed),
                "case1_voxels": FALSE[method] / 3 + seed, "case2_voxels": FALSE[method] * 2 / 3,
                "velocity_in_ellipse_pct": None if method == "current_scan" else 95,
            }})  # fmt: skip
    return write_records(tmp_path, records)


def test_a_goal_is_a_bound_a_range_or_all_others():
    assert Goal("", "", most=0.055).text == "<= 0.055"
    assert Goal("", "", least=95).text == ">= 95"
    ellipse = Goal("", "", least=93, most=97)
    assert (ellipse.text, ellipse.met(93, []), ellipse.met(97.1, [])) == ("93 to 97", True, False)
    below = Goal("", "", below_all=True)
    assert (below.text, below.met(5, [6, float("nan")]), below.met(5, [6, 5])) == ("below all", True, False)
    assert not ellipse.met(float("nan"), [])


def test_means_and_goals_by_hand(results):
    frame = goals_frame(with_false_voxels(load_study(results, "objects"))).set_index("score")
    error = frame.loc["dynamic_velocity_error_mps"]
    assert error["object_ldm"] == pytest.approx(0.05325)  # the mean of the seeds is 6.5
    assert error["met"]
    assert error["ldm"] == pytest.approx(0.426)
    # (60 + 6.5) / 10 frames; the oracle is no baseline.
    assert frame.loc["case_voxels_per_frame", "object_ldm"] == pytest.approx(6.65)
    assert frame.loc["case_voxels_per_frame", "met"]
    assert frame.loc["velocity_in_ellipse_pct", "met"]
    assert "recovery_s" not in frame.index  # none in this scenario


def test_each_pair_has_its_test(results):
    tests = objects_table.tests_frame(with_false_voxels(load_study(results, "objects")))
    pair = tests[(tests["score"] == "dynamic_velocity_error_mps") & (tests["baseline"] == "ldm")]
    assert pair["method"].tolist() == ["object_ldm"]
    assert pair["difference"].iloc[0] == pytest.approx(-0.37275)
    assert pair["p_holm"].iloc[0] < 0.05


def test_marks_say_who_is_better(results, capsys):
    assert run(main, ["--results", str(results)]) == 0
    line = next(line for line in capsys.readouterr().out.splitlines() if "dynamic velocity" in line)
    assert line.split()[-5:] == ["0.054]", "yes", "0.426+", "0.320+", "0.011-"]
    folder = results / "objects" / "tables"
    assert "below all" in (folder / "objects.tex").read_text()
    assert (folder / "objects_tests.csv").exists() and (folder / "objects.csv").exists()
