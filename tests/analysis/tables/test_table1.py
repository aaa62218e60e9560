"""Table 1 of hand-made records, compared letter by letter, and the verdicts on its orderings."""

import csv

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.records import load_study
from analysis.tables.orderings import (
    NO_TRIALS,
    ONE_SEED,
    OPPOSITE,
    REPRODUCED,
    UNDECIDED,
    judge,
    published_claims,
)
from analysis.tables.table1 import main

# Three seeds of equal values: every mean and interval can be read off.
LDM = {"accuracy_pct": 99.6, "case1_voxels": 30000, "case2_voxels": 140000}
CIRCULAR_BUFFER = {"accuracy_pct": 99.5, "case1_voxels": 30000, "case2_voxels": 130000}

TEXT = """\
Table 1. Occupancy grid accuracy, the paper's beside ours: mean [95% bootstrap interval]
over seeds; study table1, 3 seeds of 1200 frames, commit 0123456789ab.

                                            Proposed: paper                  ours (ldm)  [11]: paper      ours (circular_buffer)
--------------------------------------------------------------------------------------------------------------------------------
Scenario 1  accuracy (%)                              99.55        99.60 [99.60, 99.60]        99.49        99.50 [99.50, 99.50]
Scenario 1  case 1 false voxels                      29,355     30,000 [30,000, 30,000]       40,215     30,000 [30,000, 30,000]
Scenario 1  case 2 false voxels                     148,406  140,000 [140,000, 140,000]      158,700  130,000 [130,000, 130,000]
Scenario 1  mixed false voxels (per frame)                -           57.5 [57.5, 57.5]            -           57.5 [57.5, 57.5]
Scenario 1  F1                                            -        0.790 [0.790, 0.790]            -        0.790 [0.790, 0.790]
Scenario 1  IoU, visible truth                            -        0.610 [0.610, 0.610]            -        0.610 [0.610, 0.610]
Scenario 1  ghost voxels (per frame)                      -           12.5 [12.5, 12.5]            -           12.5 [12.5, 12.5]
Scenario 1  time until 90% is cleared (s)                 -           0.80 [0.80, 0.80]            -           0.80 [0.80, 0.80]

Accuracy (Eq. 18) cannot tell a good map from none: unknown voxels count as free, and 0.2 to
0.5% of all are solid. empty_map, which knows nothing, shows what silence earns; F1 (against
solid voxels) and IoU (against visible ones) are 0 for it.

Orderings of Table 1: the paper says Proposed is better or worse than [11]; ours is the
difference ldm - circular_buffer, paired by seed, mean [95% bootstrap interval].

                                 paper                         ours  seeds won  p (Holm)  verdict
-----------------------------------------------------------------------------------------------------------------------------
Scenario 1  accuracy (%)         better     +0.100 [+0.100, +0.100]       100%      0.75  reproduced
Scenario 1  case 1 false voxels  better                 +0 [+0, +0]        50%      1.00  not reproduced: interval includes 0
Scenario 1  case 2 false voxels  better  +10,000 [+10,000, +10,000]         0%      0.75  not reproduced: opposite

Scenario 2  accuracy (%)         worse                            -          -         -  not reproduced: no trials
Scenario 2  case 1 false voxels  worse                            -          -         -  not reproduced: no trials
Scenario 2  case 2 false voxels  worse                            -          -         -  not reproduced: no trials

Scenario 3  accuracy (%)         better                           -          -         -  not reproduced: no trials
Scenario 3  case 1 false voxels  better                           -          -         -  not reproduced: no trials
Scenario 3  case 2 false voxels  better                           -          -         -  not reproduced: no trials

Other methods: mean [95% bootstrap interval] over seeds.

                             accuracy (%)      case 1 false voxels         case 2 false voxels  mixed false voxels (per frame)                    F1    IoU, visible truth  ghost voxels (per frame)  time until 90% is cleared (s)
-----------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------------
Scenario 1  octomap  99.50 [99.50, 99.50]  40,000 [40,000, 40,000]  150,000 [150,000, 150,000]               57.5 [57.5, 57.5]  0.790 [0.790, 0.790]  0.610 [0.610, 0.610]         12.5 [12.5, 12.5]              0.80 [0.80, 0.80]
"""


@pytest.fixture
def results(tmp_path):
    records = []
    for replicate in (1, 2, 3):
        records.append(make_record("ldm", replicate, scores=LDM))
        records.append(make_record("circular_buffer", replicate, scores=CIRCULAR_BUFFER))
        records.append(make_record("octomap", replicate))
    return write_records(tmp_path, records)


def test_text_is_exact_and_printed(results, capsys):
    assert run(main, ["--results", str(results)]) == 0
    assert (results / "table1" / "tables" / "table1.txt").read_text() == TEXT
    assert TEXT in capsys.readouterr().out


def test_csv_and_latex(results):
    run(main, ["--results", str(results)])
    folder = results / "table1" / "tables"
    rows = list(csv.DictReader((folder / "table1.csv").open()))
    assert rows[0] == {
        "scenario": "scenario1", "method": "circular_buffer", "score": "accuracy_pct",
        "mean": "99.5", "low": "99.5", "high": "99.5", "seeds": "3", "published": "99.49",
    }  # fmt: skip
    latex = (folder / "table1.tex").read_text()
    assert latex.startswith("\\begin{tabular}{lcc}\n\\toprule\n")
    assert "published & 29,355 & 40,215 \\\\\n" in latex
    assert "\\texttt{octomap}" in latex
    velocity = (folder / "velocity.tex").read_text()
    assert "Scenario 1 & dynamic velocity error (m/s) & 0.120 & 0.300 [0.300, 0.300]" in velocity


def test_two_runs_give_the_same_bytes(results):
    folder = results / "table1" / "tables"
    run(main, ["--results", str(results)])
    first = {file.name: file.read_bytes() for file in folder.iterdir()}
    run(main, ["--results", str(results)])
    assert {file.name: file.read_bytes() for file in folder.iterdir()} == first
    assert len(first) == 8


def test_a_shorter_study_says_that_sums_do_not_compare(tmp_path):
    write_records(tmp_path, [make_record(m, 1, frames=60) for m in ("ldm", "circular_buffer")])
    run(main, ["--results", str(tmp_path)])
    text = (tmp_path / "table1" / "tables" / "table1.txt").read_text()
    assert "sums over 60 frames here, over 1200 in the paper" in text


def judged(tmp_path, ldm, baseline):
    records = [make_record("ldm", i, scores={"f1": v}) for i, v in enumerate(ldm)]
    records += [make_record("octomap", i, scores={"f1": v}) for i, v in enumerate(baseline)]
    study = load_study(write_records(tmp_path, records), "table1")
    (claim,) = published_claims("scenario1", "f1", {"ldm": 0.9, "octomap": 0.8})
    return judge(study, [claim])[0]


@pytest.mark.parametrize(
    ("ldm", "baseline", "verdict"),
    [
        ([0.80, 0.81, 0.83, 0.84], [0.7, 0.7, 0.7, 0.7], REPRODUCED),
        ([0.60, 0.61, 0.63, 0.64], [0.7, 0.7, 0.7, 0.7], OPPOSITE),
        ([0.80, 0.60, 0.83, 0.58], [0.7, 0.7, 0.7, 0.7], UNDECIDED),
        ([0.80], [0.7], ONE_SEED),
        ([0.80], [], NO_TRIALS),
    ],
)
def test_verdicts(tmp_path, ldm, baseline, verdict):
    found = judged(tmp_path, ldm, baseline)
    assert found.claim.word == "better"
    assert found.verdict == verdict
