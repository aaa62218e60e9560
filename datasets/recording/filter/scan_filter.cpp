#include "datasets/recording/filter/scan_filter.h"

#include <cmath>

#include "datasets/quaternion_pose.h"

namespace datasets {
namespace {

/// The vehicle's box as a test for points of the sensor.
class BodyBox {
 public:
  BodyBox(const BodyParameters& p, const ldm::Scan& scan)
      : low_(static_cast<float>(p.x_min), static_cast<float>(p.y_min), static_cast<float>(p.z_min)),
        high_(static_cast<float>(p.x_max), static_cast<float>(p.y_max),
              static_cast<float>(p.z_max)) {
    const ldm::Pose mount = composed(inverse(scan.T_world_uav), scan.T_world_sensor);
    turn_ = mount.rotation.cast<float>();
    offset_ = mount.translation.cast<float>();
  }
  /// Never in a box without volume.
  bool contains(const ldm::Point& p) const {
    const Eigen::Array3f q = (turn_ * p + offset_).array();
    return (q > low_).all() && (q < high_).all();
  }

 private:
  Eigen::Array3f low_, high_;
  Eigen::Matrix3f turn_;
  Eigen::Vector3f offset_;
};

void add(InputCounts::ByReason& counts, const char* reason, std::int64_t count) {
  if (count > 0) counts[reason] += count;
}

}  // namespace

ScanFilter::ScanFilter(std::unique_ptr<FrameSource> source, const InputParameters& parameters,
                       RaysToFind rays)
    : source_(std::move(source)), parameters_(parameters), rays_(rays) {
  check(parameters_);
  if (parameters_.ground.removal != GroundRemoval::kNone) ground_.emplace(parameters_.ground);
}

bool ScanFilter::next(Frame& frame) {
  if (!source_->next(frame)) return false;
  if (parameters_.no_returns != NoReturns::kLog) find_no_returns(frame.scan);
  drop_out_of_place(frame);
  if (ground_) drop_ground(frame);
  return true;
}

void ScanFilter::find_no_returns(ldm::Scan& scan) {
  if (scan.no_returns.empty() && rays_ != RaysToFind::kNone) {
    const bool certain =
        rays_ == RaysToFind::kAll && missing_rays_.find(scan.points, scan.no_returns);
    if (!certain && parameters_.no_returns == NoReturns::kGaps) {
      gap_rays_.find(scan.points, scan.no_returns);
    }
    counts_.no_pattern += rays_ == RaysToFind::kAll && !certain;
  }
  for (const ldm::Point& p : scan.points) {
    const double range = p.cast<double>().norm();
    if (std::isfinite(range) && range > parameters_.max_range) {
      scan.no_returns.push_back((p.cast<double>() / range).cast<float>());
    }
  }
}

void ScanFilter::drop_out_of_place(Frame& frame) {
  ldm::Scan& scan = frame.scan;
  if (!frame.kept) frame.kept.emplace();
  frame.kept->recorded = scan.points.size();
  frame.kept->was.resize(scan.points.size());
  const BodyBox body(parameters_.body, scan);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const ldm::Point p = scan.points[i];
    const double range = p.cast<double>().norm();
    if (!std::isfinite(range)) {
      ++counts_.not_finite;
    } else if (range < parameters_.min_range) {
      ++counts_.near;
    } else if (range > parameters_.max_range) {
      ++counts_.far;
    } else if (body.contains(p)) {
      ++counts_.on_vehicle;
    } else {
      frame.kept->was[kept] = static_cast<std::uint32_t>(i);
      scan.points[kept++] = p;
    }
  }
  scan.points.resize(kept);
  frame.kept->was.resize(kept);
}

void ScanFilter::drop_ground(Frame& frame) {
  ldm::Scan& scan = frame.scan;
  if (!ground_->mark(scan, is_ground_)) {
    ++counts_.no_ground;
    return;
  }
  const bool free = parameters_.ground.rays == GroundRays::kFree;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const ldm::Point p = scan.points[i];
    if (is_ground_[i] == 0) {
      frame.kept->was[kept] = frame.kept->was[i];
      scan.points[kept++] = p;
    } else {
      ++counts_.on_ground;
      if (free) scan.no_returns.push_back(p.normalized());
    }
  }
  scan.points.resize(kept);
  frame.kept->was.resize(kept);
}

InputCounts ScanFilter::counts() const {
  InputCounts counts = source_->counts();
  add(counts.points_dropped, "not finite", counts_.not_finite);
  add(counts.points_dropped, "nearer than input.min_range_m", counts_.near);
  add(counts.points_dropped, "farther than input.max_range_m", counts_.far);
  add(counts.points_dropped, "on the vehicle", counts_.on_vehicle);
  add(counts.points_dropped, "on the ground", counts_.on_ground);
  add(counts.other, MissingRays::kNotCertain, counts_.no_pattern);
  add(counts.other, InputCounts::kNoGround, counts_.no_ground);
  return counts;
}

}  // namespace datasets
