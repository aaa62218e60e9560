#pragma once
/// Sums behind the scores of the estimated velocities (paper Sec. 4.1.3).
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "experiments/metrics/mean.h"
#include "experiments/metrics/quantile.h"
#include "ldm/types.h"

namespace experiments {

/// One object in one frame, in the map or not.
struct Observation {
  std::int32_t object = 0;
  bool dynamic = false;
  double time = 0;  ///< [s]
  bool in_map = false;
  bool visible = false;
  Eigen::Vector3d true_velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  std::optional<Eigen::Vector3d> velocity;                  ///< of the matched cluster [m/s]
  /// Of its horizontal part [m^2/s^2]; absent where the method says none.
  std::optional<Eigen::Matrix2d> covariance = {};
};

/// Follows every object through its stays in the map.
class VelocityTally {
 public:
  static constexpr double kSettling = 2.0;       ///< errors count from here on after entering [s]
  static constexpr double kAfterReversal = 1.5;  ///< not steady for so long [s]
  static constexpr double kConverged = 0.3;      ///< error below which an estimate is good [m/s]
  static constexpr double kConvergedTime = 0.5;  ///< for how long without a break [s]
  static constexpr double kStanding = 0.05;      ///< slower is at rest [m/s]
  static constexpr double kRecovered = 0.2;      ///< error below which a turn is followed [m/s]
  static constexpr double kLeastRecovery = 1.0;  ///< what is cut off sooner tells nothing [s]
  static constexpr double kEllipse = 5.991;      ///< chi^2 of two numbers at 95 %

  /// Frames in the order of time; every object of the truth in every frame, so that its reversals
  /// out of the map are known.
  void add(const Observation& seen);
  /// One frame's clusters that overlap no object.
  void add_clusters_without_object(std::int64_t count);
  /// Ends the stays that are still open. Nothing may be added afterwards.
  void finish();

  const Mean& error(bool dynamic) const { return error_[dynamic]; }
  /// Outside 1.5 s after a reversal (a turn by more than 90 degrees from frame to frame), a stop or
  /// a start.
  const Mean& steady_error(bool dynamic) const { return steady_error_[dynamic]; }
  /// What so large a share of the errors of static objects does not exceed [m/s].
  std::optional<double> static_error_quantile(double share) const {
    return quantile(static_errors_, share);
  }
  /// 1 per error of a dynamic object whose 95 % ellipse holds the true velocity, 0 per other one.
  const Mean& in_ellipse() const { return in_ellipse_; }
  /// Times from the first frame after a turn by more than 90 degrees of an object that was in view
  /// and matched, to the first of two frames with an error below kRecovered [s]. A turn after which
  /// that never comes has the time until the next one, or until the object leaves the map; below
  /// kLeastRecovery it does not count.
  const std::vector<double>& recoveries() const { return recoveries_; }
  /// Of the stays of dynamic objects that converged [s].
  const Mean& time_to_converge() const { return time_to_converge_; }
  /// 1 per stay of a dynamic object of at least 2 s that never converged, 0 per other such stay.
  const Mean& not_converged() const { return not_converged_; }
  /// 1 per frame of an object with a visible voxel and no matched cluster, 0 per other such frame.
  const Mean& missed() const { return missed_; }
  const Mean& clusters_without_object() const { return clusters_without_object_; }

 private:
  struct Stay {
    double entered = 0;                ///< [s]
    double last = 0;                   ///< [s]
    std::optional<double> good_since;  ///< [s]
    bool converged = false;
  };
  struct Turn {
    double time = 0;                   ///< [s]
    std::optional<double> good_since;  ///< [s]
  };
  struct Track {
    std::optional<Eigen::Vector3d> velocity;  ///< true one of the frame before
    std::optional<double> reversed;           ///< time of the last reversal, stop or start [s]
    bool dynamic = false;
    std::optional<Stay> stay;
    bool matched = false;  ///< in the frame before, and visible
    std::optional<Turn> turn;
  };

  /// True at a turn.
  bool note_reversal(Track& track, const Observation& seen) const;
  void note_recovery(Track& track, const Observation& seen, bool turned);
  void end_turn(Track& track, double time);
  void note_convergence(Stay& stay, const Observation& seen);
  void end_stay(Track& track);

  std::map<std::int32_t, Track> tracks_;
  Mean error_[2];         // static, dynamic
  Mean steady_error_[2];  // static, dynamic
  std::vector<double> static_errors_;
  Mean in_ellipse_;
  std::vector<double> recoveries_;
  Mean time_to_converge_;
  Mean not_converged_;
  Mean missed_;
  Mean clusters_without_object_;
};

}  // namespace experiments
