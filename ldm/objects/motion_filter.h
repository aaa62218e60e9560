#pragma once
/// Position and velocity of an object from measured positions, at rest or on the move (no paper
/// section; interacting multiple models: Blom and Bar-Shalom, IEEE Trans. Autom. Control 33(8),
/// 1988).
#include <Eigen/Core>
#include <array>

namespace ldm {

/// Horizontal position and velocity (x, y, vx, vy), world [m, m/s]. As in Pose, the layout is the
/// same for every -march.
struct MotionState {
  Eigen::Matrix<double, 4, 1, Eigen::DontAlign> mean = Eigen::Vector4d::Zero();
  Eigen::Matrix<double, 4, 4, Eigen::DontAlign> covariance = Eigen::Matrix4d::Zero();
};

/// A measured position [m] and its covariance [m^2]; the layout is the same for every -march.
struct Fix {
  Eigen::Matrix<double, 2, 1, Eigen::DontAlign> position = Eigen::Vector2d::Zero();
  Eigen::Matrix<double, 2, 2, Eigen::DontAlign> covariance = Eigen::Matrix2d::Zero();
};

/// Kalman filters of an object at rest and of one that accelerates little, more and abruptly, mixed
/// by how well each foretells what is measured.
class MotionFilter {
 public:
  /// Found at `position` with that covariance [m, m^2]; nothing is known of its velocity.
  /// @param manoeuvres else all is moved as by one Kalman filter that accelerates by 2 m/s^2
  MotionFilter(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance,
               bool manoeuvres = true);

  /// dt [s] later.
  void predict(double dt);
  /// Measured at `position` with that covariance.
  void update(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance);

  /// What a fix tells of an error that others share, before the update with it and if that error is
  /// thought to be `error`: of what turns at that moment, little.
  struct Evidence {
    Eigen::Matrix<double, 2, 2, Eigen::DontAlign> information = Eigen::Matrix2d::Zero();
    Eigen::Matrix<double, 2, 1, Eigen::DontAlign> vector = Eigen::Vector2d::Zero();  ///< times mean
  };
  Evidence evidence(const Fix& fix, const Fix& error) const;

  const MotionState& state() const { return mixed_; }
  /// Of the velocity, over the ways to move that are likely [m^2/s^2]: an abrupt turn always has a
  /// chance of some per cent and knows little; it is no part of an ellipse that holds 95 %.
  Eigen::Matrix2d velocity_covariance() const;
  double probability_of_rest() const { return modes_[0].probability; }

 private:
  static constexpr std::size_t kModes = 4;
  struct Mode {
    MotionState state;
    double probability = 0;
  };
  double transition(std::size_t from, std::size_t to) const;
  MotionState mix(const std::array<double, kModes>& weights) const;

  bool manoeuvres_;
  std::array<Mode, kModes> modes_;
  MotionState mixed_;
};

}  // namespace ldm
