#include "experiments/avoidance/planner/planner.h"

#include <ceres/problem.h>
#include <ceres/solver.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace experiments {
namespace {

using datasets::Derivative;

// Weights of squares, integrated over time where a term has a value at every time. Ceres halves
// squares: a term of weight w has residuals sqrt(2 w) times its value.
constexpr double kAccelerationWeight = 0.05;
constexpr double kJerkWeight = 0.01;
constexpr double kPositionWeight = 4;
constexpr double kVelocityWeight = 2;
constexpr double kCollisionWeight = 200;
constexpr double kLimitWeight = 100;
/// Distance beyond the UAV's radius within which obstacles push [m].
constexpr double kPush = 0.5;
/// The plan aims at a share of the limits; what exceeds the whole of them is cut off.
constexpr double kLimitShare = 0.95;
/// Of the predicted clearance: what lies farther ahead will be planned anew many times [s].
constexpr double kForesight = 2.5;
/// How far to the side the other starts are [m].
constexpr double kAside = 1.5;
/// A plan that ends so far from its target may be caught before an obstacle [m].
constexpr double kCaught = 1.0;
constexpr int kIterations = 15;
constexpr int kIterationsAside = 8;

double residual_scale(double weight) {
  return std::sqrt(2 * weight);
}

/// The least-squares problem over the control points that are not fixed.
class Fit {
 public:
  Fit(const PlannerParameters& parameters, ControlPoints& points, std::size_t fixed)
      : dt_(parameters.knot_step), segments_(parameters.segments), points_(points), fixed_(fixed) {
    ceres::Problem::Options options;
    options.disable_all_safety_checks = true;
    problem_ = ceres::Problem(options);
    for (std::size_t i = 0; i < points.size(); ++i) {
      problem_.AddParameterBlock(points[i].data(), 3);
      if (i < fixed) problem_.SetParameterBlockConstant(points[i].data());
    }
  }

  /// Acceleration is linear along a segment, so that the integral of its square is that of its
  /// middle plus dt^3 / 12 times the squared jerk.
  void add_smoothness() {
    const double jerk = kJerkWeight * dt_ + kAccelerationWeight * dt_ * dt_ * dt_ / 12;
    for (std::size_t s = first_segment(); s < segments_; ++s) {
      const double middle = (static_cast<double>(s) + 0.5) * dt_;
      add_target(middle, Derivative::kAcceleration, Eigen::Vector3d::Zero(),
                 residual_scale(kAccelerationWeight * dt_));
      add_target(middle, Derivative::kJerk, Eigen::Vector3d::Zero(), residual_scale(jerk));
    }
  }

  void add_target(double t, Derivative derivative, const Eigen::Vector3d& target, double scale) {
    add(new datasets::TargetCost(basis(t, derivative), target, Eigen::Vector3d::Constant(scale)),
        t);
  }

  void add_limits(const FlightLimits& limits) {
    const double scale = residual_scale(kLimitWeight * dt_ / 2);
    for (std::size_t half = 2 * first_segment() + 1; half <= 2 * segments_; ++half) {
      const double t = static_cast<double>(half) * dt_ / 2;
      add(new datasets::NormLimitCost(basis(t, Derivative::kVelocity), kLimitShare * limits.speed,
                                      scale),
          t);
      if (half % 2 != 0) continue;
      add(new datasets::NormLimitCost(basis(t, Derivative::kAcceleration),
                                      kLimitShare * limits.acceleration, scale * dt_),
          t);
    }
  }

  void add_obstacles(const PlannerParameters& parameters, const Surroundings& surroundings) {
    const double h = dt_ / static_cast<double>(kSamplesPerSegment);
    const double scale = residual_scale(kCollisionWeight * h / kPush);
    for (std::size_t sample = first_segment() * kSamplesPerSegment + 1;
         sample <= segments_ * kSamplesPerSegment; ++sample) {
      const double t = static_cast<double>(sample) * h;
      add(new SampleCost(basis(t, Derivative::kPosition), surroundings, sample,
                         parameters.radius + kPush, parameters.band, scale),
          t);
    }
  }

  /// @return the cost at the end
  double solve(int iterations) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // Eigen's factorisation is part of Ceres: the same bits whichever BLAS the machine has.
    options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    options.num_threads = 1;
    options.max_num_iterations = iterations;
    options.function_tolerance = 1e-3;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    return summary.final_cost;
  }

 private:
  /// The first that a free control point moves.
  std::size_t first_segment() const { return fixed_ - 3; }

  datasets::BasisWeights basis(double t, Derivative derivative) const {
    return datasets::basis_weights(t, dt_, segments_, derivative);
  }

  void add(ceres::CostFunction* cost, double t) {
    const std::size_t first = basis(t, Derivative::kPosition).first;
    const auto block = [&](std::size_t i) { return points_[first + i].data(); };
    problem_.AddResidualBlock(cost, nullptr, block(0), block(1), block(2), block(3));
  }

  double dt_;
  std::size_t segments_;
  ControlPoints& points_;
  std::size_t fixed_;
  ceres::Problem problem_;
};

}  // namespace

Planner::Planner(const PlannerParameters& parameters, const Eigen::Vector3d& start,
                 const Eigen::Vector3d& goal)
    : parameters_(parameters),
      start_(start),
      along_((goal - start).normalized()),
      length_((goal - start).norm()) {}

