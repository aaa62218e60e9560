"""Records that must not share a table stop with one line that says which."""

import pytest
from record_files import make_record, write_records

from analysis.data.errors import InputError
from analysis.data.records import load_study


def refusal(tmp_path, *records):
    write_records(tmp_path, list(records))
    with pytest.raises(InputError) as caught:
        load_study(tmp_path, "table1")
    text = str(caught.value)
    assert "\n" not in text and str(tmp_path / "table1") in text
    return text


def with_provenance(replicate, **changes):
    record = make_record("ldm", replicate)
    return record | {"provenance": record["provenance"] | changes}


@pytest.mark.parametrize("key", ["commit", "binary", "dirty"])
def test_other_programs(tmp_path, key):
    text = refusal(tmp_path, make_record("ldm", 1), with_provenance(2, **{key: "other"}))
    assert f"different {key}: " in text
    assert "other in scenario1-ldm-2.json" in text and "in scenario1-ldm-1.json" in text


def test_other_builds_of_a_plugin(tmp_path):
    builds = [with_provenance(n, plugin={"file": "mine.so", "hash": f"h{n}"}) for n in (1, 2)]
    text = refusal(tmp_path, *builds)
    assert "different plugin for ldm: h1 in scenario1-ldm-1.json, h2 in scenario1-ldm-2.json" in text


def test_other_frames(tmp_path):
    text = refusal(tmp_path, make_record("ldm", 1), make_record("octomap", 1, frames=60))
    assert "different frames: 1200 in scenario1-ldm-1.json, 60 in scenario1-octomap-1.json" in text


def test_other_parameters_of_one_method_and_point(tmp_path):
    other = make_record("ldm", 2, parameters={"map.resolution_m": 0.3, "execution.seed": 9})
    text = refusal(tmp_path, make_record("ldm", 1), other)
    assert "different map.resolution_m for ldm: 0.15 in scenario1-ldm-1.json, 0.3 in" in text


def test_parameters_may_differ_between_methods_points_and_in_the_seed(tmp_path):
    write_records(
        tmp_path,
        [
            make_record("ldm", 1),
            make_record("ldm", 2),
            make_record("octomap", 1, parameters={"map.resolution_m": 0.3}),
            make_record("ldm", 1, point={"map.resolution_m": 0.6}),
        ],
    )
    assert len(load_study(tmp_path, "table1").trials) == 4


def test_other_worlds(tmp_path):
    text = refusal(
        tmp_path, make_record("ldm", 1), make_record("octomap", 1, scenario_file_hash="new")
    )
    assert "different scenario_file_hash for scenario1: hash-of-scenario1 in" in text
    seeds = {"scenario": "77", "filter": "1"}
    text = refusal(tmp_path, make_record("ldm", 1), make_record("octomap", 1, seeds=seeds))
    assert "different seeds.scenario for scenario1 replicate 1: 1001 in" in text


def test_the_same_trial_twice(tmp_path):
    text = refusal(tmp_path, make_record("ldm", 1, id="a"), make_record("ldm", 1, id="b"))
    assert "two records of one trial: a.json and b.json" in text
