"""Figure 5 from the text files beside recorded logs."""

import pytest
from matplotlib.colors import to_hex

from analysis.data.command_line import run
from analysis.figures.figure5 import main, read_world, worlds_figure

TRUTH = """\
frame,time_s,id,dynamic,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,sx_m,sy_m,sz_m,solids
0,0,1,0,5,5,1,0,0,0,0,0,0,1,2,2,1
0,0,2,1,0,0,1,1,0,0,0,0,0,0.5,0.5,2,1
1,0.1,1,0,5,5,1,0,0,0,0,0,0,1,2,2,1
1,0.1,2,1,3,4,1,1,0,0,0,0,0,0.5,0.5,2,1
2,0.2,1,0,5,5,1,0,0,0,0,0,0,1,2,2,1
2,0.2,2,1,1,1,1,1,0,0,0,0,0,0.5,0.5,2,1
"""
FRAMES = """\
frame,time_s,x_m,y_m,z_m,qw,qx,qy,qz,objects
0,0,-2,-2,1.5,1,0,0,0,2
1,0.1,-1,-2,1.5,1,0,0,0,2
2,0.2,0,-2,1.5,1,0,0,0,2
"""


@pytest.fixture
def worlds(tmp_path):
    folder = tmp_path / "worlds"
    folder.mkdir()
    for name in ("scenario1", "scenario2"):
        (folder / f"{name}.truth.csv").write_text(TRUTH)
        (folder / f"{name}.frames.csv").write_text(FRAMES)
    return folder


def test_obstacles_paths_and_uav(worlds):
    world = read_world(worlds / "scenario1.truth.csv")
    axes = worlds_figure({"scenario1": world}).axes[0]
    boxes = [p for p in axes.patches if hasattr(p, "get_width")]
    assert [(*box.get_xy(), box.get_width(), box.get_height()) for box in boxes] == [
        (4.5, 4.0, 1.0, 2.0),
        (-0.25, -0.25, 0.5, 0.5),
    ]
    assert [to_hex(box.get_facecolor()).upper() for box in boxes] == ["#0072B2", "#009E73"]
    arrow = axes.texts[0]
    assert tuple(arrow.xyann) == (0, 0) and tuple(arrow.xy) == (3, 4)
    assert axes.lines[1].get_xdata().tolist() == [-2, -1, 0]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x (m)", "y (m)")


def test_a_panel_for_each_scenario(worlds):
    assert run(main, ["--results", str(worlds.parent)]) == 0
    assert (worlds / "figures" / "figure5.png").exists()
    assert "scenario1.truth.csv, scenario2.truth.csv" in (
        worlds / "figures" / "figure5.txt"
    ).read_text()


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("scenario1.truth.csv", "", "scenario1.truth.csv: unreadable"),
        ("scenario1.truth.csv", TRUTH.replace("sx_m", "sx"), "column sx_m is missing"),
        ("scenario1.truth.csv", TRUTH.splitlines()[0], "scenario1.truth.csv: no row"),
        ("scenario1.frames.csv", FRAMES[:-35] + "\n", "frames.csv: a value is missing"),
        ("scenario1.frames.csv", None, "scenario1.frames.csv: unreadable"),
    ],
)
def test_broken_files_are_named(worlds, capsys, name, text, message):
    if text is None:
        (worlds / name).unlink()
    else:
        (worlds / name).write_text(text)
    assert run(main, ["--results", str(worlds.parent)]) == 2
    assert message in capsys.readouterr().err


def test_no_worlds(tmp_path, capsys):
    assert run(main, ["--results", str(tmp_path)]) == 2
    assert "holds no *.truth.csv" in capsys.readouterr().err
