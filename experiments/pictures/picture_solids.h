#pragma once
/// What of a picture does not depend on where the camera stands: all but words (no paper section).
#include "experiments/pictures/picture_canvas.h"

namespace experiments {

inline constexpr Colour kArrowColour{205, 0, 0}, kPointColour{20, 20, 20},
    kOutsideColour{185, 185, 185};  ///< of points out of the map

/// A quadrotor, 0.8 m across for scale 1.
void draw_uav(const ldm::Pose& T_world_uav, double scale, PictureCanvas& canvas);

/// Grid, cubes with their shadows, points, arrows, paths and UAV, the last three larger than life
/// in a large map.
void draw_solids(const Picture& picture, PictureCanvas& canvas);

}  // namespace experiments
