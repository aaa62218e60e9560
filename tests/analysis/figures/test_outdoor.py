"""Figures 11 to 16 and the table of the flight outdoors, from records and recordings made by hand."""

import matplotlib.image
import numpy as np
import pytest
from record_files import make_record, make_series, write_records

from analysis.data.command_line import run
from analysis.data.errors import InputError
from analysis.data.records import load_study, record_files
from analysis.data.series import read_series
from analysis.data.series_scores import largest_static_error
from analysis.figures.figure_style import COLUMN_WIDTH, legend_above, new_figure
from analysis.figures.flight_figures import main as draw_flight, pictures_of, sequence_figure
from analysis.figures.outdoor_figures import draw, hidden_spans, main, person_figure
from analysis.tables.outdoor_table import means, measures, write_table

FRAMES = list(range(100))
HIDDEN = {40, 41, 42, 99}
TRUTH = "frame,time_s,id,dynamic,x_m,y_m,sx_m,sy_m\n0,0,0,0,1,1,0.5,0.3\n0,0,1,1,0,1,0.5,0.3\n1,0.1,0,0,1,1,0.5,0.3\n1,0.1,1,1,2,1,0.5,0.3\n"
UAV = "frame,time_s,x_m,y_m\n0,0,0,0\n1,0.1,0,0.1\n"


def persons(noise=0.005):
    """One stands, two walk; the last is hidden for a while."""
    series = [make_series(k, k > 0, FRAMES, noise) for k in range(3)]
    for one in series:
        one["visible"] = [one["object"] != 2 or frame not in HIDDEN for frame in FRAMES]
        one["track"] = [one["object"]] * len(FRAMES)
    return series


def records(methods=("ldm", "no_prediction")):
    return [
        make_record(method, seed, study="outdoor", scenario=scenario, frames=100, series=persons(),
                    scores={"tracks_per_stay": 1.0 + (method != "ldm") * seed / 10,
                            "occlusions_kept_pct": 100.0, "hidden_with_cluster_pct": 80.0 + seed})
        for method in methods for scenario in ("outdoor1", "outdoor2") for seed in (1, 2, 3)
    ]  # fmt: skip


@pytest.fixture
def study(tmp_path):
    return load_study(write_records(tmp_path, records()), "outdoor")


@pytest.fixture
def flight(tmp_path):
    folder = tmp_path / "flight"
    folder.mkdir()
    for scenario in ("outdoor1", "outdoor2"):
        (folder / f"{scenario}.truth.csv").write_text(TRUTH)
        (folder / f"{scenario}.frames.csv").write_text(UAV)
        for frame in (9, 110, 60):
            matplotlib.image.imsave(folder / f"{scenario}.frame{frame}.png", np.zeros((720, 1280, 3)))
    return folder


def test_times_in_hiding_are_spans_of_frames(study):
    third = read_series(study.trials["file"][0])[2]
    assert hidden_spans(third) == [(39.5, 42.5), (98.5, 99.5)]
    assert hidden_spans(read_series(study.trials["file"][0])[1]) == []


def test_records_without_visibility_have_no_hiding(tmp_path):
    record = make_record(series=[make_series(1, True, FRAMES)])
    results = write_records(tmp_path, [record])
    (file,) = record_files(results / "table1" / "records")
    assert not read_series(file)[0].hidden.any()


def test_a_person_has_a_panel_for_each_direction(study):
    standing, _, hidden = read_series(study.trials["file"][0])
    axes = person_figure(hidden).axes
    assert [a.get_ylabel() for a in axes] == ["x (m/s)", "y (m/s)", "z (m/s)"]
    assert axes[-1].get_xlabel() == "frame" and axes[0].get_xlim() == (0, 99)
    assert axes[1].get_legend_handles_labels()[1] == ["ground truth", "LDM", "hidden"]
    labels = person_figure(standing).axes[0].get_legend_handles_labels()[1]
    assert labels == ["ground truth", "LDM", "paper: 0.05 m/s"]


def test_measures_of_the_claims(study):
    found = {name: means(study, measure)["ldm"].mean for name, measure in measures().items()}
    assert found["hidden_matched"] == 82 and found["kept"] == 100 and found["tracks"] == 1
    assert found["hidden_frames"] == 2  # 3 frames and 1
    assert found["static_share"] == 100 and found["direction"] == 100
    assert 0.01 < found["static_largest"] < 0.05


