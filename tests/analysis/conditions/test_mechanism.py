"""Figures of mechanisms: the walker's cluster, right and wrong voxels, and files that are not there."""

import struct

import numpy as np
import pandas as pd
import pytest

from analysis.conditions.mechanism import clusters_of, main, read_ply, within
from analysis.data.command_line import run
from analysis.data.errors import InputError

TRUTH = pd.DataFrame({"frame": [0, 1], "id": 1, "time_s": [0.0, 0.1], "x_m": [1.0, 1.1], "y_m": 0.0, "z_m": 1.0,
                      "vx_mps": 1.0, "sx_m": 0.4, "sy_m": 0.4, "sz_m": 1.0})  # fmt: skip
CLUSTERS = pd.DataFrame({"frame": [0, 0, 1], "time_s": [0.0, 0.0, 0.1], "x_m": [1.25, 0.9, 3.0], "y_m": 0.0,
                         "vx_mps": [9.0, 0.5, 0.6], "voxels": [5, 60, 70]})  # fmt: skip


def ply(points):
    head = ("ply\nformat binary_little_endian 1.0\n" f"element vertex {len(points)}\n"
            "property float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty int track\n"
            "end_header\n")  # fmt: skip
    return head.encode() + b"".join(struct.pack("<fffBi", *point, 255, 7) for point in points)


def test_the_nearest_cluster_is_the_walkers_and_a_far_one_is_nobodys():
    found = clusters_of(TRUTH, CLUSTERS)
    assert found["time_s"].tolist() == [0.0] and found["voxels"].tolist() == [60]
    assert found["offset"].tolist() == pytest.approx([-0.1])


def test_a_voxel_is_right_up_to_a_voxel_beyond_the_box():
    box = TRUTH[TRUTH["frame"] == 0]
    voxels = np.array([[1.34, 0, 1], [1.36, 0, 1], [1, 0, 1.64], [1, 0, 1.66]])
    assert within(voxels, box).tolist() == [True, False, True, False]


def test_positions_are_read_and_a_cut_file_is_refused(tmp_path):
    file = tmp_path / "map.ply"
    file.write_bytes(ply([(1, 2, 3), (4, 5, 6)]))
    assert read_ply(file).tolist() == [[1, 2, 3], [4, 5, 6]]
    file.write_bytes(ply([(1, 2, 3), (4, 5, 6)])[:-1])
    with pytest.raises(InputError, match="map.ply: is not a map"):
        read_ply(file)


def test_both_figures_are_drawn_and_a_missing_run_is_named(tmp_path, capsys):
    folder = tmp_path / "conditions" / "mechanism"
    arguments = ["--results", str(tmp_path), "--readings", "a", "b", "--frame", "1"]
    for name in ("a", "b"):
        assert run(main, arguments) == 2
        assert f"{'outdoor1.truth.csv' if name == 'a' else 'b.outdoor1'}" in capsys.readouterr().err
        (folder / f"{name}.scenario1" / "maps").mkdir(parents=True)
        (folder / f"{name}.outdoor1").mkdir()
        for world in ("outdoor1", "scenario1"):
            TRUTH.to_csv(folder / f"{world}.truth.csv")
        CLUSTERS.to_csv(folder / f"{name}.outdoor1" / "clusters.csv")
        frames = {"frame": [1], "uav_x_m": 0, "uav_y_m": 0, "map_x_m": -2, "map_y_m": -2, "map_size_x_m": 4,
                  "map_size_y_m": 4}  # fmt: skip
        pd.DataFrame(frames).to_csv(folder / f"{name}.scenario1" / "frames.csv")
        (folder / f"{name}.scenario1" / "maps" / "frame_000001.occupied.ply").write_bytes(ply([(1.1, 0, 1), (0, 0, 0)]))
    assert run(main, arguments) == 0
    for name in ("swing", "behind"):
        assert (tmp_path / "conditions" / "figures" / f"{name}.png").stat().st_size > 10000
