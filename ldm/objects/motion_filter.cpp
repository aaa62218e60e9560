#include "ldm/objects/motion_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace ldm {
namespace {

// By mode: at rest, little, more, abruptly.
constexpr double kAcceleration[] = {0, 0.3, 2, 30};  // [m/s^2]
constexpr double kStay[] = {0.95, 0.7, 0.9, 0.5};    // probability, from view to view
constexpr double kTurnsTo[] = {0.3, 1, 1, 1};        // relative: what moves seldom stops dead
constexpr double kRestDrift = 0.004;                 // of a position at rest, a view [m]
constexpr double kRestSigma = 0.001;                 // of a velocity at rest [m/s]
constexpr double kUnknownSpeed = 6;                  // standard deviation, per axis [m/s]
constexpr double kUnlikely = 0.05;                   // a mode no ellipse of 95 % holds
constexpr double kLeastProbability = 1e-6;           // of a mode: none is given up for ever
constexpr double kImpossible = 1e-30;                // not zero, if all modes are surprised
constexpr std::size_t kOnlyMode = 2;                 // without manoeuvres

void rest(MotionState& state) {
  const Eigen::Matrix2d position = state.covariance.topLeftCorner<2, 2>();
  state.mean.tail<2>().setZero();
  state.covariance.setZero();
  state.covariance.topLeftCorner<2, 2>() =
      position + kRestDrift * kRestDrift * Eigen::Matrix2d::Identity();
  state.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(kRestSigma * kRestSigma);
}

/// With white acceleration noise of `a` [m/s^2] a step.
void move(MotionState& state, double a, double dt) {
  Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
  f(0, 2) = f(1, 3) = dt;
  state.mean = f * state.mean;
  state.covariance = (f * state.covariance * f.transpose()).eval();
  const double q = a * a * dt * dt;
  for (const int axis : {0, 1}) {
    state.covariance(axis, axis) += q * dt * dt / 3;
    state.covariance(axis, axis + 2) += q * dt / 2;
    state.covariance(axis + 2, axis) += q * dt / 2;
    state.covariance(axis + 2, axis + 2) += q;
  }
}

double likelihood(const Eigen::Vector2d& innovation, const Eigen::Matrix2d& covariance) {
  return std::exp(-0.5 * innovation.dot(covariance.inverse() * innovation)) /
         std::sqrt(covariance.determinant());
}

/// Likelihood of the measurement.
double correct(MotionState& state, const Eigen::Vector2d& position,
               const Eigen::Matrix2d& covariance) {
  const Eigen::Matrix2d expected = state.covariance.topLeftCorner<2, 2>() + covariance;
  const Eigen::Matrix2d inverse = expected.inverse();
  const Eigen::Vector2d innovation = position - state.mean.head<2>();
  const Eigen::Matrix<double, 4, 2> gain = state.covariance.leftCols<2>() * inverse;
  // Joseph's form: the covariance stays symmetric and positive.
  Eigen::Matrix4d rest = Eigen::Matrix4d::Identity();
  rest.leftCols<2>() -= gain;
  state.mean += gain * innovation;
  state.covariance =
      (rest * state.covariance * rest.transpose() + gain * covariance * gain.transpose()).eval();
  return std::exp(-0.5 * innovation.dot(inverse * innovation)) / std::sqrt(expected.determinant());
}

}  // namespace

MotionFilter::MotionFilter(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance,
                           bool manoeuvres)
    : manoeuvres_(manoeuvres) {
  mixed_.mean << position, 0, 0;
  mixed_.covariance.topLeftCorner<2, 2>() = covariance;
  mixed_.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(kUnknownSpeed * kUnknownSpeed);
  modes_.fill({mixed_, 1.0 / kModes});
  modes_[0].state.covariance.bottomRightCorner<2, 2>().diagonal().setConstant(kRestSigma *
                                                                              kRestSigma);
}

/// Probability of a change of mode from view to view.
double MotionFilter::transition(std::size_t from, std::size_t to) const {
  if (!manoeuvres_) return to == kOnlyMode ? 1 : 0;
  if (from == to) return kStay[from];
  double others = 0;
  for (std::size_t mode = 0; mode < kModes; ++mode) {
    if (mode != from) others += kTurnsTo[mode];
  }
  return (1 - kStay[from]) * kTurnsTo[to] / others;
}

MotionState MotionFilter::mix(const std::array<double, kModes>& weights) const {
  MotionState mixed;
  for (std::size_t m = 0; m < kModes; ++m) mixed.mean += weights[m] * modes_[m].state.mean;
  for (std::size_t m = 0; m < kModes; ++m) {
    const Eigen::Vector4d apart = modes_[m].state.mean - mixed.mean;
    mixed.covariance += weights[m] * (modes_[m].state.covariance + apart * apart.transpose());
  }
  return mixed;
}

Eigen::Matrix2d MotionFilter::velocity_covariance() const {
  double total = 0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Mode& mode : modes_) {
    if (mode.probability < kUnlikely) continue;
    const Eigen::Vector2d apart = (mode.state.mean - mixed_.mean).tail<2>();
    const Eigen::Matrix2d own = mode.state.covariance.bottomRightCorner<2, 2>();
    covariance += mode.probability * (own + apart * apart.transpose());
    total += mode.probability;
  }
  return covariance / total;
}

void MotionFilter::predict(double dt) {
  std::array<Mode, kModes> next;
  std::array<double, kModes> weights{};
  for (std::size_t to = 0; to < kModes; ++to) {
    for (std::size_t from = 0; from < kModes; ++from) {
      weights[from] = transition(from, to) * modes_[from].probability;
      next[to].probability += weights[from];
    }
    if (next[to].probability == 0) {
      next[to] = modes_[to];
      next[to].probability = 0;
      continue;
    }
    for (double& weight : weights) weight /= next[to].probability;
    next[to].state = mix(weights);
    if (to == 0) {
      rest(next[to].state);
    } else {
      move(next[to].state, kAcceleration[to], dt);
    }
  }
  modes_ = next;
  for (std::size_t m = 0; m < kModes; ++m) weights[m] = modes_[m].probability;
  mixed_ = mix(weights);
}

MotionFilter::Evidence MotionFilter::evidence(const Fix& fix, const Fix& error) const {
  Evidence sum;
  double total = kImpossible;
  for (const Mode& mode : modes_) {
    const Eigen::Matrix2d expected = mode.state.covariance.topLeftCorner<2, 2>() + fix.covariance;
    const Eigen::Vector2d off = fix.position - mode.state.mean.head<2>();
    const double weight =
        mode.probability * likelihood(off - error.position, expected + error.covariance);
    const Eigen::Matrix2d information = expected.inverse();
    sum.information += weight * information;
    sum.vector += weight * information * off;
    total += weight;
  }
  sum.information /= total;
  sum.vector /= total;
  return sum;
}

void MotionFilter::update(const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance) {
  double total = 0;
  for (Mode& mode : modes_) {
    mode.probability *= correct(mode.state, position, covariance) + kImpossible;
    total += mode.probability;
  }
  double kept = 0;
  for (Mode& mode : modes_) {
    mode.probability = std::max(mode.probability / total, manoeuvres_ ? kLeastProbability : 0);
    kept += mode.probability;
  }
  std::array<double, kModes> weights{};
  for (std::size_t m = 0; m < kModes; ++m) weights[m] = modes_[m].probability /= kept;
  mixed_ = mix(weights);
}

}  // namespace ldm
