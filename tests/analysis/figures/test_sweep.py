"""Sweeps: which axis the points stand on, and what figure and table show."""

import csv

import pytest
from record_files import make_record, write_records

from analysis.data.command_line import run
from analysis.data.records import load_study
from analysis.data.scores import SCORES
from analysis.data.sweep_axis import parameter_label, spaced_by_factors, sweep_axis
from analysis.figures.sweep_figure import main, sweep_figure
from analysis.tables.mean_table import mean_table

F1 = [SCORES["f1"]]


def points(*values):
    return {f"p{i}": value for i, value in enumerate(values)}


def test_one_number():
    axis = sweep_axis(points({"particles.count": 1000}, {"particles.count": 200000}))
    assert axis.numeric and axis.logarithmic
    assert axis.label == "particles.count"
    assert axis.place == {"p0": 1000, "p1": 200000}
    assert set(axis.line.values()) == {""}


def test_values_within_a_decade_stay_linear():
    axis = sweep_axis(points({"map.resolution_m": 0.1}, {"map.resolution_m": 0.3}))
    assert not axis.logarithmic and axis.label == "map.resolution (m)"


def test_paired_numbers_stand_on_the_first():
    axis = sweep_axis(points({"map.resolution_m": 0.1, "map.voxels": 48}, {"map.resolution_m": 0.2,
                                                                           "map.voxels": 24}))
    assert axis.label == "map.resolution (m), with voxels"
    assert axis.place == {"p0": 0.1, "p1": 0.2}


def test_crossed_axes_give_lines():
    grid = [{"a.x": x, "a.way": way} for x in (1, 2, 3) for way in ("free", "drop")]
    axis = sweep_axis(points(*grid))
    assert axis.numeric and axis.label == "a.x"
    assert [axis.line[f"p{i}"] for i in range(2)] == ["way=free", "way=drop"]


def test_words_and_truth_values_stand_side_by_side():
    axis = sweep_axis(points({"survival.enabled": True}, {"survival.enabled": False}))
    assert not axis.numeric
    assert list(axis.names.values()) == ["enabled=true", "enabled=false"]


def test_variants_are_named_by_what_is_unusual_in_them():
    usual = {"survival.enabled": True, "prediction.sub_voxel": "residual"}
    changed = [{"survival.enabled": False}, {"prediction.sub_voxel": "none"}]
    axis = sweep_axis(points(usual, *(usual | change for change in changed)))
    assert list(axis.names.values()) == ["usual values", "enabled=false", "sub_voxel=none"]


def test_units_come_from_the_name():
    assert parameter_label("particles.sigma_xy_mps") == "particles.sigma_xy (m/s)"
    assert parameter_label("scenario.sensor.rate_hz") == "scenario.sensor.rate (Hz)"


@pytest.fixture
def swept(tmp_path):
    records = [
        make_record(method, r, study="particles", point={"particles.count": n},
                    scores={"f1": 0.5 + 0.01 * r, "dynamic_velocity_error_mps": 100 / n})
        for method in ("ldm", "mine") for n in (100, 1000, 10000) for r in (1, 2)
    ]  # fmt: skip
    return write_records(tmp_path, records)


def test_line_figure(swept):
    study = load_study(swept, "particles")
    scores = [*F1, SCORES["dynamic_velocity_error_mps"]]
    figure = sweep_figure(study, mean_table(study, scores), scores)
    upper, lower = figure.axes
    assert upper.get_ylabel() == "F1" and lower.get_ylabel() == "dynamic velocity error\n(m/s)"
    assert lower.get_xscale() == lower.get_yscale() == "log" and upper.get_yscale() == "linear"
    assert upper.get_title() == "Scenario 1"
    assert figure._supxlabel.get_text() == "particles.count"
    assert lower.lines[0].get_xdata().tolist() == [100, 1000, 10000]
    assert lower.lines[0].get_ydata().tolist() == pytest.approx([1, 0.1, 0.01])
    labels = [text.get_text() for text in figure.legends[0].get_texts()]
    assert labels == ["ldm", "mine"]


