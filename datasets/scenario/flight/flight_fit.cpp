#include <ceres/problem.h>
#include <ceres/solver.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "datasets/scenario/flight/bspline.h"
#include "datasets/scenario/flight/flight_costs.h"
#include "datasets/scenario/flight/flight_path.h"
#include "datasets/scenario/flight/flight_route.h"
#include "datasets/scenario/flight/keep_out.h"

namespace datasets {
namespace {

constexpr double kKnotStep = 0.5;     // [s], at most
constexpr double kJerkScale = 0.3;    // [s^3/m]
constexpr double kWaypointScale = 3;  // [1/m]
// Between the waypoints the polyline holds the path on a long leash, which keeps a hover in place,
// and its altitude on a short one, without which a path would dive under a keep-out.
constexpr double kLeashScale = 0.1;   // [1/m]
constexpr double kAltitudeScale = 1;  // [1/m]
// The fit aims at a share of the limits on speed and acceleration, and at a wider clearance [m].
constexpr double kLimitShare = 0.95;
constexpr double kClearanceMargin = 0.1;
// The limits are penalties. Each round fits with sterner ones, from where the last round ended.
constexpr double kLimitScales[] = {10, 40, 160};  // [s/m], [s^2/m], [1/m]
constexpr int kIterationsPerRound = 10;

/// Time at which the fit's penalties and the final check look at the path.
double sample_time(const FlightTask& task, std::size_t sample) {
  return static_cast<double>(sample) * task.sample_step;
}

/// The least-squares problem over the control points, which stay the caller's.
class Fit {
 public:
  Fit(const FlightTask& task, double knot_step, std::vector<Eigen::Vector3d>& control_points)
      : task_(task), knot_step_(knot_step), control_points_(control_points) {}

  void add_smoothness() {
    const double scale = kJerkScale * std::sqrt(knot_step_);
    for (std::size_t s = 0; s < segments(); ++s) {
      add<TargetCost>(knot(s), Derivative::kJerk, Eigen::Vector3d::Zero(),
                      Eigen::Vector3d::Constant(scale));
    }
  }

  void add_waypoints(const std::vector<TimedWaypoint>& waypoints) {
    for (const TimedWaypoint& waypoint : waypoints) {
      add<TargetCost>(waypoint.time, Derivative::kPosition, waypoint.position,
                      Eigen::Vector3d::Constant(kWaypointScale));
    }
    for (std::size_t s = 0; s <= segments(); ++s) {
      add<TargetCost>(knot(s), Derivative::kPosition, on_polyline(waypoints, knot(s)),
                      Eigen::Vector3d(kLeashScale, kLeashScale, kAltitudeScale));
    }
  }

  /// Acceleration is linear between knots, so its norm is largest at one of them.
  void add_limits(double scale) {
    for (std::size_t half = 0; half <= 2 * segments(); ++half) {
      add<NormLimitCost>(knot(half) / 2, Derivative::kVelocity, kLimitShare * task_.max_speed,
                         scale);
    }
    for (std::size_t s = 0; s <= segments(); ++s) {
      add<NormLimitCost>(knot(s), Derivative::kAcceleration, kLimitShare * task_.max_acceleration,
                         scale);
    }
    for (std::size_t sample = 0; sample < sample_count(task_); ++sample) {
      add<ClearanceCost>(sample_time(task_, sample), Derivative::kPosition, task_, sample,
                         task_.clearance + kClearanceMargin, scale);
    }
  }

  void solve() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // Eigen's factorisation is part of Ceres: the same bits whichever BLAS the machine has.
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.num_threads = 1;
    options.max_num_iterations = kIterationsPerRound;
    // A longer first step would leap across keep-outs and be taken back.
    options.initial_trust_region_radius = 1;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
  }

 private:
  std::size_t segments() const { return control_points_.size() - 3; }
  double knot(std::size_t s) const { return static_cast<double>(s) * knot_step_; }

  template <class Cost, class... Arguments>
  void add(double t, Derivative derivative, const Arguments&... arguments) {
    const BasisWeights basis = basis_weights(t, knot_step_, segments(), derivative);
    const auto block = [&](std::size_t i) { return control_points_[basis.first + i].data(); };
    problem_.AddResidualBlock(new Cost(basis, arguments...), nullptr, block(0), block(1), block(2),
                              block(3));
  }

