"""analysis/figures/gallery.py: which picture lands where."""

from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from analysis.data.errors import InputError
from analysis.figures import gallery

WHITE, BLUE = (1.0, 1.0, 1.0), (0.0, 0.0, 1.0)


def write_picture(file: Path, colour: tuple[float, float, float]) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    matplotlib.image.imsave(file, np.full((360, 640, 3), colour))


def test_a_picture_is_reduced_by_averaging(tmp_path: Path) -> None:
    stripes = np.zeros((4, 6, 3))
    stripes[::2] = 1
    matplotlib.image.imsave(tmp_path / "a.png", stripes)
    small = gallery.reduced(tmp_path / "a.png")
    assert small.shape == (2, 3, 3)
    assert small == pytest.approx(0.5)


def test_rows_are_scenarios_and_columns_methods(tmp_path: Path) -> None:
    write_picture(tmp_path / "gallery" / "a.ldm.png", BLUE)
    write_picture(tmp_path / "gallery" / "b.circular_buffer.png", BLUE)
    gallery.main(["--results", str(tmp_path)])
    sheet = matplotlib.image.imread(tmp_path / "gallery" / "sheet.png")[..., :3]
    height, width = sheet.shape[:2]
    is_blue = np.abs(sheet - BLUE).max(axis=2) < 0.1
    quarters = [
        bool(is_blue[rows, columns].mean() > 0.5)
        for rows in (slice(height // 2), slice(height // 2, None))
        for columns in (slice(width // 2), slice(width // 2, None))
    ]
    # circular_buffer is left of ldm; two of the four were not drawn.
    assert quarters == [False, True, True, False]


def test_methods_can_be_chosen(tmp_path: Path) -> None:
    write_picture(tmp_path / "gallery" / "a.ldm.png", BLUE)
    write_picture(tmp_path / "gallery" / "a.octomap.png", WHITE)
    gallery.main(["--results", str(tmp_path), "--methods", "octomap"])
    sheet = matplotlib.image.imread(tmp_path / "gallery" / "sheet.png")[..., :3]
    assert not (np.abs(sheet - BLUE).max(axis=2) < 0.1).any()


def test_no_pictures_are_an_error(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="gallery: no picture"):
        gallery.main(["--results", str(tmp_path)])
