#include "ldm/objects/object_tracker.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ldm {
namespace {

constexpr double kMemory = 4.0;    // unseen for longer, an object is forgotten [s],
constexpr int kMemoryScans = 3;    // but not before it was missed in more scans
constexpr double kFragment = 0.5;  // what was in view no longer than this may be a part [s],
constexpr std::int64_t kFragmentViews = 5;  // or was apart in less than so many views
constexpr double kLookBack = 3.0;           // how long ago an object stood elsewhere [s],
constexpr std::size_t kLeastPast = 3;       // or scans
constexpr double kGate = 0.3;               // farthest from its expected place, and twice the reach
constexpr double kLostGate = 2.0;           // of what nothing is known of yet [m]
constexpr double kClaim = 0.25;             // of the columns of the smaller

bool forgotten(const TrackedObject& object, double time) {
  const double in_view = object.seen() - object.since();
  return object.missed() > kMemoryScans &&
         time - object.seen() > std::min(kMemory, kFragment + 4 * in_view);
}

Eigen::AlignedBox2d box_of(const View& view) {
  Eigen::AlignedBox2d box;
  view.for_each_column([&](const Column& c) { box.extend(c.point); });
  return box;
}

std::size_t columns_of(const View& view) {
  std::size_t n = 0;
  view.for_each_column([&](const Column&) { ++n; });
  return n;
}

/// True if the columns of a view fit better to the object where it has gone than where it was.
bool goes_with(const TrackedObject& object, const View& view) {
  double moved = 0, stayed = 0;
  view.for_each_column([&](const Column& c) {
    moved += object.distance(c.point);
    stayed += object.distance(c.point + object.since_view());
  });
  return moved <= stayed;
}

}  // namespace

void ObjectTracker::update(double time, const Eigen::Vector3d& sensor,
                           std::span<const Eigen::Vector3d> points) {
  for (TrackedObject& object : objects_) object.predict(time - time_.value_or(time));
  time_ = time;
  sensor_ = sensor.head<2>();
  panorama_.fill(sensor_, points);
  past_.push_back({time, panorama_});
  while (past_.size() > kLeastPast && time - past_.front().time > kLookBack) {
    past_.erase(past_.begin());
  }
  segments_.find(points);

  found_.assign(objects_.size(), {});
  unclaimed_.clear();
  std::vector<Segment> segments;
  for (std::size_t s = 0; s < segments_.count(); ++s) {
    Segment segment;
    for (const std::size_t i : segments_.members(s)) segment.points.push_back(points[i]);
    segment.view = view_of(sensor_, segment.points, ingredients_.slices);
    if (segment.view.slices.empty()) continue;
    segment.claims = claims(segment.view);
    segments.push_back(std::move(segment));
  }
  leave_behind(segments);
  for (Segment& segment : segments) take(std::move(segment));
  std::vector<Segment> fresh;
  for (Segment& segment : unclaimed_) {
    if (const auto lost = lost_one(segment.view)) {
      found_[*lost].points = std::move(segment.points);
    } else {
      fresh.push_back(std::move(segment));
    }
  }
  see_found(time);
  std::vector<TrackedObject> kept;
  for (std::size_t t = 0; t < objects_.size(); ++t) {
    const bool absorbed = found_[t].fragment && objects_[t].seen() < time;
    if (!absorbed && !forgotten(objects_[t], time)) kept.push_back(std::move(objects_[t]));
  }
  objects_ = std::move(kept);
  for (Segment& segment : fresh) {
    View view = view_of_all(segment.points, false);
    objects_.emplace_back(++last_id_, time, std::move(segment.points), std::move(view),
                          ingredients_);
  }
}

/// Measure what was found, and free that from what it shares with all of the scan.
void ObjectTracker::see_found(double time) {
  struct Sighting {
    std::size_t object;
    View view;
    Fix fix;
  };
  std::vector<Sighting> sightings;
  shift_.begin(time);
  for (std::size_t t = 0; t < objects_.size(); ++t) {
    Found& found = found_[t];
    if (found.points.empty()) continue;
    View view = view_of_all(found.points, found.shared);
    if (view.slices.empty()) continue;
    objects_[t].note_company(found.shared);
    if (found.parted) {
      objects_[t].see_alone(time, std::move(found.points), std::move(view));
      continue;
    }
    const Fix fix = objects_[t].fix(view);
    if (ingredients_.shift) shift_.add(objects_[t].id(), objects_[t].motion(), fix);
    sightings.push_back({t, std::move(view), fix});
  }
  shift_.find();
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    auto& [t, view, fix] = sightings[i];
    const Fix freed = ingredients_.shift ? shift_.freed(i) : fix;
    objects_[t].see(time, std::move(found_[t].points), std::move(view), fix, freed);
  }
  for (TrackedObject& object : objects_) {
    if (object.seen() == time) {
      object.judge(past_.front().panorama, past_.front().time, panorama_);
    }
  }
}

