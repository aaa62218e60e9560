#pragma once
/// Distance of the UAV from the moving cylinders its path stays out of (paper Sec. 4.1.1).
#include <cstddef>

#include "datasets/scenario/flight/flight_path.h"

namespace datasets {

struct SignedDistance {
  double value = 0;          ///< [m], negative inside
  Eigen::Vector3d gradient;  ///< of the value with respect to the point: a unit vector
};

/// Distance of p (world [m]) from the surface of `keep_out` at one sample < keep_out.centre.size().
/// On the axis, where every horizontal direction leads out equally, the gradient is +x.
SignedDistance signed_distance(const KeepOut& keep_out, std::size_t sample,
                               const Eigen::Vector3d& p);

/// Number of samples of `task`: one at time 0 and one after every sample_step up to the duration.
std::size_t sample_count(const FlightTask& task);

}  // namespace datasets
