"""Figures 6 to 9: the object by its rule, the lines of the paper, the files."""

import numpy as np
import pytest
from matplotlib.colors import to_hex
from record_files import make_record, make_series, write_records

from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.records import load_study
from analysis.data.series import longest_in_map, longest_run, read_series
from analysis.figures.velocity_distribution import distribution_figure
from analysis.figures.velocity_figures import choose_shown, component_figure, error_figure, main

LONG = list(range(0, 40)) + list(range(50, 150))
SHORT = list(range(0, 90))


def records(**changes):
    made = []
    for method in ("ldm", "circular_buffer_pf_eq17"):
        for scenario, dynamic in (("scenario1", True), ("scenario2", False)):
            series = [make_series(4, dynamic, SHORT), make_series(5, dynamic, LONG)]
            for replicate in (2, 3):
                scores = {"static_velocity_error_mps": None} if dynamic else {}
                made.append(
                    make_record(method, replicate, study="table1", scenario=scenario)
                    | {"series": series} | changes
                )  # fmt: skip
                made[-1]["scores"].update(scores)
    return made


@pytest.fixture
def study(tmp_path):
    return load_study(write_records(tmp_path, records()), "table1")


def test_longest_run_of_frames():
    assert longest_run(np.array([3])) == slice(0, 1)
    assert longest_run(np.array([0, 1, 2, 10, 11, 12, 20])) == slice(0, 3)
    assert longest_run(np.array([0, 5, 6, 7])) == slice(1, 4)


def test_the_object_longest_in_the_map_is_shown_for_its_longest_stay(study):
    series = read_series(study.trials["file"][0])
    chosen = longest_in_map(series, dynamic=True)
    assert (chosen.object, chosen.frame[0], chosen.frame[-1]) == (5, 50, 149)
    assert longest_in_map(series, dynamic=False) is None
    shown = choose_shown(study, "scenario1", dynamic=True)
    assert "Dynamic object 5 of scenario1, replicate 2" in shown.rule
    assert "(5.0 s to 14.9 s)" in shown.rule


def test_an_unmatched_frame_is_a_gap(study):
    series = choose_shown(study, "scenario1", dynamic=True).by_method["ldm"]
    unmatched = np.isnan(series.error())
    assert series.frame[unmatched].tolist() == list(range(57, 150, 10))


def styles(axes):
    return {
        line.get_label(): (to_hex(line.get_color()).upper(), line.get_linestyle())
        for line in axes.lines
    }


def test_figure_6_has_the_paper_s_lines(study):
    shown = choose_shown(study, "scenario2", dynamic=False)
    axes = error_figure(shown).axes[0]
    assert styles(axes) == {"[11] with PF": ("#D55E00", ":"), "LDM": ("#000000", "-")}
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("time (s)", "velocity error (m/s)")
    np.testing.assert_array_equal(axes.lines[1].get_ydata(), shown.by_method["ldm"].error())


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_figures_7_to_9_have_the_paper_s_lines(study, axis):
    shown = choose_shown(study, "scenario1", dynamic=True)
    axes = component_figure(shown, axis).axes[0]
    assert styles(axes)["ground truth"] == ("#0072B2", "-")
    assert set(styles(axes)) == {"[11] with PF", "LDM", "ground truth"}
    assert axes.get_ylabel() == f"velocity in {'xyz'[axis]} (m/s)"
    truth = axes.lines[2].get_ydata()
    np.testing.assert_array_equal(truth, shown.by_method["ldm"].truth[:, axis])


def test_distribution_shows_each_seed_and_the_paper_s_values(study):
    static, dynamic = distribution_figure(study).axes
    assert [t.get_text() for t in static.get_xticklabels()] == ["Scenario 1", "Scenario 2"]
    assert static.get_ylabel() == "static velocity error\n(m/s)"
    bars = [path for c in static.collections for path in c.get_paths()]
    heights = {path.vertices[0, 1] for path in bars}
    assert {0.009, 0.019} <= heights
    assert dynamic.get_ylim()[0] == 0


def test_all_files_are_made_and_the_same_again(tmp_path):
    write_records(tmp_path, records())
    folder = tmp_path / "table1" / "figures"
    assert run(main, ["--results", str(tmp_path)]) == 0
    first = {file.name: file.read_bytes() for file in folder.iterdir()}
    names = ["figure6", "figure7", "figure8", "figure9", "velocity_errors"]
    assert sorted(first) == sorted(f"{n}.{end}" for n in names for end in ("pdf", "png", "txt"))
    assert run(main, ["--results", str(tmp_path)]) == 0
    assert {file.name: file.read_bytes() for file in folder.iterdir()} == first


def test_another_method_has_figures_of_its_own(tmp_path):
    write_records(tmp_path, records())
    beside = [r | {"method": "object_ldm", "id": f"{r['scenario']}-object_ldm-{r['replicate']}",
                   "study": "table1+object_ldm"}
              for r in records() if r["method"] == "ldm"]  # fmt: skip
    write_records(tmp_path, beside)
    assert run(main, ["--results", str(tmp_path), "--method", "object_ldm"]) == 0
    folder = tmp_path / "table1" / "figures"
    assert {f.stem for f in folder.glob("*.png")} == {f"figure{k}_object_ldm" for k in (6, 7, 8, 9)}
    assert "black: object_ldm" in (folder / "figure7_object_ldm.txt").read_text()


def test_one_method_alone_is_refused(tmp_path):
    write_records(tmp_path, [r for r in records() if r["method"] == "ldm"])
    with pytest.raises(InputError, match="no replicate of scenario1 has ldm, circular_buffer_pf_eq17"):
        choose_shown(load_study(tmp_path, "table1"), "scenario1", dynamic=True)


def test_a_replicate_without_such_an_object_is_passed_over(tmp_path):
    made = records()
    for record in made:
        if record["replicate"] == 2:
            record["series"] = [make_series(9, False, SHORT)]
    write_records(tmp_path, made)
    shown = choose_shown(load_study(tmp_path, "table1"), "scenario1", dynamic=True)
    assert "object 5 of scenario1, replicate 3" in shown.rule


def test_methods_must_agree_on_the_object(tmp_path):
    made = records()
    made[0]["series"] = made[0]["series"][:1]
    write_records(tmp_path, made)
    with pytest.raises(InputError, match="disagree on when objects were in the map"):
        choose_shown(load_study(tmp_path, "table1"), "scenario1", dynamic=True)


@pytest.mark.parametrize(
    ("series", "message"),
    [
        ([{"object": 1}], "series: not as experiments/RECORD.md says: KeyError"),
        ([make_series(1, True, [1, 2]) | {"time_s": [0.1]}], "not as experiments/RECORD.md says"),
    ],
)
def test_series_of_another_shape_are_refused(tmp_path, series, message):
    write_records(tmp_path, [make_record(series=series, id="x")])
    with pytest.raises(InputError, match=message):
        read_series(tmp_path / "table1" / "records" / "x.json")


def test_a_sweep_is_refused(tmp_path, capsys):
    points = [{"particles.count": n} for n in (10, 20)]
    write_records(tmp_path, [make_record(study="table1", point=p) for p in points])
    assert run(main, ["--results", str(tmp_path)]) == 2
    assert "has 2 points of a sweep" in capsys.readouterr().err