/// An object that moves and leads into several segments has those that go with it. What stayed
/// where it was is no part of it, but was beside it, in one segment.
void ObjectTracker::leave_behind(std::vector<Segment>& segments) {
  for (std::size_t t = 0; t < objects_.size(); ++t) {
    const TrackedObject& object = objects_[t];
    if (!object.dynamic() || object.since_view().norm() < reach_) continue;
    std::vector<Segment*> going, staying;
    for (Segment& segment : segments) {
      if (std::find(segment.claims.begin(), segment.claims.end(), t) == segment.claims.end())
        continue;
      (goes_with(object, segment.view) ? going : staying).push_back(&segment);
    }
    if (going.empty()) continue;
    for (Segment* segment : staying) std::erase(segment->claims, t);
    found_[t].parted = !staying.empty();
  }
}

/// Give a segment to the objects that lead into it.
void ObjectTracker::take(Segment segment) {
  std::vector<std::size_t> owners = segment.claims;
  drop_fragments(owners);
  if (owners.empty()) {
    unclaimed_.push_back(std::move(segment));
  } else if (owners.size() == 1) {
    std::vector<Eigen::Vector3d>& points = found_[owners[0]].points;
    points.insert(points.end(), segment.points.begin(), segment.points.end());
  } else {
    share_out(segment, owners);
  }
}

/// The objects that lead to where a part of the segment is, or in part to where it is; or else
/// those whose outline does, as what hides the middle of a thing leaves two ends. What was seen
/// once may be anywhere: it claims what touches it, else see `lost_one`.
std::vector<std::size_t> ObjectTracker::claims(const View& view) const {
  const Eigen::AlignedBox2d box = box_of(view);
  const std::size_t columns = columns_of(view);
  std::vector<std::size_t> of_views, of_outlines;
  for (std::size_t t = 0; t < objects_.size(); ++t) {
    const TrackedObject& object = objects_[t];
    const double gate = object.views() == 1
                            ? reach_
                            : std::min(reach_ + 2 * object.position_sigma(), kGate + 2 * reach_);
    const auto leads_to = [&](const View& shown, const Eigen::Vector2d& way) {
      if (box.exteriorDistance(box_of(shown).translated(way)) > gate) return false;
      std::size_t near = 0;
      view.for_each_column(
          [&](const Column& c) { near += shown.distance(c.point - way) < gate ? 1 : 0; });
      const std::size_t fewer = std::min(columns, columns_of(shown));
      return near > 0 && static_cast<double>(near) >= kClaim * static_cast<double>(fewer);
    };
    if (leads_to(object.view(), object.since_view())) {
      of_views.push_back(t);
    } else if (of_views.empty() && leads_to(object.outline_view(), object.since_outline())) {
      of_outlines.push_back(t);
    }
  }
  return of_views.empty() ? of_outlines : of_views;
}

/// Of those in one segment that were hardly ever apart, or are together for longer than they ever
/// were, or move as one, the one longest apart stays.
void ObjectTracker::drop_fragments(std::vector<std::size_t>& claims) {
  const std::vector<std::size_t> all = claims;
  std::erase_if(claims, [&](std::size_t t) {
    const TrackedObject& object = objects_[t];
    const bool fragment = std::any_of(all.begin(), all.end(), [&](std::size_t o) {
      const TrackedObject& other = objects_[o];
      const bool older = other.apart() > object.apart() ||
                         (other.apart() == object.apart() && other.id() < object.id());
      const bool hardly_apart =
          object.apart() < kFragmentViews || object.together() > object.apart();
      return older && (hardly_apart || move_alike(other, object));
    });
    found_[t].fragment |= fragment;
    return fragment;
  });
}

/// Each return to the object that leads nearest to it.
void ObjectTracker::share_out(const Segment& segment, const std::vector<std::size_t>& claims) {
  for (const std::size_t t : claims) found_[t].shared = true;
  for (const Eigen::Vector3d& p : segment.points) {
    std::size_t owner = claims[0];
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t t : claims) {
      const double distance = objects_[t].distance(p.head<2>());
      if (distance >= least) continue;
      least = distance;
      owner = t;
    }
    found_[owner].points.push_back(p);
  }
}

/// The object that was not found at its expected place and may have come here: what is fast and was
/// seen once lies far off.
std::optional<std::size_t> ObjectTracker::lost_one(const View& view) const {
  std::optional<std::size_t> nearest;
  double least = kLostGate;
  for (std::size_t t = 0; t < objects_.size(); ++t) {
    const TrackedObject& object = objects_[t];
    if (!found_[t].points.empty() || found_[t].fragment) continue;
    const Eigen::Vector2d expected = object.view().centre() + object.since_view();
    const double distance = (view.centre() - expected).norm();
    if (distance >= least || distance >= reach_ + 3 * object.position_sigma()) continue;
    least = distance;
    nearest = t;
  }
  return nearest;
}

/// Where an object was cut off another in one segment, its ends are not known.
View ObjectTracker::view_of_all(std::span<const Eigen::Vector3d> points, bool shared) const {
  View view = view_of(sensor_, points, ingredients_.slices);
  panorama_.mark_edges(view);
  if (shared || !ingredients_.edges) {
    for (Slice& slice : view.slices) slice.edges = {false, false};
  }
  return view;
}

}  // namespace ldm
