"""`ldm view` on a virtual screen: what it shows, and what its keys do."""

from __future__ import annotations

import os
import subprocess
import time
from pathlib import Path
from typing import Iterator

import pytest

PROGRAM = str(Path(os.environ["LDM"]).resolve())
WIDTH, HEIGHT = 1400, 900
START = 20.0
"""Longest time [s] until something that was asked for shows."""
RED, BLUE_SKY = (205, 0, 0), (86, 180, 233)


@pytest.fixture(scope="module")
def screen() -> Iterator[str]:
    """The name of a virtual screen."""
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", f"{WIDTH}x{HEIGHT}x24"],
        pass_fds=[write],
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    with os.fdopen(read) as pipe:
        name = ":" + pipe.readline().strip()
    yield name
    server.terminate()
    server.wait()


@pytest.fixture()
def viewer(screen: str) -> Iterator[subprocess.Popen[str]]:
    """`ldm view`, paused at the first frame."""
    command = [PROGRAM, "view", "ldm", "scenario3", "--paused", "--set", "particles.count=5000"]
    process = subprocess.Popen(
        command, env={**os.environ, "DISPLAY": screen}, stderr=subprocess.PIPE, text=True
    )
    yield process
    process.kill()
    process.wait()


def shot(screen: str) -> bytes:
    """The screen as red, green and blue."""
    source = ["-f", "x11grab", "-video_size", f"{WIDTH}x{HEIGHT}", "-i", screen]
    target = ["-frames:v", "1", "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    command = ["ffmpeg", "-loglevel", "error", *source, *target]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


def pixels_near(picture: bytes, colour: tuple[int, int, int]) -> int:
    """How many pixels have about this colour."""
    channels = [picture[i::3] for i in range(3)]
    return sum(
        all(abs(value - wanted) < 60 for value, wanted in zip(pixel, colour))
        for pixel in zip(*channels)
    )


def heading(picture: bytes) -> bytes:
    """The lines at the upper left, which tell the frame."""
    return b"".join(picture[3 * WIDTH * row : 3 * (WIDTH * row + 360)] for row in range(10, 110))


def wait_for_change(screen: str, before: bytes) -> bytes:
    """The screen as soon as its heading is another than `before`, and stays for a moment."""
    end = time.monotonic() + START
    last = b""
    while time.monotonic() < end:
        now = heading(shot(screen))
        if now != before and now == last:
            return now
        last = now
        time.sleep(0.2)
    raise AssertionError("the window did not change")


def press(screen: str, key: str) -> None:
    environment = {**os.environ, "DISPLAY": screen}
    window = subprocess.run(
        ["xdotool", "search", "--sync", "--onlyvisible", "--name", "ldm view"],
        env=environment,
        check=True,
        stdout=subprocess.PIPE,
        text=True,
    ).stdout.split()[0]
    subprocess.run(["xdotool", "windowfocus", window], env=environment, check=False)
    subprocess.run(["xdotool", "key", key], env=environment, check=True)


def test_shows_the_map_and_obeys_the_keys(screen: str, viewer: subprocess.Popen[str]) -> None:
    first = wait_for_change(screen, heading(shot(screen)))
    time.sleep(1)
    assert heading(shot(screen)) == first, "it is paused"
    picture = shot(screen)
    assert pixels_near(picture, (255, 255, 255)) > WIDTH * HEIGHT // 3, "a light background"
    assert pixels_near(picture, BLUE_SKY) > 500, "cubes of the first cluster's colour"

    press(screen, "n")
    second = wait_for_change(screen, first)
    press(screen, "Right")
    third = wait_for_change(screen, second)
    time.sleep(1)
    assert heading(shot(screen)) == third, "still paused"

    press(screen, "space")
    seen = {heading(shot(screen)) for _ in range(10)}
    assert len(seen) > 2, "it goes on"

    press(screen, "q")
    assert viewer.wait(START) == 0
    assert viewer.stderr is not None and viewer.stderr.read() == ""