  const FlightTask& task_;
  double knot_step_;
  std::vector<Eigen::Vector3d>& control_points_;
  ceres::Problem problem_;
};

void check(bool good, const std::string& field, double value, const std::string& allowed) {
  if (good) return;
  char text[64];
  std::snprintf(text, sizeof text, "%g", value);
  throw ldm::InvalidInput("FlightTask: " + field + ": " + text + ", " + allowed);
}

void check_task(const FlightTask& task) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  check(task.waypoints.size() >= 2, "waypoints", static_cast<double>(task.waypoints.size()),
        "at least 2 needed");
  for (const Eigen::Vector3d& waypoint : task.waypoints) {
    check(waypoint.allFinite(), "waypoints", waypoint.sum(), "must be finite [m]");
  }
  check(positive(task.duration), "duration", task.duration, "must be above 0 s");
  check(positive(task.sample_step), "sample_step", task.sample_step, "must be above 0 s");
  check(positive(task.max_speed), "max_speed", task.max_speed, "must be above 0 m/s");
  check(task.max_acceleration > 0 && task.max_acceleration < 9.81, "max_acceleration",
        task.max_acceleration, "must lie between 0 and 9.81 m/s^2");
  check(positive(task.waypoint_radius), "waypoint_radius", task.waypoint_radius,
        "must be above 0 m");
  check(task.clearance >= 0 && std::isfinite(task.clearance), "clearance", task.clearance,
        "must be at least 0 m");
  for (const KeepOut& keep_out : task.keep_outs) {
    check(keep_out.centre.size() >= sample_count(task), "keep_outs: centre",
          static_cast<double>(keep_out.centre.size()),
          "needs " + std::to_string(sample_count(task)) + " samples");
  }
}

[[noreturn]] void broken(const char* limit, double value, const char* relation, double allowed,
                         const char* unit, double t) {
  char text[160];
  std::snprintf(text, sizeof text, "flight path breaks %s: %.3f %s, %s %.3f %s, at t = %.2f s",
                limit, value, unit, relation, allowed, unit, t);
  throw std::runtime_error(text);
}

/// The walk of `route` and the fit both need a polyline that a UAV at its speed limit can follow.
void check_polyline(const FlightTask& task) {
  double length = 0;
  for (std::size_t i = 1; i < task.waypoints.size(); ++i) {
    length += (task.waypoints[i] - task.waypoints[i - 1]).norm();
  }
  const double speed = length / task.duration;
  if (speed > task.max_speed) broken("max_speed", speed, "above", task.max_speed, "m/s", 0);
}

void check_limits(const FlightTask& task, const FlightPath& path) {
  for (std::size_t sample = 0; sample < sample_count(task); ++sample) {
    const double t = sample_time(task, sample);
    const double speed = path.velocity(t).norm();
    if (!(speed <= task.max_speed)) broken("max_speed", speed, "above", task.max_speed, "m/s", t);
    const double acceleration = path.acceleration(t).norm();
    if (!(acceleration <= task.max_acceleration)) {
      broken("max_acceleration", acceleration, "above", task.max_acceleration, "m/s^2", t);
    }
    for (const KeepOut& keep_out : task.keep_outs) {
      const double distance = signed_distance(keep_out, sample, path.position(t)).value;
      if (!(distance >= task.clearance)) {
        broken("clearance", distance, "below", task.clearance, "m", t);
      }
    }
  }
}

void check_waypoints(const FlightTask& task, const std::vector<TimedWaypoint>& waypoints,
                     const FlightPath& path) {
  for (const TimedWaypoint& waypoint : waypoints) {
    const double distance = (path.position(waypoint.time) - waypoint.position).norm();
    if (!(distance <= task.waypoint_radius)) {
      broken("waypoint_radius", distance, "above", task.waypoint_radius, "m", waypoint.time);
    }
  }
}

/// Control points whose curve stays near the positions, which stand a knot apart.
std::vector<Eigen::Vector3d> control_points_near(const std::vector<Eigen::Vector3d>& positions) {
  std::vector<Eigen::Vector3d> control_points{positions.front()};
  control_points.insert(control_points.end(), positions.begin(), positions.end());
  control_points.push_back(positions.back());
  return control_points;
}

}  // namespace

FlightPath fit_flight_path(const FlightTask& task) {
  check_task(task);
  check_polyline(task);
  const auto segments = static_cast<std::size_t>(std::ceil(task.duration / kKnotStep));
  const double knot_step = task.duration / static_cast<double>(segments);
  const std::vector<TimedWaypoint> waypoints = time_waypoints(task);
  std::vector<Eigen::Vector3d> control_points =
      control_points_near(route(task, waypoints, knot_step, segments));
  for (const double scale : kLimitScales) {
    Fit fit(task, knot_step, control_points);
    fit.add_smoothness();
    fit.add_waypoints(waypoints);
    fit.add_limits(scale);
    fit.solve();
  }
  FlightPath path(std::move(control_points), knot_step);
  check_limits(task, path);
  check_waypoints(task, waypoints, path);
  return path;
}

}  // namespace datasets
