"""Shares of conditions, and what decides a claim: cases whose answer is known."""

import numpy as np
import pandas as pd
import pytest
from analysis.conditions import claims_map, pair_map
from analysis.conditions.claims import claims
from analysis.conditions.shares import decides, parts_of, ranking, share
from analysis.data.errors import InputError

COUNT = 240


@pytest.fixture
def conditions():
    generator = np.random.default_rng(1)
    names = [f"c{k}" for k in range(COUNT)]
    return pd.DataFrame({"speed_mps": generator.random(COUNT), "sigma_mps": generator.random(COUNT),
                         "sub_voxel": generator.choice(["a", "b"], COUNT)},
                        index=pd.Index(names, name="condition"))  # fmt: skip


def test_numbers_are_cut_into_thirds_and_words_stay(conditions):
    assert parts_of(conditions["speed_mps"]).value_counts().between(79, 81).all()
    assert set(parts_of(conditions["sub_voxel"])) == {"a", "b"}


def test_a_share_has_wilsons_interval():
    # Wilson's interval of 5 of 10, from the formula.
    assert share(pd.Series([1, 0] * 5)) == pytest.approx((0.5, 0.2366, 0.7634), abs=1e-4)
    assert np.isnan(share(pd.Series(dtype=float))[0])


def test_an_unknown_that_decides_alone_has_index_1_and_one_without_a_say_about_0():
    part = np.repeat([0, 1, 2], 80)
    assert decides((part == 1).astype(float), part) == pytest.approx(1)
    by_chance = np.random.default_rng(2).permutation((part == 1).astype(float))
    assert abs(decides(by_chance, part)) < 0.03
    assert decides(np.ones(240), part) == 0


def test_the_ranking_names_what_decides(conditions):
    leans = (parts_of(conditions["sigma_mps"]) == 0).astype(float)
    found = ranking(leans, conditions)
    assert found["unknown"][0] == "sigma_mps" and found["low"][0] > 0.5
    assert (found["high"][1:] < 0.2).all()


def test_of_a_few_conditions_nothing_is_said(conditions):
    assert ranking(pd.Series(dtype=float), conditions)["index"].isna().all()
    few = conditions.head(9)
    assert ranking(pd.Series(1.0, index=few.index), few)["low"].isna().all()


def test_the_map_shows_every_claim_and_says_what_decides_it(tmp_path, conditions, capsys):
    stage = tmp_path / "conditions" / "stage1"
    stage.mkdir(parents=True)
    conditions.to_csv(stage / "conditions.csv")
    slow = conditions["speed_mps"] < 0.5
    rows = [{"condition": name, "claim": claim.key, "leans": bool(slow[name]), "n": 1}
            for claim in claims() for name in conditions.index]  # fmt: skip
    rows[0]["n"] = 0  # a missing trial is no answer
    pd.DataFrame(rows).to_csv(stage / "outcomes.csv")
    claims_map.main(["--results", str(tmp_path)])
    root = tmp_path / "conditions"
    assert (root / "figures" / "claims_map.png").stat().st_size > 10_000
    table = pd.read_csv(root / "tables" / "claims.csv")
    assert table["conditions"].tolist() == [COUNT - 1] + [COUNT] * (len(claims()) - 1)
    assert table["share"][1] == pytest.approx(slow.mean())
    assert table["decided_by"].str.startswith("speed_mps").all()
    assert "speed_mps" in capsys.readouterr().out


def test_every_claim_has_a_label_of_its_own():
    labels = [claims_map.label(claim) for claim in claims()]
    assert len(set(labels)) == len(labels)


def test_without_a_ranked_stage_the_message_says_what_to_do(tmp_path):
    (tmp_path / "conditions" / "stage1").mkdir(parents=True)
    (tmp_path / "conditions" / "stage1" / "conditions.csv").write_text("condition\nc1\n")
    with pytest.raises(InputError, match="rank the stage"):
        claims_map.main(["--results", str(tmp_path)])


def test_the_power_of_a_cell_is_that_of_the_sign_test():
    # Of 10, 9 or more are needed: P(>= 9 | 0.5) = 0.0107, P(>= 8 | 0.5) = 0.0547.
    assert pair_map.power(10) == pytest.approx(10 * 0.8**9 * 0.2 + 0.8**10)
    assert pair_map.power(0) == 0
    assert pair_map.power(100) > 0.99


def test_cells_of_speed_and_sigma_are_those_in_which_a_claim_holds(tmp_path, conditions):
    stage = tmp_path / "conditions" / "stage1"
    stage.mkdir(parents=True)
    conditions.to_csv(stage / "conditions.csv")
    holds = conditions["sigma_mps"] < conditions["sigma_mps"].median()
    rows = [{"condition": name, "claim": claim.key, "leans": bool(holds[name]), "n": 1}
            for claim in claims() for name in conditions.index]  # fmt: skip
    pd.DataFrame(rows).to_csv(stage / "outcomes.csv")
    pair_map.main(["--results", str(tmp_path)])
    table = pd.read_csv(tmp_path / "conditions" / "tables" / "speed_sigma.csv")
    of_one = table[table["claim"] == claims()[18].key]
    assert (of_one.groupby("sigma_mps")["share"].mean() == [1, 1, 0, 0]).all()
    assert of_one["conditions"].sum() == COUNT
    assert (tmp_path / "conditions" / "figures" / "speed_sigma.png").stat().st_size > 10_000
