"""The generated part of the report: the ledger's verdicts, missing studies, stale tables."""

import re
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest
from record_files import TYPICAL_SCORES, make_record, make_series, write_records

from analysis.report.__main__ import main, write_report
from analysis.report.claims import counts, ledger
from analysis.report.closed_loop import closed_loop_numbers, success_table
from analysis.report.comparisons import NO, OPEN, PARTLY, YES, paired, verdict_on_order
from analysis.report.evidence import Evidence
from analysis.report.latex import code, missing, plain
from analysis.report.open_points import alternatives, of_point, open_points
from analysis.report.sensitivity import OTHER, SAME, sensitivity_table
from analysis.report.sources import stale
from analysis.tables.avoidance_table import COUNTS, MEANS, MEDIUM, VIOLATIONS
from analysis.tables.orderings import Claim

ROOT = Path(__file__).resolve().parents[3]
METHODS = ("ldm", "circular_buffer", "circular_buffer_pf_eq17")
SCENARIOS = ("scenario1", "scenario2", "scenario3")
SEEDS = (1, 2, 3)


def scores_of(method, seed):
    """The LDM errs less in case 1 and more in case 2 than the others."""
    worse = method != "ldm"
    return {
        "accuracy_pct": 99.5 + 0.01 * seed,
        "case1_voxels": 30000 + (10000 + 400 * seed) * worse,
        "case2_voxels": 170000 - 10000 * worse + 100 * seed,
        "time_to_converge_s": 1.0 + 0.1 * seed,
    }


@pytest.fixture(scope="module")
def results(tmp_path_factory):
    """Three seeds of `table1` with series, and two settings of an ablation."""
    frames = list(range(10, 60))
    records = [
        make_record(m, seed, scenario=scenario, scores=scores_of(m, seed),
                    series=[make_series(2 * seed, True, frames), make_series(2 * seed + 1, False, frames)])
        for m in METHODS for scenario in SCENARIOS for seed in SEEDS
    ]  # fmt: skip
    for method in ("ldm", "circular_buffer", "high_threshold"):
        threshold = 0.7 if method == "high_threshold" else 0.5
        records += [
            make_record(method, seed, study="ablation", scenario=scenario, scores=scores_of(method, seed),
                        parameters={"clusters.occupied_above": threshold, "execution.seed": seed})
            for scenario in SCENARIOS for seed in SEEDS
        ]  # fmt: skip
    return write_records(tmp_path_factory.mktemp("report"), records)


@pytest.fixture(scope="module")
def index(tmp_path_factory):
    """As tests/equations.py prints it."""
    file = tmp_path_factory.mktemp("index") / "equations.json"
    script = ROOT / "tests" / "equations.py"
    printed = subprocess.run([sys.executable, script, "--json"], stdout=subprocess.PIPE, text=True, check=True)
    file.write_text(printed.stdout)
    return file


@pytest.fixture(scope="module")
def generated(results, index, tmp_path_factory):
    output = tmp_path_factory.mktemp("generated")
    write_report(Evidence(results), index, output)
    return output


def by_statement(rows, *words):
    found = [row for row in rows if all(word in row.statement for word in words)]
    assert len(found) == 1
    return found[0]


@pytest.mark.parametrize("ours, verdict", [
    ([-9, -11, -10], YES), ([-90, -110, -100], PARTLY), ([9, 11, 10], NO), ([-10, 10, 1], NO),
])  # fmt: skip
def test_order_and_size_make_the_verdict(ours, verdict):
    claim = Claim("scenario1", "case1_voxels", "a", "b", published_difference=-10.5)
    differences = pd.Series(ours, dtype=float)
    found = paired(differences, differences * 0, "lower")
    assert verdict_on_order(claim, found, differences) == verdict


def test_the_ledger_has_every_claim_and_says_what_is_open(results):
    rows = ledger(Evidence(results))
    assert by_statement(rows, "Scenario 1, case 1").verdict == YES
    assert by_statement(rows, "Scenario 1, case 2").verdict == NO
    assert by_statement(rows, "time to converge", "with Eq. 17").verdict == YES
    survival = by_statement(rows, "survival is the cause")
    assert survival.verdict == OPEN and "STUDY=ablation" in survival.ours[0]
    assert by_statement(rows, "computation time").ours == (missing("timing"),)
    assert sum(counts(rows).values()) == len(rows) == 29


