"""All pictures of `make gallery` on one sheet: a row for each scenario, a column for each method."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Sequence

import matplotlib.image
import numpy as np

from analysis.data import command_line
from analysis.data.errors import InputError
from analysis.figures.figure_style import new_figure, write_picture

REDUCTION = 2
"""How many times smaller a picture is on the sheet."""
_INCH = 100
"""Pixels of the sheet an inch."""


def pictures(folder: Path) -> dict[tuple[str, str], Path]:
    """Scenario and method of each SCENARIO.METHOD.png of `folder`."""
    found = {}
    for file in sorted(folder.glob("*.*.png")):
        scenario, method = file.stem.split(".", 1)
        found[scenario, method] = file
    if not found:
        raise InputError(f"{folder}: no picture: `make gallery` draws them")
    return found


def reduced(file: Path) -> np.ndarray:
    """The picture, smaller: each pixel the mean of a square."""
    image = matplotlib.image.imread(file)[..., :3]
    height, width = (size // REDUCTION * REDUCTION for size in image.shape[:2])
    squares = image[:height, :width].reshape(
        height // REDUCTION, REDUCTION, width // REDUCTION, REDUCTION, 3
    )
    return squares.mean(axis=(1, 3))


def draw(files: dict[tuple[str, str], Path], methods: list[str], sheet: Path) -> None:
    """Write `sheet` as PNG; a picture that is missing leaves its place blank."""
    scenarios = sorted({scenario for scenario, _ in files})
    height, width = reduced(next(iter(files.values()))).shape[:2]
    figure = new_figure(len(methods) * width / _INCH + 0.4, len(scenarios) * height / _INCH + 0.4)
    panels = figure.subplots(len(scenarios), len(methods), squeeze=False)
    for row, scenario in enumerate(scenarios):
        for column, method in enumerate(methods):
            axes = panels[row, column]
            axes.set(xticks=[], yticks=[])
            axes.spines[:].set_visible(False)
            if (scenario, method) in files:
                axes.imshow(reduced(files[scenario, method]))
            if row == 0:
                axes.set_title(method, fontsize=14)
            if column == 0:
                axes.set_ylabel(scenario, fontsize=14)
    write_picture(figure, sheet, dpi=_INCH)


def main(argv: Sequence[str] | None = None) -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", type=Path, default=Path("results"), metavar="DIR")
    parser.add_argument(
        "--methods", type=command_line.name_list, metavar="NAMES", help="default: all"
    )
    arguments = parser.parse_args(argv)
    files = pictures(arguments.results / "gallery")
    methods = arguments.methods or sorted({method for _, method in files})
    sheet = arguments.results / "gallery" / "sheet.png"
    draw(files, methods, sheet)
    print(sheet)


if __name__ == "__main__":
    raise SystemExit(command_line.run(main))
