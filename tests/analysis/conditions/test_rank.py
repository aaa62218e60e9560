"""From the records of conditions to their ranking."""

import pandas as pd
import pytest
from analysis.conditions import rank
from analysis.conditions.claims import claims, pf_readings
from analysis.conditions.measures import measures
from analysis.data.errors import InputError
from record_files import make_record, make_series, write_record

FRAMES = list(range(120))


def write(folder, **changes):
    return write_record(folder, make_record(**changes))


def write_condition(folder, dynamic_error):
    """All records that the claims ask for, in one world."""
    for scenario in sorted({claim.scenario for claim in claims()}):
        for method in ("ldm", "circular_buffer", *pf_readings()):
            noise = 0.01 if method == "ldm" else 0.05
            write(folder / "records", scenario=scenario, method=method, frames=120,
                  scores={"dynamic_velocity_error_mps": dynamic_error if method == "ldm" else 0.15,
                          "hidden_with_cluster_pct": 100, "occlusions_kept_pct": 100},
                  series=[make_series(1, True, FRAMES, noise), make_series(2, False, FRAMES, noise)])


@pytest.fixture
def results(tmp_path):
    stage = tmp_path / "conditions" / "stage1"
    write_condition(stage / "far", 0.9)
    write_condition(stage / "near", 0.12)
    (stage / "conditions.csv").write_text("condition,speed_mps\nfar,1.2\nnear,0.3\nempty,1\n")
    return tmp_path


def test_measures_are_those_of_the_claims(results):
    found, notes = measures(results / "conditions" / "stage1" / "near" / "records")
    assert notes == []
    values = found.set_index(["scenario", "method", "measure"])["value"]
    assert values["scenario1", "ldm", "dynamic_velocity_error_mps"] == 0.12
    assert values["scenario1", "ldm", "fluctuation_mps"] == pytest.approx(0.01 * 3**0.5, rel=0.2)
    assert values["scenario2", "ldm", f"static_better_pct.{pf_readings()[0]}"] > 90
    assert values["outdoor1", "ldm", "response_s"] == 0
    assert "case1_voxels" not in values["outdoor1", "ldm"].index


def test_a_failed_and_a_broken_record_are_named_and_left_out(tmp_path):
    failed = write(tmp_path, status="failed", error="no room")
    (tmp_path / "broken.json").write_text("{")
    good = write(tmp_path, method="circular_buffer")
    found, notes = measures(tmp_path)
    assert set(found["method"]) == {"circular_buffer"} and good.exists()
    assert len(notes) == 2 and any(f"{failed}: failed: no room" == note for note in notes)


def test_the_ranking_begins_with_the_nearest_and_leaves_conditions_without_records_out(results, capsys):
    rank.main(["stage1", "--results", str(results)])
    folder = results / "conditions" / "stage1"
    ranking = pd.read_csv(folder / "ranking.csv")
    assert list(ranking["condition"]) == ["near", "far"]
    assert ranking["distance"].is_monotonic_increasing
    assert "near" in capsys.readouterr().out
    outcomes = pd.read_csv(folder / "outcomes.csv")
    assert len(outcomes) == 2 * len(claims())
    assert set(outcomes["verdict"]) <= {"undecided", "missing"}  # one world decides nothing


def test_a_condition_without_all_numbers_has_no_distance(results):
    for file in (results / "conditions" / "stage1" / "near" / "records").glob("outdoor2*"):
        file.unlink()
    rank.main(["stage1", "--results", str(results)])
    ranking = pd.read_csv(results / "conditions" / "stage1" / "ranking.csv")
    assert list(ranking["condition"]) == ["far"]


def test_what_was_kept_gives_the_same_without_a_record(results, tmp_path):
    rank.main(["stage1", "--results", str(results)])
    made = results / "conditions" / "stage1"
    kept = tmp_path / "kept" / "stage1"
    kept.mkdir(parents=True)
    (kept / "conditions.csv").write_text((made / "conditions.csv").read_text())
    pd.read_csv(made / "measures.csv").to_csv(kept / "measures.csv.gz", index=False)
    rank.main(["stage1", "--results", str(tmp_path / "again"), "--kept", str(tmp_path / "kept")])
    again = tmp_path / "again" / "conditions" / "stage1"
    for name in ("conditions.csv", "outcomes.csv", "ranking.csv"):
        assert (again / name).read_text() == (made / name).read_text()


def test_without_a_stage_or_a_record_the_message_says_what_to_do(tmp_path):
    with pytest.raises(InputError, match="run the stage"):
        rank.main(["stage1", "--results", str(tmp_path)])
    folder = tmp_path / "conditions" / "stage1"
    folder.mkdir(parents=True)
    (folder / "conditions.csv").write_text("condition\nc1\n")
    with pytest.raises(InputError, match="no usable record"):
        rank.main(["stage1", "--results", str(tmp_path)])
