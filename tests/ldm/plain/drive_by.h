#pragma once
/// A scene in which the plain and the fast map see the same.
#include "tests/reference/scan_of_boxes.h"

namespace ldm::plain {

/// One box drives by at 1 m/s, another stands. No face lies on a wall between voxels
/// and no ray to a voxel's centre runs through an edge: float and double agree on what is hit.
inline Scan drive_by(int frame) {
  const double x = -1.77 + 0.1 * frame;
  return reference::scan_of_boxes(
      0.1 * frame, {0.02137, 0.03071, 0.01193},
      {{{x, 1.27, -0.4}, {x + 0.5, 1.72, 0.4}}, {{-0.33, -1.92, -0.4}, {0.32, -1.55, 0.4}}}, 128);
}

}  // namespace ldm::plain
