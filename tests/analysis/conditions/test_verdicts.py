"""Verdicts on claims, held against scipy's tests, and the distance worked by hand."""

import math

import numpy as np
import pandas as pd
import pytest
from scipy import stats

from analysis.conditions import verdicts
from analysis.conditions.claims import Claim, claims
from analysis.conditions.verdicts import FAILS, HOLDS, MISSING, UNDECIDED, decide, outcomes

ORDER = Claim("order", "g", "order", "s", "score", "b", 0, math.inf, 1.0, None)
SIMILAR = Claim("like", "g", "similar", "s", "score", "b", -0.1, 0.1, 0.0, 0.1)
AT_MOST = Claim("most", "g", "at_most", "s", "score", None, -math.inf, 0.15, 0.12, 0.03)
AT_LEAST = Claim("least", "g", "at_least", "s", "score", None, 95, math.inf, None, 5)


def rows(scenario, method, measure, values):
    return [(scenario, method, k + 1, measure, value) for k, value in enumerate(values)]


def table(found):
    return pd.DataFrame(found, columns=["scenario", "method", "replicate", "measure", "value"])


@pytest.mark.parametrize("seed", range(20))
def test_an_order_is_a_one_sided_t_test(seed):
    x = np.random.default_rng(seed).normal(0.4, 1, 10)
    p = stats.ttest_1samp(x, 0, alternative="greater").pvalue
    opposite = stats.ttest_1samp(x, 0, alternative="less").pvalue
    expected = HOLDS if p < 0.05 else FAILS if opposite < 0.05 else UNDECIDED
    assert decide(ORDER, x).verdict == expected


@pytest.mark.parametrize("seed", range(20))
def test_similar_is_two_one_sided_t_tests(seed):
    x = np.random.default_rng(seed).normal(0.03, 0.12, 12)
    p = max(stats.ttest_1samp(x, -0.1, alternative="greater").pvalue,
            stats.ttest_1samp(x, 0.1, alternative="less").pvalue)
    assert (decide(SIMILAR, x).verdict == HOLDS) == (p < 0.05)


def test_an_interval_around_zero_proves_no_similarity():
    assert decide(SIMILAR, np.array([-1.0, 1.0, -2.0, 2.0])).verdict == UNDECIDED


def test_a_limit_holds_fails_or_stays_open():
    assert decide(AT_MOST, np.array([0.10, 0.11, 0.12])).verdict == HOLDS
    assert decide(AT_MOST, np.array([0.30, 0.31, 0.32])).verdict == FAILS
    assert decide(AT_MOST, np.array([0.10, 0.15, 0.20])).verdict == UNDECIDED
    assert decide(AT_LEAST, np.array([100.0, 100.0])).verdict == HOLDS
    assert decide(AT_LEAST, np.array([80.0, 81.0])).verdict == FAILS


def test_one_world_decides_nothing_but_leans():
    found = decide(ORDER, np.array([3.0]))
    assert (found.verdict, found.n, found.leans) == (UNDECIDED, 1, True)
    assert not decide(ORDER, np.array([0.0])).leans
    assert not decide(AT_MOST, np.array([0.2])).leans


def test_without_a_trial_a_claim_is_missing():
    found = decide(ORDER, np.zeros(0))
    assert found.verdict == MISSING and not found.leans
    assert math.isnan(verdicts.deviation(found))


def test_power_grows_with_worlds_and_is_that_of_the_t_test():
    x = np.array([0.0, 2.0] * 5)
    error = np.std(x, ddof=1) / math.sqrt(10)
    assert decide(ORDER, x).power == pytest.approx(
        stats.nct.sf(stats.t.ppf(0.95, 9), 9, 1 / error))
    assert decide(ORDER, np.tile(x, 5)).power > decide(ORDER, x).power
    assert decide(ORDER, np.array([1.0, 1.0])).power == 1


