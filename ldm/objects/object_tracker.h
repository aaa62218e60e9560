#pragma once
/// Objects from scan to scan: which returns are whose, where each is and how it moves (no paper
/// section; docs/objects.md).
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "ldm/objects/ingredients.h"
#include "ldm/objects/panorama.h"
#include "ldm/objects/scan_shift.h"
#include "ldm/objects/segments.h"
#include "ldm/objects/tracked_object.h"

namespace ldm {

/// Follows what returns hang together. It needs no map, so that nothing is too fast for it; the
/// ground has to be removed before.
class ObjectTracker {
 public:
  /// @param reach [m]: returns nearer than this belong together; for instance the map's resolution
  explicit ObjectTracker(double reach, const Ingredients& ingredients = {})
      : reach_(reach), ingredients_(ingredients), segments_(reach) {}

  /// Take the returns `points` (world [m]) of a scan at `time` [s], never decreasing, from
  /// `sensor`. Those of an object should be whole: cut them off well outside of what is of
  /// interest. Cost: the points, and the columns of each object times those of its last outline.
  void update(double time, const Eigen::Vector3d& sensor, std::span<const Eigen::Vector3d> points);

  /// All that are followed, hidden ones included, by id: seen() tells.
  const std::vector<TrackedObject>& objects() const { return objects_; }

 private:
  struct Segment {
    std::vector<Eigen::Vector3d> points;
    View view;                        // without edges
    std::vector<std::size_t> claims;  // objects that lead into it
  };
  void leave_behind(std::vector<Segment>& segments);
  void take(Segment segment);
  void see_found(double time);
  std::vector<std::size_t> claims(const View& view) const;
  void drop_fragments(std::vector<std::size_t>& claims);
  void share_out(const Segment& segment, const std::vector<std::size_t>& claims);
  std::optional<std::size_t> lost_one(const View& view) const;
  View view_of_all(std::span<const Eigen::Vector3d> points, bool shared) const;

  double reach_;
  Ingredients ingredients_;
  Segments segments_;
  Panorama panorama_;
  ScanShift shift_;
  struct Past {
    double time;  // [s]
    Panorama panorama;
  };
  std::vector<Past> past_;      // and this scan's
  std::optional<double> time_;  // of the last scan [s]
  Eigen::Vector2d sensor_ = Eigen::Vector2d::Zero();
  std::int64_t last_id_ = 0;
  std::vector<TrackedObject> objects_;

  /// What this scan shows of an object.
  struct Found {
    std::vector<Eigen::Vector3d> points;
    bool shared = false;    // with another, in one segment
    bool parted = false;    // what was beside it stayed behind
    bool fragment = false;  // a segment that it led into is another's
  };
  std::vector<Found> found_;  // per object
  std::vector<Segment> unclaimed_;
};

}  // namespace ldm
