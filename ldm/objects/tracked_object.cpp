#include "ldm/objects/tracked_object.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ldm {
namespace {

constexpr double kFloor = 0.003;        // of a measured position: what registration never sees [m]
constexpr double kSignificance = 13.8;  // chi^2 of two numbers at 99.9 %
constexpr double kLeastSpeed = 0.1;     // of what is called dynamic [m/s]
constexpr std::int64_t kLeastViews = 3;

// An outline serves for so many views; less if the object is seen from elsewhere; but it is not
// given up for one of a part of the object, unless nothing else comes.
constexpr int kOutlineViews = 5;
constexpr double kSameSide = 0.985;  // cosine
constexpr double kPart = 0.7;        // of the width

constexpr double kAlike = 0.2;            // of the speed
constexpr double kAlikeSignificance = 9;  // chi^2 of the difference

Eigen::Matrix2d position_floor() {
  return kFloor * kFloor * Eigen::Matrix2d::Identity();
}

}  // namespace

TrackedObject::TrackedObject(std::int64_t id, double time, std::vector<Eigen::Vector3d> points,
                             View view)
    : id_(id),
      since_(time),
      seen_(time),
      points_(std::move(points)),
      view_(std::move(view)),
      at_view_(view_.centre()),
      filter_(at_view_, position_floor()),
      outline_(outline_of(view_)),
      at_outline_(at_view_) {}

double TrackedObject::position_sigma() const {
  const auto& covariance = filter_.state().covariance;
  return std::sqrt(std::max(covariance(0, 0), covariance(1, 1)));
}

bool TrackedObject::dynamic() const {
  const Eigen::Vector2d v = velocity();
  return views_ >= kLeastViews && v.norm() >= kLeastSpeed &&
         v.dot(velocity_covariance().inverse() * v) >= kSignificance;
}

double TrackedObject::distance(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d then = p - since_view();
  double least = std::numeric_limits<double>::infinity();
  view_.for_each_column(
      [&](const Column& c) { least = std::min(least, (c.point - then).squaredNorm()); });
  return std::sqrt(least);
}

void TrackedObject::see(double time, std::vector<Eigen::Vector3d> points, View view) {
  // From where it should be, and from where its centre has gone: abrupt turns have two minima.
  Displacement d = registered(outline_, view, position() - at_outline_);
  const Displacement other = registered(outline_, view, view.centre() - outline_.view.centre());
  if (other.cost < d.cost) d = other;
  filter_.update(at_outline_ + d.value, d.information.inverse() + position_floor());

  seen_ = time;
  ++views_;
  points_ = std::move(points);
  view_ = std::move(view);
  at_view_ = position();
  ++outline_age_;
  const bool due = outline_age_ >= kOutlineViews || view_.axis.dot(outline_.view.axis) < kSameSide;
  const bool part = view_.width() < kPart * outline_.view.width();
  if ((due && !part) || outline_age_ >= 2 * kOutlineViews) {
    outline_ = outline_of(view_);
    at_outline_ = at_view_;
    outline_age_ = 0;
  }
}

bool move_alike(const TrackedObject& a, const TrackedObject& b) {
  if (!a.dynamic() || !b.dynamic()) return false;
  const Eigen::Vector2d d = a.velocity() - b.velocity();
  const Eigen::Matrix2d covariance = a.velocity_covariance() + b.velocity_covariance();
  return d.norm() < kAlike * a.velocity().norm() ||
         d.dot(covariance.inverse() * d) < kAlikeSignificance;
}

}  // namespace ldm
