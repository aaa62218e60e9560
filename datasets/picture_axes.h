#pragma once
/// The frame of a picture: the map's border and a floor with a metre grid (no paper section).
#include "datasets/picture_canvas.h"

namespace datasets {

/// @param border of the map; its floor is its lower face
void draw_axes(const Eigen::AlignedBox3d& border, PictureCanvas& canvas);

}  // namespace datasets
