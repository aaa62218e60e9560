#include "datasets/scenario/flight/flight_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "datasets/scenario/flight/bspline.h"

namespace datasets {
namespace {

constexpr double kGravity = 9.81;       // [m/s^2]
constexpr double kTrailerLength = 0.5;  // [m]: the heading follows a turn this much later
constexpr int kHeadingsPerSegment = 16;

/// Angle between a trailer's drawbar and the motion of its tip after the tip went straight on by
/// `distance` [m], from `angle` in [-pi, pi]: the tractrix, in closed form.
double towed(double angle, double distance) {
  return 2 * std::atan(std::tan(angle / 2) * std::exp(-distance / kTrailerLength));
}

}  // namespace

FlightPath::FlightPath(std::vector<Eigen::Vector3d> control_points, double knot_step)
    : control_points_(std::move(control_points)), knot_step_(knot_step) {
  if (control_points_.size() < 4) {
    throw ldm::InvalidInput("FlightPath: control_points: " +
                            std::to_string(control_points_.size()) + " points, at least 4 needed");
  }
  if (!(knot_step_ > 0) || !std::isfinite(knot_step_)) {
    throw ldm::InvalidInput("FlightPath: knot_step: " + std::to_string(knot_step_) +
                            " s, must be above 0");
  }
  tow_headings();
}

Eigen::Vector3d FlightPath::position(double t) const {
  return curve_at(control_points_, knot_step_, t);
}

Eigen::Vector3d FlightPath::velocity(double t) const {
  return curve_at(control_points_, knot_step_, t, Derivative::kVelocity);
}

Eigen::Vector3d FlightPath::acceleration(double t) const {
  return curve_at(control_points_, knot_step_, t, Derivative::kAcceleration);
}

/// The direction of motion is undefined in hover and jumps at a reversal. That of a trailer towed
/// by the UAV is neither: it turns towards the motion as the UAV advances and rests when it rests.
void FlightPath::tow_headings() {
  const double step = knot_step_ / kHeadingsPerSegment;
  const std::size_t steps = (control_points_.size() - 3) * kHeadingsPerSegment;
  double heading = first_heading();
  headings_.reserve(steps + 1);
  headings_.push_back(heading);
  for (std::size_t i = 0; i < steps; ++i) {
    const Eigen::Vector3d v = velocity((static_cast<double>(i) + 0.5) * step);
    const double speed = std::hypot(v.x(), v.y());
    const double angle = std::remainder(heading - std::atan2(v.y(), v.x()), 2 * std::numbers::pi);
    heading += towed(angle, speed * step) - angle;
    headings_.push_back(heading);
  }
}

/// Direction of the first stretch of the path; 0 if the path never leaves its first point.
double FlightPath::first_heading() const {
  constexpr double kStretch = kTrailerLength / 10;
  const Eigen::Vector3d start = position(0);
  for (std::size_t segment = 1; segment + 3 <= control_points_.size(); ++segment) {
    const Eigen::Vector3d d = position(static_cast<double>(segment) * knot_step_) - start;
    if (std::hypot(d.x(), d.y()) > kStretch) return std::atan2(d.y(), d.x());
  }
  return 0;
}

double FlightPath::heading(double t) const {
  const double last = static_cast<double>(headings_.size() - 1);
  const double place = std::clamp(t / knot_step_ * kHeadingsPerSegment, 0.0, last);
  const auto before = static_cast<std::size_t>(std::min(place, last - 1));
  return std::lerp(headings_[before], headings_[before + 1], place - static_cast<double>(before));
}

ldm::Pose FlightPath::T_world_uav(double t) const {
  return multirotor_pose(position(t), acceleration(t), heading(t));
}

ldm::Pose multirotor_pose(const Eigen::Vector3d& position, const Eigen::Vector3d& acceleration,
                          double heading) {
  const Eigen::Vector3d forward(std::cos(heading), std::sin(heading), 0);
  const Eigen::Vector3d thrust = (acceleration + kGravity * Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d left = thrust.cross(forward).normalized();
  ldm::Pose pose;
  pose.rotation << left.cross(thrust), left, thrust;
  pose.translation = position;
  return pose;
}

}  // namespace datasets
