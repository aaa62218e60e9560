"""`ldm render --video` with the real ffmpeg."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

PROGRAM = str(Path(os.environ["LDM"]).resolve())


def test_a_film_has_the_length_of_its_frames(tmp_path: Path) -> None:
    film = tmp_path / "film.mp4"
    frames = ["--from", "3", "--to", "12"]
    subprocess.run(
        [PROGRAM, "render", "current_scan", "scenario1", "--video", str(film), *frames], check=True
    )
    assert [file.name for file in tmp_path.iterdir()] == ["film.mp4"]
    probe = ["ffprobe", "-v", "error", "-show_streams", "-of", "json", str(film)]
    answer = subprocess.run(probe, check=True, stdout=subprocess.PIPE).stdout
    stream = json.loads(answer)["streams"][0]
    assert (stream["width"], stream["height"]) == (1280, 720)
    assert stream["codec_name"] == "h264"
    assert stream["r_frame_rate"] == "10/1"  # that of the LiDAR
    assert stream["nb_frames"] == "10"
    assert float(stream["duration"]) == 1.0


def test_what_ffmpeg_cannot_write_fails_in_one_line(tmp_path: Path) -> None:
    command = [PROGRAM, "render", "current_scan", "scenario1", "--video", "none/film.mp4"]
    result = subprocess.run(command, cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    assert result.returncode == 2
    assert result.stderr == (
        "ldm: none/film.mp4: cannot be written (No such file or directory): "
        "allowed: a file in an existing folder\n"
    )


def test_a_flight_is_filmed(tmp_path: Path) -> None:
    film = tmp_path / "film.mp4"
    command = [PROGRAM, "fly", "blind", "moving10_10", "--seed", "5", "-o", str(tmp_path / "out")]
    subprocess.run([*command, "--video", str(film)], check=True)
    probe = ["ffprobe", "-v", "error", "-show_streams", "-of", "json", str(film)]
    answer = subprocess.run(probe, check=True, stdout=subprocess.PIPE).stdout
    stream = json.loads(answer)["streams"][0]
    assert (stream["codec_name"], stream["r_frame_rate"]) == ("h264", "10/1")
    rows = (tmp_path / "out" / "flight.csv").read_text().splitlines()
    ends = float(rows[-1].partition(",")[0])
    # A picture for each scan until the end, which is shown for a second more.
    assert int(stream["nb_frames"]) == int(ends * 10 - 1e-9) + 1 + 10
