"""Which margins an arm takes: the rule of docs/avoidance.md, worked by hand."""

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.records import load_study
from analysis.tables.trust_table import arrivals, chosen, main

ARRIVE = {"ldm": {0.0: 1, 0.1: 3, 0.2: 2}, "octomap": {0.0: 2, 0.1: 2, 0.2: 1}}
"""Arm -> margin -> how many of 4 flights arrive."""


@pytest.fixture
def results(tmp_path):
    records = []
    for arm, points in ARRIVE.items():
        for margin, many in points.items():
            for seed in range(1, 5):
                record = make_record(arm, seed, study="avoidance_trust", scenario="still8",
                                     point={"trust.margin_m": margin})  # fmt: skip
                records.append(record | {"scores": {"success": int(seed <= many)}})
    return write_records(tmp_path, records)


def test_an_arm_takes_the_point_of_most_arrivals_and_of_equals_the_smaller_margin(results):
    table = arrivals(load_study(results, "avoidance_trust"))
    assert table["arrive"].tolist() == [1, 3, 2, 2, 2, 1]
    assert set(table["flights"]) == {4}
    assert chosen(table).to_dict() == {"ldm": "trust.margin_m=0.1", "octomap": "trust.margin_m=0.0"}


def test_writes_and_marks_what_is_taken(results, capsys):
    assert run(main, ["--results", str(results)]) == 0
    assert capsys.readouterr().out.splitlines()[-3].split() == ["ldm", "1", "3*", "2", "4"]
    folder = results / "avoidance_trust" / "tables"
    assert (folder / "trust.csv").read_text().splitlines()[2] == "ldm,trust.margin_m=0.1,4,3,True"
    assert "octomap" in (folder / "trust.txt").read_text()
