"""The paper's numbers agree with one another."""

import pytest

from analysis.data.published import published

SETUP = published()["setup"]


@pytest.mark.parametrize("scenario", ["scenario1", "scenario2", "scenario3"])
@pytest.mark.parametrize("method", ["ldm", "circular_buffer"])
def test_accuracy_follows_from_the_false_voxels(scenario, method):
    # Eq. 18 over 1200 frames: a wrong digit in any of the three cells would show.
    row = published()["table1"][scenario]
    false_voxels = row["case1_voxels"][method] + row["case2_voxels"][method]
    accuracy = 100 * (1 - false_voxels / (SETUP["frames"]["value"] * SETUP["voxels_per_map"]))
    assert accuracy == pytest.approx(row["accuracy_pct"][method], abs=0.006)


def test_every_value_says_where_it_stands():
    for table in ("table1", "velocity", "causes", "outdoor"):
        for entry in published()[table].values():
            assert entry["place"].startswith(("Table", "Sec."))
    assert published()["computation_time"]["place"] == "Sec. 4.1.2"
