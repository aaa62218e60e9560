#pragma once
/// Exact distances to the obstacles' shapes: what judges a flight (closed loop).
#include "datasets/frame.h"

namespace experiments {

/// Of world point p from the surface of the solid; negative inside [m].
double signed_distance(const datasets::Solid& solid, const Eigen::Vector3d& p);

/// From the nearest of an object's solids [m].
double signed_distance(const datasets::ObjectState& object, const Eigen::Vector3d& p);

}  // namespace experiments
