"""The table of one condition: the nearest one unless another is asked for."""

import pandas as pd
import pytest
from analysis.conditions import verdict_table
from analysis.conditions.claims import claims
from analysis.data.errors import InputError


@pytest.fixture
def results(tmp_path):
    stage = tmp_path / "conditions" / "stage3"
    stage.mkdir(parents=True)
    rows = [(name, "scenario1", method, k, "accuracy_pct", value + 0.001 * k)
            for name, ours in (("near", 99.55), ("far", 99.40))
            for method, value in (("ldm", ours), ("circular_buffer", 99.49)) for k in range(5)]  # fmt: skip
    columns = ["condition", "scenario", "method", "replicate", "measure", "value"]
    pd.DataFrame(rows, columns=columns).to_csv(stage / "measures.csv", index=False)
    (stage / "ranking.csv").write_text("condition\nnear\nfar\n")
    return tmp_path


def test_it_shows_the_nearest_condition_with_every_claim(results, capsys):
    verdict_table.main(["stage3", "--results", str(results)])
    printed = capsys.readouterr().out
    assert "Condition near of stage3, 5 worlds" in printed and "1 of 9 orders" in printed
    line = next(line for line in printed.splitlines() if line.startswith("S1 order, accuracy"))
    assert line.split()[3] == "0.060" and line.endswith("holds")
    table = pd.read_csv(results / "conditions" / "tables" / "verdicts_stage3_near.csv")
    assert len(table) == len(claims()) and table["verdict"][0] == "holds"


def test_another_condition_can_be_asked_for(results, capsys):
    verdict_table.main(["stage3", "--condition", "far", "--results", str(results)])
    line = next(x for x in capsys.readouterr().out.splitlines() if x.startswith("S1 order, accuracy"))
    assert line.endswith("fails")


def test_what_is_not_there_is_refused(results, tmp_path):
    with pytest.raises(InputError, match="allowed: a condition of stage3"):
        verdict_table.main(["stage3", "--condition", "none", "--results", str(results)])
    with pytest.raises(InputError, match="rank the stage"):
        verdict_table.main(["stage1", "--results", str(results)])
