#include "ldm/objects/tracked_object.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace ldm {
namespace {

constexpr double kFloor = 0.003;        // of a measured position: what registration never sees [m]
constexpr double kSignificance = 13.8;  // chi^2 of two numbers at 99.9 %
constexpr double kLeastSpeed = 0.1;     // of what is called dynamic [m/s]
constexpr std::int64_t kLeastViews = 3;
// Of what is slow no ellipse is small enough: so unlikely at rest, it moves, and until it may rest.
constexpr double kHardlyRests = 0.01, kMayRest = 0.3;

// An outline serves for so many views; less if the object is seen from elsewhere; but it is not
// given up for one of a part of the object, unless nothing else comes.
constexpr int kOutlineViews = 5;
constexpr double kSameSide = 0.985;  // cosine
constexpr double kPart = 0.7;        // of the width

constexpr double kGoneShare = 0.5;  // of what a way would change, to believe it
constexpr double kRest = 1;         // after so long without a velocity it is asked for again [s]
constexpr std::size_t kLeastPlaces = 3;

constexpr double kAlike = 0.2;            // of the speed
constexpr double kAlikeSignificance = 9;  // chi^2 of the difference

Eigen::Matrix2d position_floor() {
  return kFloor * kFloor * Eigen::Matrix2d::Identity();
}

/// Whether enough of the columns stand where a panorama saw past, after a way [m] that they go, or
/// have gone: of a way of their whole extent all would, of less a part.
bool vacant(const std::vector<Eigen::Vector2d>& columns, double way, const Panorama& panorama) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : columns) box.extend(p);
  const double expected = way < box.diagonal().norm() ? way / box.diagonal().norm() : 1;
  const auto past = std::count_if(columns.begin(), columns.end(),
                                  [&](const auto& p) { return panorama.seen_past(p); });
  return static_cast<double>(past) >= kGoneShare * expected * static_cast<double>(columns.size());
}

}  // namespace

TrackedObject::TrackedObject(std::int64_t id, double time, std::vector<Eigen::Vector3d> points,
                             View view, const Ingredients& ingredients)
    : ingredients_(ingredients),
      id_(id),
      since_(time),
      seen_(time),
      points_(std::move(points)),
      view_(std::move(view)),
      at_view_(view_.centre()),
      filter_(at_view_, position_floor(), ingredients.manoeuvres),
      outline_(outline_of(view_)),
      at_outline_(at_view_) {}

double TrackedObject::position_sigma() const {
  const auto& covariance = filter_.state().covariance;
  return std::sqrt(std::max(covariance(0, 0), covariance(1, 1)));
}

void TrackedObject::judge_velocity() {
  const Eigen::Vector2d v = velocity();
  const double rest = filter_.probability_of_rest();
  const bool beyond_chance = v.dot(velocity_covariance().inverse() * v) >= kSignificance;
  significant_ = views_ >= kLeastViews && v.norm() >= kLeastSpeed &&
                 (beyond_chance || rest < kHardlyRests || (significant_ && rest < kMayRest));
}

double TrackedObject::distance(const Eigen::Vector2d& p) const {
  return view_.distance(p - since_view());
}

Fix TrackedObject::fix(const View& view) const {
  // From where it should be, and from where its centre has gone: abrupt turns have two minima.
  Displacement d = registered(outline_, view, position() - at_outline_, ingredients_);
  const Displacement other =
      registered(outline_, view, view.centre() - outline_.view.centre(), ingredients_);
  if (other.cost < d.cost) d = other;
  return {at_outline_ + d.value, d.information.inverse() + position_floor()};
}

void TrackedObject::see(double time, std::vector<Eigen::Vector3d> points, View view, const Fix& fix,
                        const Fix& freed) {
  filter_.update(freed.position, freed.covariance);
  take(time, std::move(points), std::move(view));
  ++outline_age_;
  const bool due = outline_age_ >= kOutlineViews || view_.axis.dot(outline_.view.axis) < kSameSide;
  const bool part = view_.width() < kPart * outline_.view.width();
  if ((due && !part) || outline_age_ >= 2 * kOutlineViews) {
    renew_outline(position() + fix.position - freed.position);
  }
}

void TrackedObject::see_alone(double time, std::vector<Eigen::Vector3d> points, View view) {
  take(time, std::move(points), std::move(view));
  renew_outline(position());
}

void TrackedObject::take(double time, std::vector<Eigen::Vector3d> points, View view) {
  seen_ = time;
  missed_ = 0;
  ++views_;
  points_ = std::move(points);
  view_ = std::move(view);
  at_view_ = position();
}

void TrackedObject::renew_outline(const Eigen::Vector2d& at) {
  outline_ = outline_of(view_);
  at_outline_ = at;
  outline_age_ = 0;
}

void TrackedObject::judge(const Panorama& then, double time, const Panorama& now) {
  Place& place = places_.emplace_back(Place{seen_, {}});
  view_.for_each_column([&](const Column& c) { place.columns.push_back(c.point); });
  while (places_.size() > kLeastPlaces && places_.front().time < time) {
    places_.erase(places_.begin());
  }
  judge_velocity();
  if (!significant_) {
    if (seen_ - last_significant_ > kRest) gone_ = false;
    return;
  }
  last_significant_ = seen_;
  const double speed = velocity().norm();
  const Place& before = places_.front();
  gone_ = gone_ || vacant(places_.back().columns, speed * (seen_ - time), then) ||
          vacant(before.columns, speed * (seen_ - before.time), now);
}

void TrackedObject::note_company(bool shared) {
  together_ = shared ? together_ + 1 : 0;
  apart_ += shared ? 0 : 1;
}

bool move_alike(const TrackedObject& a, const TrackedObject& b) {
  if (!a.dynamic() || !b.dynamic()) return false;
  const Eigen::Vector2d d = a.velocity() - b.velocity();
  const Eigen::Matrix2d covariance = a.velocity_covariance() + b.velocity_covariance();
  return d.norm() < kAlike * a.velocity().norm() ||
         d.dot(covariance.inverse() * d) < kAlikeSignificance;
}

}  // namespace ldm
