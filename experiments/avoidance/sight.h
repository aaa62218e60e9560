#pragma once
/// What an arm of the study knows of the world: nothing, a map, or the truth (closed loop).
#include <cstdint>
#include <memory>
#include <vector>

#include "datasets/frame.h"
#include "datasets/scenario/obstacle.h"
#include "experiments/avoidance/planner/surroundings.h"
#include "experiments/method/methods.h"

namespace experiments {

/// How far an arm trusts what it knows (docs/avoidance.md).
struct Trust {
  double margin = 0.1;       ///< taken off all distances [m]
  double doubt = 1;          ///< standard deviations by which what moves is wider; at most 0.8 m
  double moving_from = 0.3;  ///< speed from which a cluster is predicted, not taken to stand [m/s]
};

/// Times of a plan's samples after the latest scan [s].
using SampleTimes = std::vector<double>;

class Sight {
 public:
  virtual ~Sight() = default;
  /// Take a scan, and the truth beside it.
  virtual void see(const datasets::Frame& frame) = 0;
  /// What is known after the last scan, predicted to the times.
  virtual void predict(const SampleTimes& times, Surroundings& surroundings) = 0;
  /// Whether anything of an object is known after the last scan.
  virtual bool knows(const datasets::ObjectState& object) const = 0;
  /// The same as a map, for pictures.
  virtual ldm::LocalMap map() const = 0;
};

/// Knows what a method maps. Clusters that move are predicted at constant velocity.
/// `see` throws what check_map says of a map that is none.
std::unique_ptr<Sight> mapped_sight(const Method& method, const ldm::Parameters& parameters,
                                    const Trust& trust);

/// Knows all shapes in the window of a map with these parameters, whether the sensor sees them or
/// not, and what moves there: at constant velocity, or its true motion if `future`.
/// `obstacles` must outlive it.
std::unique_ptr<Sight> true_sight(const ldm::Parameters& parameters,
                                  const std::vector<datasets::Obstacle>& obstacles, bool future,
                                  const Trust& trust);

}  // namespace experiments