def test_deviation_is_in_units_of_the_scale_and_bounded():
    assert verdicts.deviation(decide(AT_MOST, np.array([0.18]))) == pytest.approx(2)
    assert verdicts.deviation(decide(AT_MOST, np.array([9.0]))) == verdicts.MOST
    assert verdicts.deviation(decide(AT_LEAST, np.array([97.0]))) == 0
    assert verdicts.deviation(decide(AT_LEAST, np.array([90.0]))) == pytest.approx(1)


def measures_like_the_paper(pf="circular_buffer_pf_eq17"):
    """One world with the paper's numbers wherever it gives any, against one reading of the filter."""
    found = []
    for claim in claims():
        if claim.name == "size":
            value, base = (claim.paper, 0.0) if not claim.relative else (100 + claim.paper, 100.0)
            found += rows(claim.scenario, "ldm", claim.measure, [value])
            found += rows(claim.scenario, claim.baseline, claim.measure, [base])
    for scenario, measure, ours, theirs in (
        ("scenario2", "static_velocity_error_mps", 0.009, 0.019),
        ("scenario1", "dynamic_velocity_error_mps", 0.12, 0.15),
        ("scenario1", "time_to_converge_s", 1.0, 1.0),
        ("scenario1", "fluctuation_mps", 0.05, 0.06),
    ):
        found += rows(scenario, "ldm", measure, [ours])
        for reading in ("circular_buffer_pf_eq17", "circular_buffer_pf_free"):
            found += rows(scenario, reading, measure, [theirs if reading == pf else ours])
    found += rows("scenario2", "ldm", f"static_better_pct.{pf}", [100])
    for scenario, measure, value in (
        ("outdoor1", "static_share_pct", 100), ("outdoor1", "hidden_with_cluster_pct", 100),
        ("outdoor1", "occlusions_kept_pct", 100), ("outdoor1", "direction_share_pct", 100),
        ("outdoor2", "direction_share_pct", 100), ("outdoor1", "fluctuation_mps", 0.05),
        ("outdoor1", "response_s", 0.5),
    ):
        found += rows(scenario, "ldm", measure, [value])
    return table(found)


@pytest.mark.parametrize("pf", ["circular_buffer_pf_eq17", "circular_buffer_pf_free"])
def test_the_papers_numbers_are_at_no_distance_and_name_the_reading(pf):
    found = outcomes(measures_like_the_paper(pf))
    assert verdicts.distance(found) == (pytest.approx(0, abs=1e-9), pf)
    assert all(o.leans for o in verdicts.of_reading(found, pf))


def test_groups_count_alike_in_the_distance():
    measures = measures_like_the_paper()
    chosen = (measures["scenario"] == "outdoor1") & (measures["measure"] == "response_s")
    measures.loc[chosen, "value"] = 2.0  # z = (2 - 1) / 0.5, one of seven outdoors
    assert verdicts.distance(outcomes(measures))[0] == pytest.approx(math.sqrt(2**2 / 7 / 3))


def test_a_missing_number_gives_no_distance():
    measures = measures_like_the_paper()
    measures = measures[measures["measure"] != "response_s"]
    assert math.isnan(verdicts.distance(outcomes(measures))[0])


def test_the_share_of_a_count_has_the_spread_of_the_ratio():
    # Method 90 % of the baseline in each world: the ratio is certain, however the baseline scatters.
    measures = table(rows("scenario1", "ldm", "case1_voxels", [90, 180, 45])
                     + rows("scenario1", "circular_buffer", "case1_voxels", [100, 200, 50]))
    found = next(o for o in outcomes(measures) if o.claim.key.startswith("size.scenario1.case1"))
    assert (found.mean, found.low, found.high) == pytest.approx((-10, -10, -10))


def test_only_worlds_that_both_methods_have_are_compared():
    measures = table(rows("scenario1", "ldm", "accuracy_pct", [99.0, 98.0])
                     + rows("scenario1", "circular_buffer", "accuracy_pct", [98.9]))
    found = next(o for o in outcomes(measures) if o.claim.key.startswith("order.scenario1.acc"))
    assert (found.n, found.mean) == (1, pytest.approx(0.1))
