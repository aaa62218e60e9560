"""Conditions: values within their ranges, the same again, and offspring near their parents."""

import math

import numpy as np
import pytest
from design import offspring, read_conditions, space_filling, write_conditions
from unknowns import Unknown, unknowns

NUMBER = Unknown("n", None, (), 0.1, 10, True, False, None)
SWITCH = Unknown("s", None, (), -0.1, 0.3, False, False, 0)
WORDS = Unknown("w", None, ("a", "b", "c"), 0, 0, False, False, None)


def test_a_logarithmic_range_is_spread_by_ratios():
    assert NUMBER.value(0) == 0.1
    assert NUMBER.value(0.5) == pytest.approx(1)
    assert NUMBER.share(1.0) == pytest.approx(0.5)


def test_the_low_end_of_a_switch_is_off():
    assert SWITCH.value(0.2) == 0
    assert SWITCH.value(0.5) == pytest.approx(0.1)


def test_words_have_equal_parts():
    assert [WORDS.value(share) for share in (0, 0.4, 0.9, 1.0)] == ["a", "b", "c", "c"]
    assert WORDS.value(WORDS.share("b")) == "b"


def test_a_design_fills_the_ranges_and_is_the_same_again():
    found = space_filling(64)
    assert found == space_filling(64)
    for unknown in unknowns():
        shares = np.array([unknown.share(condition[unknown.name]) for condition in found])
        assert shares.min() >= -1e-3 and shares.max() <= 1 + 1e-3
        assert shares.min() < 0.3 and shares.max() > 0.7


def test_every_word_comes_about_equally_often():
    found = space_filling(128)
    for unknown in unknowns():
        for word in unknown.words:
            times = sum(condition[unknown.name] == word for condition in found)
            assert abs(times - 128 / len(unknown.words)) <= 8


def test_offspring_stay_within_the_ranges_and_near_their_parents():
    parents = space_filling(4)
    born = offspring(parents, 40)
    assert len(born) == 40 and born == offspring(parents, 40)
    for unknown in unknowns():
        shares = np.array([unknown.share(child[unknown.name]) for child in born])
        assert shares.min() >= -1e-3 and shares.max() <= 1 + 1e-3
    speed = next(u for u in unknowns() if u.name == "speed_mps")
    of_parents = [speed.share(parent["speed_mps"]) for parent in parents]
    near = [min(abs(speed.share(child["speed_mps"]) - p) for p in of_parents) for child in born]
    assert 0 < np.median(near) < 0.15


def test_no_offspring_without_asking():
    assert offspring(space_filling(2), 0) == []


def test_conditions_come_back_from_their_file(tmp_path):
    found = {f"c{k}": condition for k, condition in enumerate(space_filling(5))}
    write_conditions(tmp_path / "x" / "conditions.csv", found)
    assert read_conditions(tmp_path / "x" / "conditions.csv") == found


@pytest.mark.parametrize("name", [unknown.name for unknown in unknowns()])
def test_every_unknown_has_a_finite_range_or_words(name):
    unknown = next(u for u in unknowns() if u.name == name)
    assert len(unknown.words) > 1 or math.isfinite(unknown.high - unknown.low) and unknown.low < unknown.high