def test_dot_figure_of_variants(tmp_path):
    records = [make_record(m, r, study="ablation") for m in ("ldm", "no_birth") for r in (1, 2)]
    study = load_study(write_records(tmp_path, records), "ablation")
    axes = sweep_figure(study, mean_table(study, F1), F1).axes[0]
    assert [t.get_text() for t in axes.get_yticklabels()] == ["ldm", "no_birth"]
    dots = [line for line in axes.lines if line.get_marker() == "o"]
    assert [(dot.get_xdata()[0], dot.get_ydata()[0]) for dot in dots] == [(0.79, 0), (0.79, 1)]
    assert axes.get_xlabel() == "F1"


def test_dot_figure_of_words(tmp_path):
    records = [
        make_record(m, 1, study="words", point={"sensor_model.no_returns": way})
        for m in ("ldm", "octomap") for way in ("free", "drop")
    ]  # fmt: skip
    study = load_study(write_records(tmp_path, records), "words")
    figure = sweep_figure(study, mean_table(study, F1), F1)
    names = [t.get_text() for t in figure.axes[0].get_yticklabels()]
    assert sorted(names) == ["no_returns=drop", "no_returns=free"]
    assert len(figure.legends[0].get_texts()) == 2


def test_the_script_writes_figure_and_table(swept, capsys):
    assert run(main, ["--results", str(swept), "--study", "particles", "--scores", "f1"]) == 0
    folder = swept / "particles"
    assert (folder / "figures" / "particles.png").exists()
    rows = list(csv.DictReader((folder / "tables" / "particles.csv").open()))
    assert len(rows) == 6
    assert rows[0]["particles.count"] == "100" and float(rows[0]["mean"]) == pytest.approx(0.515)
    assert "particles.count=10000" in (folder / "tables" / "particles.txt").read_text()
    assert "f1" not in capsys.readouterr().err


def test_no_trial_with_the_score(swept, capsys):
    arguments = ["--results", str(swept), "--study", "particles", "--scores", "brier"]
    for file in (swept / "particles" / "records").iterdir():
        file.write_text(file.read_text().replace('"brier": 0.01', '"brier": null'))
    assert run(main, arguments) == 2
    assert "no trial has brier" in capsys.readouterr().err


@pytest.mark.parametrize(("values", "by_factors"), [
    ([5000, 10000, 20000], True), ([1, 2, 4, 8], True), ([0.1, 0.158, 0.251], True),
    ([5000, 10000, 15000], False), ([0.1, 0.15, 0.2], False), ([1, 1.1, 1.21], False),
    ([0, 1, 2], False), ([1, 2], False),
])  # fmt: skip
def test_values_spaced_by_factors(values, by_factors):
    assert spaced_by_factors(values) == by_factors


@pytest.fixture
def crossed(tmp_path):
    """Particles over a logarithmic axis, for two speeds, listed from above."""
    records = [
        make_record("ldm", r, study="crossed", id=f"scenario1.ldm.p{k + 1:02d}.s{r:03d}",
                    point={"particles.count": n, "scenario.speed_mps": speed},
                    scores={"f1": 0.5 + 0.01 * r})
        for k, (n, speed) in enumerate((n, s) for n in (20000, 10000, 5000) for s in (10, 2))
        for r in (1, 2)
    ]  # fmt: skip
    return write_records(tmp_path, records)


def test_a_logarithmic_axis_is_drawn_as_one(crossed):
    study = load_study(crossed, "crossed")
    axes = sweep_figure(study, mean_table(study, F1), F1).axes[0]
    assert axes.get_xscale() == "log"
    assert axes.get_xticks().tolist() == [5000, 10000, 20000]
    assert [label.get_text() for label in axes.get_xticklabels()] == ["5000", "10000", "20000"]


def test_the_table_lists_points_by_their_numbers(crossed, capsys):
    assert run(main, ["--results", str(crossed), "--study", "crossed", "--scores", "f1"]) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if "particles.count=" in line]
    shown = [(line.split("speed_mps=")[1].split()[0], line.split("count=")[1].split(",")[0]) for line in lines]
    assert shown == [(s, n) for s in ("2", "10") for n in ("5000", "10000", "20000")]


def test_the_hundredth_point_follows_the_ninety_ninth(tmp_path):
    records = [make_record("ldm", 1, id=f"scenario1.ldm.p{k:02d}.s001", point={"mode": f"m{k}"})
               for k in range(1, 121)]
    study = load_study(write_records(tmp_path, records), "table1")
    assert list(study.points) == [f"mode=m{k}" for k in range(1, 121)]
