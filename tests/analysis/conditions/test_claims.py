"""The paper's claims as intervals: numbers worked by hand from published.toml."""

import math

import pytest

from analysis.conditions.claims import claims, pf_readings

BY_KEY = {claim.key: claim for claim in claims()}


def test_every_claim_has_a_key_of_its_own():
    assert len(BY_KEY) == len(claims())


def test_table_1_has_nine_orders_and_nine_sizes():
    assert sum(claim.name == "order" for claim in claims()) == 9
    assert sum(claim.name == "size" for claim in claims()) == 9


def test_an_order_is_beyond_zero_on_the_papers_side():
    fewer = BY_KEY["order.scenario1.case1_voxels.circular_buffer"]
    assert (fewer.low, fewer.high) == (-math.inf, 0)
    better = BY_KEY["order.scenario1.accuracy_pct.circular_buffer"]
    assert (better.low, better.high) == (0, math.inf)
    worse = BY_KEY["order.scenario2.accuracy_pct.circular_buffer"]
    assert (worse.low, worse.high) == (-math.inf, 0)


def test_the_size_of_a_count_is_a_share_of_the_baseline():
    claim = BY_KEY["size.scenario1.case1_voxels.circular_buffer"]
    share = 100 * (29355 - 40215) / 40215
    assert claim.paper == pytest.approx(share)
    assert claim.scale == pytest.approx(-share / 2)
    assert (claim.low, claim.high) == pytest.approx((1.5 * share, 0.5 * share))


def test_the_size_of_an_accuracy_is_in_points():
    claim = BY_KEY["size.scenario3.accuracy_pct.circular_buffer"]
    assert claim.paper == pytest.approx(0.02)
    assert (claim.low, claim.high) == pytest.approx((0.01, 0.03))


@pytest.mark.parametrize("name", ["static_order", "dynamic_order", "convergence", "static_times"])
def test_a_claim_against_the_particle_filter_comes_once_for_each_reading(name):
    assert [c.baseline for c in claims() if c.name == name] == list(pf_readings())


def test_levels_have_the_papers_number_and_a_limit():
    claim = BY_KEY["dynamic_level.scenario1.dynamic_velocity_error_mps"]
    assert (claim.paper, claim.low, claim.high) == (0.12, -math.inf, 0.15)


def test_similar_is_an_interval_around_no_difference():
    claim = BY_KEY["convergence.scenario1.time_to_converge_s.circular_buffer_pf_free"]
    assert (claim.paper, claim.low, claim.high) == (0, -0.1, 0.1)


def test_at_least_has_no_upper_bound():
    claim = BY_KEY["outdoor_static.outdoor1.static_share_pct"]
    assert (claim.low, claim.high, claim.paper) == (95, math.inf, None)