def outdoor_ledger(folder, tracks, **scores):
    """The outdoor rows where the LDM and the LDM without prediction have so many tracks a stay."""
    frames = list(range(100))
    records = [
        make_record(method, seed, study="outdoor", scenario=scenario,
                    series=[make_series(0, False, frames, 0.01), make_series(1, True, frames, 0.01)],
                    scores={"tracks_per_stay": count + seed / 10} | scores)
        for method, count in zip(("ldm", "no_prediction"), tracks)
        for scenario in ("outdoor1", "outdoor2") for seed in SEEDS
    ]  # fmt: skip
    rows = ledger(Evidence(write_records(folder, records)))
    return [row for row in rows if row.statement.startswith("Outdoor")]


def test_outdoor_claims_are_judged_by_the_outdoor_study(tmp_path):
    kept = {"hidden_with_cluster_pct": 99.0, "occlusions_kept_pct": 60.0}
    rows = outdoor_ledger(tmp_path / "a", (1, 2), **kept)
    assert by_statement(rows, "standing person").verdict == YES
    assert by_statement(rows, "keeps its cluster").verdict == YES
    assert by_statement(rows, "keeps its identity").verdict == PARTLY
    assert by_statement(rows, "prediction is the cause").verdict == YES
    assert by_statement(rows, "direction", "outdoor2").verdict == YES
    rows = outdoor_ledger(tmp_path / "b", (2, 2), **kept | {"hidden_with_cluster_pct": 40.0})
    assert by_statement(rows, "keeps its cluster").verdict == NO
    assert by_statement(rows, "prediction is the cause").verdict == NO


def test_outdoor_trials_too_short_for_an_occlusion_decide_nothing(tmp_path):
    nothing = {"hidden_with_cluster_pct": None, "occlusions_kept_pct": None}
    rows = outdoor_ledger(tmp_path, (1, 2), **nothing)
    assert by_statement(rows, "keeps its identity").verdict == OPEN
    assert by_statement(rows, "direction", "outdoor1").verdict == YES


def test_without_any_result_all_is_open_and_said_so(tmp_path, index, capsys):
    output = tmp_path / "generated"
    main(["--results", str(tmp_path), "--equations", str(index), "--output", str(output)])
    assert "make study STUDY=survival" in capsys.readouterr().out
    assert {row.verdict for row in ledger(Evidence(tmp_path))} == {OPEN}
    assert "make reproduce" in (output / "accuracy.tex").read_text()
    assert "make reproduce" in (output / "figure-figure6.tex").read_text()


def test_captions_name_study_seeds_and_commit(generated):
    captioned = [f for f in generated.glob("*.tex") if r"\caption" in f.read_text()]
    made = [f for f in captioned if "missing" not in f.read_text()]
    names = {file.stem for file in made} - {"equations"}
    assert {"accuracy", "velocity", "figure-figure6", "figure-ablation"} <= names
    for name in names:
        text = (generated / f"{name}.tex").read_text().replace(r"\allowbreak ", "")
        assert re.search(r"3 seeds of 1200 frames, commit 0123456789ab", text), name


def test_every_number_that_the_text_names_is_generated(generated):
    made = re.findall(r"csname val:([^\\]+)\\endcsname", (generated / "numbers.tex").read_text())
    used = set()
    for file in (ROOT / "paper").glob("**/*.tex"):
        if "generated" not in file.parts:
            used |= set(re.findall(r"\\val\{([^}#]+)\}", file.read_text()))
            used |= {f"eq.{n}" for n in re.findall(r"\\home\{(\d+)\}", file.read_text())}
    parameters = {key for key in used if key.startswith("parameter.")}
    assert used - parameters <= set(made) and len(used) > 30
    assert parameters == {"parameter.particles.count"}  # the records of this test have fewer


