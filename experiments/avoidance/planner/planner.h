#pragma once
/// Replanning of a B-spline towards a goal, in the manner of Usenko et al., IROS 2017, [11] of the
/// paper: a few control points, distances from the map, and Ceres.
#include <cstddef>

#include "experiments/avoidance/planner/planner_costs.h"
#include "experiments/avoidance/planner/trajectory.h"

namespace experiments {

struct PlannerParameters {
  double knot_step = 0.2;     ///< of the control points, and between two plans [s]
  std::size_t segments = 15;  ///< of a plan: a horizon of 3 s
  double radius = 0.3;        ///< of the UAV, a ball [m]
  double cruise = 1.6;        ///< speed that it wants [m/s]
  FlightLimits limits;
  HeightBand band;
};

/// Samples at which a plan is held against obstacles: sample i is at i * knot_step / 5.
inline constexpr std::size_t kSamplesPerSegment = 5;

struct Plan {
  ControlPoints points;  ///< segments + 3, the fixed ones first
  bool braking = false;  ///< comes to rest, since what was found is predicted to touch
  double clearance = 0;  ///< least predicted distance from the UAV's surface in the next 2.5 s [m]
};

class Planner {
 public:
  /// @param start, goal ends of the straight line that the UAV follows where nothing is in its way,
  /// world [m]
  Planner(const PlannerParameters& parameters, const Eigen::Vector3d& start,
          const Eigen::Vector3d& goal);

  /// The plan from `fixed` on, which is never outside of the limits. One knot step after the plan
  /// before it, from which it starts. Same calls, same bits. Cost: see docs/avoidance.md.
  /// @param fixed the first control points, at least 3: those of the segments that are flown
  /// before the plan takes effect, and three more
  /// @param surroundings predicted at the samples of the plan
  Plan next(const ControlPoints& fixed, const Surroundings& surroundings);

  /// The least predicted distance of the UAV's surface from obstacles over the next 2.5 s [m].
  double clearance(const ControlPoints& points, const Surroundings& surroundings) const;

  std::size_t sample_count() const { return parameters_.segments * kSamplesPerSegment + 1; }
  double sample_step() const {
    return parameters_.knot_step / static_cast<double>(kSamplesPerSegment);
  }

 private:
  struct Target {
    Eigen::Vector3d position, velocity;
  };
  struct Candidate {
    ControlPoints points;
    double cost = 0;
    double clearance = 0;
  };

  Target target(const Eigen::Vector3d& from, const Surroundings& surroundings) const;
  ControlPoints straight(const ControlPoints& fixed, const Target& target, double aside) const;
  ControlPoints shifted(const ControlPoints& fixed) const;
  Candidate optimised(ControlPoints start, std::size_t fixed, const Target& target,
                      const Surroundings& surroundings, int iterations) const;

  PlannerParameters parameters_;
  Eigen::Vector3d start_, along_;  // along_: unit vector
  double length_;
  ControlPoints previous_;
};

}  // namespace experiments
