"""The paired table: pairs, correction over the table, seeds needed."""

import math

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.records import load_study
from analysis.data.scores import SCORES
from analysis.tables.compare import TOO_FEW, answer_text, comparison, main, verdict
from analysis.tables.paired_table import all_pairs, paired_table


@pytest.fixture
def results(tmp_path):
    """ldm is better than mine on F1 by 0.01, 0.02, ... 0.06; octomap lacks replicate 1."""
    records = []
    for replicate in range(1, 7):
        gain = 0.01 * replicate
        records.append(make_record("ldm", replicate, scores={"f1": 0.7 + gain}))
        records.append(make_record("mine", replicate, scores={"f1": 0.7}))
        if replicate > 1:
            records.append(make_record("octomap", replicate, scores={"f1": 0.7}))
    return write_records(tmp_path, records)


def test_rows_by_hand(results):
    study = load_study(results, "table1")
    table = paired_table(study, all_pairs(study, ["ldm"]), [SCORES["f1"]])
    assert table["baseline"].tolist() == ["mine", "octomap"]
    mine, octomap = table.iloc[0], table.iloc[1]
    assert mine["seeds"] == 6 and octomap["seeds"] == 5
    assert mine["difference"] == pytest.approx(0.035)
    assert octomap["difference"] == pytest.approx(0.04)
    assert mine["won"] == 1
    assert mine["p"] == pytest.approx(2 / 64) and octomap["p"] == pytest.approx(2 / 32)
    assert mine["p_holm"] == octomap["p_holm"] == pytest.approx(4 / 64)
    # sd^2 = 0.00035; 8.2193 * 0.00035 / 0.01^2 = 28.8
    assert mine["seeds_needed"] == 29
    assert verdict(mine) == "better"


def test_each_pair_comes_once(results):
    study = load_study(results, "table1")
    assert all_pairs(study, study.methods) == [
        ("ldm", "mine"), ("ldm", "octomap"), ("mine", "octomap")
    ]  # fmt: skip
    with pytest.raises(InputError, match="has no method 'yours'; it has ldm, mine, octomap"):
        all_pairs(study, ["yours"])


def test_a_score_that_one_method_lacks_gives_no_row(tmp_path):
    records = [make_record("ldm", 1), make_record("octomap", 1, scores={"f1": None})]
    study = load_study(write_records(tmp_path, records), "table1")
    assert paired_table(study, [("ldm", "octomap")], [SCORES["f1"]]).empty


def test_points_of_a_sweep_are_compared_apart(tmp_path):
    records = [
        make_record(method, 1, point={"particles.count": count}, scores={"f1": value})
        for method, count, value in [("a", 10, 0.5), ("b", 10, 0.4), ("a", 20, 0.5), ("b", 20, 0.8)]
    ]
    study = load_study(write_records(tmp_path, records), "table1")
    table = paired_table(study, [("a", "b")], [SCORES["f1"]])
    assert table["difference"].tolist() == pytest.approx([0.1, -0.3])
    assert table["low"].map(math.isnan).all()


def test_the_script_writes_prints_and_warns_of_too_few_seeds(results, capsys):
    assert run(main, ["--results", str(results), "--methods", "ldm mine", "--scores", "f1"]) == 0
    captured = capsys.readouterr()
    assert "missing: scenario1 octomap: replicate 1" in captured.err
    file = results / "table1" / "tables" / "compare.txt"
    assert captured.out.splitlines()[-1] == f"Intervals, tests and seeds needed: {file}"
    assert "With 6 seeds and 3 rows" in file.read_text() and "it takes 7 seeds" in file.read_text()
    assert (results / "table1" / "tables" / "compare.csv").read_text().count("\n") == 4


def test_below_five_seeds_there_are_differences_and_no_verdicts(tmp_path, capsys):
    records = [make_record(method, seed, scores={"f1": value})
               for seed in (1, 2, 3, 4) for method, value in (("ldm", 0.7), ("mine", 0.8))]
    write_records(tmp_path, records)
    table = comparison(load_study(tmp_path, "table1"), ["mine"], [SCORES["f1"]])
    assert table["difference"].tolist() == pytest.approx([0.1])
    assert table["verdict"].tolist() == [TOO_FEW]
    assert table[["low", "high", "p", "p_holm"]].isna().all(axis=None)

    assert run(main, ["--results", str(tmp_path), "--methods", "mine"]) == 0
    printed = capsys.readouterr().out
    assert "+0.1000" in printed and "mine against ldm: no verdict" in printed
    assert "With fewer than 5 seeds there are differences and no verdicts: SEEDS=5." in printed
    assert "better" not in printed and "worse" not in printed
    for name in ("compare.txt", "compare.csv"):
        rows = (tmp_path / "table1" / "tables" / name).read_text().split("needs")[-1]
        assert "better" not in rows and "worse" not in rows


def test_the_answer_is_one_screen(tmp_path, capsys):
    methods = ["ldm", "mine", *(f"other{n}" for n in range(10))]
    records = [make_record(method, seed, scenario=f"scenario{scenario}",
                           scores={"f1": 0.7 + 0.01 * len(method) + 0.001 * seed * scenario})
               for method in methods for seed in range(1, 7) for scenario in (1, 2, 3)]
    write_records(tmp_path, records)
    assert run(main, ["--results", str(tmp_path)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) <= 24 and max(map(len, lines[:-1])) <= 100
    assert any(line.startswith("F1") and line.count("worse") == 3 for line in lines)
    assert "... and 58 more pairs" in lines


def test_a_method_beside_the_study_has_a_folder_of_its_own(results, capsys):
    provenance = make_record()["provenance"] | {"plugin": {"file": "new.so", "hash": "h1"}}
    for replicate in range(1, 7):
        record = make_record("new", replicate, provenance=provenance, scores={"f1": 0.9})
        write_records(results, [record | {"study": "table1+new"}])
    assert run(main, ["--results", str(results), "--methods", "new", "--scores", "f1"]) == 0
    rows = (results / "table1" / "tables" / "compare.csv").read_text().splitlines()[1:]
    assert [row.split(",")[3:5] for row in rows] == [
        ["new", "ldm"], ["new", "mine"], ["new", "octomap"]
    ]  # fmt: skip
    assert "new against ldm: better in 1, worse in 0 of 1" in capsys.readouterr().out
    assert "new" not in load_study(results, "table1").methods


def test_a_method_beside_the_study_must_be_of_the_same_program(results, capsys):
    provenance = make_record()["provenance"] | {"binary": "b2"}
    record = make_record("new", 1, provenance=provenance) | {"study": "table1+new"}
    write_records(results, [record])
    assert run(main, ["--results", str(results), "--methods", "new"]) == 2
    assert "different binary: b1 in scenario1-ldm-1.json, b2 in" in capsys.readouterr().err


def test_an_unknown_score_is_refused(results, capsys):
    assert run(main, ["--results", str(results), "--scores", "beauty"]) == 2
    assert "--scores: 'beauty' is not one of accuracy_pct, " in capsys.readouterr().err