def test_the_largest_error_leaves_out_the_beginning():
    from analysis.data.series import _object

    entry = make_series(1, False, FRAMES, noise=0)
    entry["velocity_mps"] = [[0.0, 0.0, 0.0] for _ in FRAMES]
    entry["velocity_mps"][14] = [9.0, 0.0, 0.0]  # before 1.5 s
    entry["velocity_mps"][20] = [0.1, 0.0, -0.2]
    entry["velocity_mps"][30] = None
    assert largest_static_error([_object(entry, "file")]) == pytest.approx(0.2)
    assert np.isnan(largest_static_error([_object(make_series(1, True, FRAMES), "file")]))


def test_the_command_writes_figures_and_table(tmp_path, study, capsys):
    assert run(main, ["--results", str(tmp_path)]) == 0
    printed = capsys.readouterr().out
    assert "no_prediction" in printed and "1.20 [1.10, 1.27]" in printed
    folder = tmp_path / "outdoor"
    assert {file.stem for file in (folder / "figures").glob("*.png")} == {
        "figure14", "figure15", "figure16"}  # fmt: skip
    caption = (folder / "figures" / "figure16.txt").read_text()
    assert "outdoor1, replicate 1" in caption and "3 seeds of 100 frames, commit" in caption
    assert (folder / "tables" / "outdoor.csv").read_text().count("\n") == 1 + 2 * len(measures())


def test_another_method_has_figures_of_its_own(tmp_path):
    write_records(tmp_path, records(("ldm", "object_ldm")))
    assert run(main, ["--results", str(tmp_path), "--method", "object_ldm"]) == 0
    assert {file.stem for file in (tmp_path / "outdoor" / "figures").glob("*.png")} == {
        f"figure{k}_object_ldm" for k in (14, 15, 16)}  # fmt: skip
    assert run(main, ["--results", str(tmp_path), "--method", "octomap"]) == 2


def test_same_records_same_bytes(study, tmp_path):
    for name in ("a", "b"):
        draw(study, tmp_path / name)
    for file in (tmp_path / "a").iterdir():
        assert file.read_bytes() == (tmp_path / "b" / file.name).read_bytes()


def test_records_of_another_study_are_refused(tmp_path):
    made = records()
    for record in made:
        record["series"] = record["series"][:2]
    study = load_study(write_records(tmp_path, made), "outdoor")
    with pytest.raises(InputError, match="series of 2 objects, not 3"):
        draw(study, tmp_path / "figures")
    other = load_study(write_records(tmp_path / "o", records(["current_scan"])), "outdoor")
    with pytest.raises(InputError, match="no trial of ldm in outdoor1"):
        draw(other, tmp_path / "figures")


def test_records_without_identity_leave_its_cells_empty(tmp_path):
    made = records()
    for record in made:
        for score in ("tracks_per_stay", "occlusions_kept_pct", "hidden_with_cluster_pct"):
            del record["scores"][score]
    text = write_table(load_study(write_records(tmp_path, made), "outdoor"))
    row = next(line for line in text.splitlines() if line.startswith("hidden person: has"))
    assert row.split()[-2:] == ["-", "-"]


def test_pictures_stand_in_the_order_of_time(flight):
    assert list(pictures_of(flight, "outdoor1")) == [9, 60, 110]
    panels = sequence_figure(pictures_of(flight, "outdoor1")).axes
    assert [axes.get_title() for axes in panels] == ["1: frame 9", "2: frame 60", "3: frame 110", ""]


def test_the_flight_command_writes_figures_11_to_13(tmp_path, flight, capsys):
    assert run(draw_flight, ["--results", str(tmp_path)]) == 0
    assert capsys.readouterr().out.count("figure1") == 6
    assert "outdoor2.frame110.png" in (flight / "figures" / "figure13.txt").read_text()


def test_a_flight_without_pictures_is_refused(tmp_path, flight, capsys):
    for file in flight.glob("outdoor2.frame*.png"):
        file.unlink()
    assert run(draw_flight, ["--results", str(tmp_path)]) == 2
    assert "holds no outdoor2.frameN.png; `make figures` draws them" in capsys.readouterr().err


def test_a_legend_is_never_wider_than_its_figure():
    figure = new_figure(COLUMN_WIDTH, 2)
    axes = figure.subplots()
    for name in ("a name that takes half of the width", "another one", "a third"):
        axes.plot([0, 1], label=name)
    legend_above(figure, axes, columns=3)
    (legend,) = figure.legends
    assert legend.get_window_extent(figure.canvas.get_renderer()).width <= figure.bbox.width
