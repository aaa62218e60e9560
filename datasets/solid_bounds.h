#pragma once
/// Bounding boxes of the solids that obstacles are made of (paper Sec. 4.1.1).
#include "datasets/frame.h"

namespace datasets {

/// Half the edges of the smallest box along the world's axes that holds the solid [m].
Eigen::Vector3d half_extent(const Solid& solid);

}  // namespace datasets
