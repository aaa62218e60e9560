#include "datasets/scenario/scripted_flight.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "datasets/scenario/flight/keep_out.h"
#include "datasets/scenario/timetable.h"

namespace datasets {
namespace {

constexpr double kKnotStep = 1;  // [s]

void check_clearance(const FlightPath& path, const std::vector<KeepOut>& keep_outs,
                     double sample_step, double clearance) {
  for (const KeepOut& keep_out : keep_outs) {
    for (std::size_t sample = 0; sample < keep_out.centre.size(); ++sample) {
      const double t = static_cast<double>(sample) * sample_step;
      const double distance = signed_distance(keep_out, sample, path.position(t)).value;
      if (distance >= clearance) continue;
      char text[120];
      std::snprintf(text, sizeof text,
                    "flight breaks clearance: %.3f m, below %.3f m, at t = %.2f s", distance,
                    clearance, t);
      throw std::runtime_error(text);
    }
  }
}

}  // namespace

FlightPath draw_scripted_flight(const FlightDescription& uav, double duration,
                                const std::vector<KeepOut>& keep_outs, double sample_step,
                                Random& random) {
  Eigen::Vector3d offset;
  for (double& along : offset) along = random.uniform(-uav.spread, uav.spread);
  std::vector<Eigen::Vector3d> control_points;
  const auto segments = static_cast<int>(std::ceil(duration / kKnotStep));
  for (int i = -1; i <= segments + 1; ++i) {  // one knot before the flight, one after
    Eigen::Vector3d drift;
    for (double& along : drift) along = uav.drift * normal_of(random.bits());
    control_points.push_back(place_at(uav.timetable, i * kKnotStep) + offset + drift);
  }
  FlightPath path(std::move(control_points), kKnotStep);
  check_clearance(path, keep_outs, sample_step, uav.clearance);
  return path;
}

}  // namespace datasets
