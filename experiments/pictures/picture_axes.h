#pragma once
/// The frame of a picture: the map's border and a floor with a metre grid (no paper section).
#include "experiments/pictures/picture_canvas.h"

namespace experiments {

/// The border's edges, and lines on its lower face.
void draw_grid(const Eigen::AlignedBox3d& border, PictureCanvas& canvas);

/// What the lines stand for: coordinates beside the border [m].
void draw_numbers(const Eigen::AlignedBox3d& border, PictureCanvas& canvas);

}  // namespace experiments