double Planner::clearance(const ControlPoints& points, const Surroundings& surroundings) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t sample = 1; sample < sample_count(); ++sample) {
    const double t = static_cast<double>(sample) * sample_step();
    if (t > kForesight) break;
    const Eigen::Vector3d p = datasets::curve_at(points, parameters_.knot_step, t);
    least = std::min(
        {least, surroundings.from_still(p).value, surroundings.from_moving(sample, p).value});
  }
  return least - parameters_.radius;
}

/// Where cruising along the line ends, or a place on the line near to that which is free.
Planner::Target Planner::target(const Eigen::Vector3d& from,
                                const Surroundings& surroundings) const {
  const double horizon = static_cast<double>(parameters_.segments) * parameters_.knot_step;
  const double reached = (from - start_).dot(along_) + parameters_.cruise * horizon;
  const double wanted = std::min(reached, length_);
  const auto place = [&](double s) { return Eigen::Vector3d(start_ + s * along_); };
  const auto is_free = [&](double s) {
    return std::min(surroundings.from_still(place(s)).value,
                    surroundings.from_moving(sample_count() - 1, place(s)).value) >=
           parameters_.radius + kPush / 2;
  };
  constexpr double kSearchStep = 0.1, kSearched = 2;  // [m]
  double free_place = wanted;
  for (double aside = 0; aside <= kSearched; aside += kSearchStep) {
    if (wanted + aside <= length_ && is_free(wanted + aside)) {
      free_place = wanted + aside;
      break;
    }
    if (is_free(wanted - aside)) {
      free_place = wanted - aside;
      break;
    }
  }
  const bool arrives = reached >= length_;
  return {place(free_place),
          arrives ? Eigen::Vector3d::Zero() : Eigen::Vector3d(parameters_.cruise * along_)};
}

/// Evenly to the target, and in the middle so far to the left of the straight way [m].
ControlPoints Planner::straight(const ControlPoints& fixed, const Target& target,
                                double aside) const {
  ControlPoints points = fixed;
  const Eigen::Vector3d left = Eigen::Vector3d::UnitZ().cross(along_);
  const auto ahead = static_cast<double>(parameters_.segments + 3 - fixed.size());
  for (std::size_t i = fixed.size(); i < parameters_.segments + 3; ++i) {
    const double share = static_cast<double>(i + 1 - fixed.size()) / ahead;
    points.emplace_back(fixed.back() + share * (target.position - fixed.back()) +
                        aside * std::sin(std::numbers::pi * share) * left);
  }
  return points;
}

/// The plan before this one, a knot on; its end goes on as it went.
ControlPoints Planner::shifted(const ControlPoints& fixed) const {
  ControlPoints points = fixed;
  points.insert(points.end(), previous_.begin() + static_cast<std::ptrdiff_t>(fixed.size()) + 1,
                previous_.end());
  points.emplace_back(2 * points[points.size() - 1] - points[points.size() - 2]);
  return points;
}

Planner::Candidate Planner::optimised(ControlPoints start, std::size_t fixed, const Target& target,
                                      const Surroundings& surroundings, int iterations) const {
  const double end = static_cast<double>(parameters_.segments) * parameters_.knot_step;
  Candidate candidate{std::move(start), 0, 0};
  Fit fit(parameters_, candidate.points, fixed);
  fit.add_smoothness();
  fit.add_limits(parameters_.limits);
  fit.add_obstacles(parameters_, surroundings);
  fit.add_target(end, Derivative::kPosition, target.position, residual_scale(kPositionWeight));
  fit.add_target(end, Derivative::kVelocity, target.velocity, residual_scale(kVelocityWeight));
  candidate.cost = fit.solve(iterations);
  limit(candidate.points, fixed, parameters_.knot_step, parameters_.limits);
  candidate.clearance = clearance(candidate.points, surroundings);
  return candidate;
}

Plan Planner::next(const ControlPoints& fixed, const Surroundings& surroundings) {
  const Target aim = target(fixed.back(), surroundings);
  const auto is_clear = [](const Candidate& c) { return c.clearance >= 0; };
  // Among clear ones the cheapest, else the one that keeps farthest off.
  const auto is_better = [&](const Candidate& a, const Candidate& b) {
    if (is_clear(a) != is_clear(b)) return is_clear(a);
    return is_clear(a) ? a.cost < b.cost : a.clearance > b.clearance;
  };
  Candidate best = optimised(previous_.empty() ? straight(fixed, aim, 0) : shifted(fixed),
                             fixed.size(), aim, surroundings, kIterations);
  const bool is_caught = (best.points.back() - aim.position).norm() > kCaught;
  if (!is_clear(best) || is_caught) {
    for (const double aside : {kAside, -kAside}) {
      Candidate other =
          optimised(straight(fixed, aim, aside), fixed.size(), aim, surroundings, kIterationsAside);
      if (is_better(other, best)) best = std::move(other);
    }
  }
  Plan plan{std::move(best.points), false, best.clearance};
  if (plan.clearance < 0) {
    ControlPoints stop =
        braked(fixed, parameters_.segments + 3, parameters_.knot_step, parameters_.limits);
    const double stopped = clearance(stop, surroundings);
    if (stopped > plan.clearance) plan = {std::move(stop), true, stopped};
  }
  previous_ = plan.points;
  return plan;
}

}  // namespace experiments
