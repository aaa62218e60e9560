#pragma once
/// An object as it is followed from scan to scan (no paper section; docs/objects.md).
#include <cstdint>
#include <vector>

#include "ldm/objects/ingredients.h"
#include "ldm/objects/motion_filter.h"
#include "ldm/objects/panorama.h"
#include "ldm/objects/registration.h"
#include "ldm/objects/view.h"

namespace ldm {

/// Horizontal: what an object does upwards is not estimated. World frame.
class TrackedObject {
 public:
  /// First seen at `time` [s] as `points` [m], which `view` shows.
  TrackedObject(std::int64_t id, double time, std::vector<Eigen::Vector3d> points, View view,
                const Ingredients& ingredients = {});

  std::int64_t id() const { return id_; }  ///< from 1, never used again
  double since() const { return since_; }  ///< first seen [s]
  double seen() const { return seen_; }    ///< last seen [s]
  std::int64_t views() const { return views_; }
  /// A point that moves with it: the centre of its first view [m].
  Eigen::Vector2d position() const { return filter_.state().mean.head<2>(); }
  Eigen::Vector2d velocity() const { return filter_.state().mean.tail<2>(); }  ///< [m/s]
  Eigen::Matrix2d velocity_covariance() const { return filter_.velocity_covariance(); }
  double position_sigma() const;  ///< along the axis where it is larger [m]
  /// At its last view its velocity was 0.1 m/s or more and beyond chance: outside of its 99.9 %
  /// ellipse around zero, or the probability of rest below 1 %, or below 30 % for what moved
  /// before; and it has gone there: see `judge`.
  bool dynamic() const { return gone_ && significant_; }

  /// Returns of its last view [m], and how far it has gone since.
  const std::vector<Eigen::Vector3d>& points() const { return points_; }
  const View& view() const { return view_; }
  Eigen::Vector2d since_view() const { return position() - at_view_; }

  /// Horizontal distance of p from the columns of its last view, moved to where it is now [m].
  double distance(const Eigen::Vector2d& p) const;
  /// A view of before, wider if a part is hidden now, and how far it has gone since.
  const View& outline_view() const { return outline_.view; }
  Eigen::Vector2d since_outline() const { return position() - at_outline_; }

  /// dt [s] later, at the next scan.
  void predict(double dt) {
    filter_.predict(dt);
    ++missed_;
  }
  int missed() const { return missed_; }  ///< scans since it was last seen
  const MotionFilter& motion() const { return filter_; }
  /// Where `view` shows it: registered against its outline.
  Fix fix(const View& view) const;
  /// Seen again, at `time` [s], at `fix`, which is `freed` from the shift of its scan; a next
  /// outline has that shift.
  void see(double time, std::vector<Eigen::Vector3d> points, View view, const Fix& fix,
           const Fix& freed);

  /// Seen again without what was beside it in its last view: that tells no way, but later views are
  /// registered against this one.
  void see_alone(double time, std::vector<Eigen::Vector3d> points, View view);

  /// After each view: has it gone where its velocity says? If so it stands where `then`, a panorama
  /// of `time` [s], saw past, or `now` sees past where it stood. Outlines seem to move without:
  /// those of a wall that is seen bit by bit, or through a gap.
  void judge(const Panorama& then, double time, const Panorama& now);

  /// Views in which nothing else was in its segment.
  std::int64_t apart() const { return apart_; }
  /// Views since the last of those.
  std::int64_t together() const { return together_; }
  void note_company(bool shared);

 private:
  void judge_velocity();
  void take(double time, std::vector<Eigen::Vector3d> points, View view);
  void renew_outline(const Eigen::Vector2d& at);

  Ingredients ingredients_;
  std::int64_t id_;
  double since_, seen_;
  std::int64_t views_ = 1, apart_ = 1, together_ = 0;
  std::vector<Eigen::Vector3d> points_;
  View view_;
  Eigen::Vector2d at_view_;  // position when it was taken
  MotionFilter filter_;
  Outline outline_;  // views are registered against
  Eigen::Vector2d at_outline_;
  int outline_age_ = 0;  // [views]
  int missed_ = 0;
  struct Place {
    double time;                           // [s]
    std::vector<Eigen::Vector2d> columns;  // world [m]
  };
  std::vector<Place> places_;    // where it stood, of late
  bool significant_ = false;     // its velocity, at its last view
  bool gone_ = false;            // from there, since it last was at rest
  double last_significant_ = 0;  // [s]
};

/// True if both move, and one as the other: they may be parts of one thing.
bool move_alike(const TrackedObject& a, const TrackedObject& b);

}  // namespace ldm
