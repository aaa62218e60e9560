#pragma once
/// A method over a source of frames: scored, timed and watched (paper Sec. 4.1.2-4.1.3).
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "datasets/frame.h"
#include "experiments/method/methods.h"
#include "experiments/method/stage_clock.h"
#include "experiments/metrics/scores.h"

namespace experiments {

/// Estimated and true velocity of one object, and what stood for it, over the frames in which it is
/// in the map.
struct VelocitySeries {
  std::int32_t object = 0;
  bool dynamic = false;
  std::vector<std::int64_t> frame;
  std::vector<double> time;                              ///< [s]
  std::vector<Eigen::Vector3d> true_velocity;            ///< [m/s]
  std::vector<std::optional<Eigen::Vector3d>> velocity;  ///< absent: no cluster matched [m/s]
  std::vector<bool> visible;                             ///< a ray met it
  std::vector<std::optional<std::int64_t>> track;        ///< of the matched cluster
};

struct Evaluation {
  std::int64_t frames = 0;
  std::optional<Tallies> tallies;      ///< absent if no frame had a truth
  std::vector<VelocitySeries> series;  ///< by object
  StageClock clock;                    ///< of the updates alone: no scoring, no reading of the map
};

struct EvaluationOptions {
  std::optional<std::int64_t> frames;  ///< stop after so many
  bool series = false;                 ///< keep the velocity series; memory grows with the frames
  /// Called after each frame, outside of the timing; may be empty, and may complete the map.
  std::function<void(const datasets::Frame&, ldm::LocalMap&)> observer;
};

/// A new mapper of a method on its way through frames; several may share the frames of one source.
class MethodEvaluation {
 public:
  MethodEvaluation(const Method& method, const ldm::Parameters& parameters,
                   const EvaluationOptions& options);
  ~MethodEvaluation();
  MethodEvaluation(MethodEvaluation&&) noexcept;
  MethodEvaluation& operator=(MethodEvaluation&&) noexcept;

  /// What mapper and observer throw passes through.
  /// @throws std::runtime_error on a map that is none (see map_check.h).
  void add(const datasets::Frame& frame);
  /// What was found; nothing may be added afterwards.
  Evaluation finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Every frame of `source` through a new mapper of that method.
/// What source, mapper and observer throw passes through.
/// @throws std::runtime_error on a map that is none (see map_check.h).
Evaluation evaluate(const Method& method, const ldm::Parameters& parameters,
                    datasets::FrameSource& source, const EvaluationOptions& options);

}  // namespace experiments