def test_every_input_of_the_text_is_generated(generated):
    for file in (ROOT / "paper" / "sections").glob("*.tex"):
        text = file.read_text()
        names = re.findall(r"generated/([\w-]+)", text)
        names += [f"figure-{n}" for n in re.findall(r"\\(?:halfpicture|sweep)\{([\w-]+)\}", text)]
        for name in names:
            assert (generated / f"{name}.tex").exists(), name


def test_alternatives_are_found_by_what_they_change(results):
    study = Evidence(results).study("ablation")
    defaults = study.records[0]["parameters"] | {"clusters.occupied_above": 0.5}
    found = alternatives(Evidence(results), defaults)
    assert [a.entrant for a in found] == [("high_threshold", "")]
    point = next(p for p in open_points() if p["parameters"] == ["clusters.occupied_above"])
    assert of_point(point, found) == found
    assert found[0].label.startswith(r"\code{occupied\_\allowbreak above = 0.\allowbreak 7}")


def test_sensitivity_marks_the_paper_s_order_and_the_other(results):
    lines = sensitivity_table(Evidence(results), "caption").splitlines()
    marks = {line.split(" & ")[0]: line.split(" & ")[2] for line in lines if line.startswith("Scen")}
    assert marks["Scenario 1, case 1 false voxels"] == SAME
    assert marks["Scenario 1, case 2 false voxels"] == OTHER


def test_the_closed_loop_has_its_numbers_and_says_what_it_lacks(tmp_path):
    times = {name: {"median": 1.25, "p95": 2.75} for name in ("plan_ms", "map_ms")}
    rest = dict.fromkeys([*COUNTS, *VIOLATIONS, *MEANS], 0)
    records = [
        make_record(arm, seed, study="avoidance", scenario=world)
        | {"scores": rest | {"success": int(seed <= arrive)}, "timing": times}
        for arm, arrive in {"ldm": 10, "circular_buffer": 2}.items()
        for world in MEDIUM for seed in range(1, 11)
    ]  # fmt: skip
    evidence = Evidence(write_records(tmp_path / "results", records))
    found = closed_loop_numbers(evidence)
    assert found["avoidance.medium.circular_buffer"] == r"20\,\% \bounds{8}{42}"
    assert found["avoidance.medium.ldm.circular_buffer"] == r"$p$ $<$0.001"
    assert (found["avoidance.pairs"], found["avoidance.pairs.differ"]) == ("2", "2")
    assert found["avoidance.plan.p95"] in ("2.7", "2.8")
    assert found["avoidance.medium.oracle"] == "--"
    assert "moving10" in success_table(evidence, "caption")
    nothing = closed_loop_numbers(Evidence(tmp_path))
    assert nothing.keys() == found.keys()
    assert nothing["avoidance.medium.ldm"] == missing("avoidance")
    assert "make avoidance" in success_table(Evidence(tmp_path), "caption")


def test_shortened_trials_stand_in_until_full_ones_exist(tmp_path):
    write_records(tmp_path, [make_record(study="survival-f50"), make_record(study="survival-f400")])
    assert Evidence(tmp_path).folder("survival").name == "survival-f400"
    write_records(tmp_path, [make_record(study="survival")])
    assert Evidence(tmp_path).folder("survival").name == "survival"


def test_a_table_older_than_its_records_is_found(tmp_path, index):
    output = tmp_path / "generated"
    results = write_records(tmp_path / "results", [make_record(study="survival")])
    assert stale(output) == []
    write_report(Evidence(results), index, output)
    assert stale(output) == []
    write_records(results, [make_record(study="survival", scores=TYPICAL_SCORES | {"f1": 0.1})])
    assert len(stale(output)) == 1 and "survival" in stale(output)[0]


def test_no_table_of_this_report_is_older_than_its_records():
    assert stale(ROOT / "paper" / "generated") == []


def test_latex_text():
    assert code("a_b.c") == r"\code{a\_\allowbreak b.\allowbreak c}"
    assert plain("-1 to 50%") == r"$-$1 to 50\%"
