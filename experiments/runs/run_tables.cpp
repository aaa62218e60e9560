#include "experiments/runs/run_tables.h"

#include <algorithm>
#include <cstdio>

namespace experiments {
namespace {

/// Appends numbers with commas in front, to 0.1 mm or 0.1 mm/s.
class Row {
 public:
  Row(const datasets::Frame& frame, std::ostream& out) : out_(out), origin_(frame.origin) {
    out_ << frame.index;
    add("%.6f", frame.scan.time);
  }
  ~Row() { out_ << '\n'; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  void add(std::int64_t value) { out_ << ',' << value; }
  template <class Vector>
  void add(const Vector& v) {
    for (int i = 0; i < 3; ++i) add("%.4f", static_cast<double>(v[i]));
  }
  /// A place of the frame's world, with the origin of that.
  template <class Vector>
  void add_place(const Vector& v) {
    if (origin_.isZero()) return add(v);
    add(Eigen::Vector3d(v.template cast<double>() + origin_));
  }

 private:
  void add(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    out_ << ',' << text;
  }

  std::ostream& out_;
  Eigen::Vector3d origin_;
};

/// How many returns of the scan lie in voxels of each cluster.
std::vector<std::int64_t> points_of_clusters(const ldm::Scan& scan, const ldm::LocalMap& map) {
  std::vector<std::int64_t> points(map.clusters.size());
  for (const ldm::Point& p : scan.points) {
    const ldm::VoxelIndex v = ldm::voxel_at(scan.T_world_sensor * p.cast<double>(), map.resolution);
    if (!map.window.contains(v)) continue;
    const std::int32_t label = map.labels[map.window.index(v)];
    if (label >= 0) ++points[static_cast<std::size_t>(label)];
  }
  return points;
}

}  // namespace

void write_clusters(const datasets::Frame& frame, const ldm::LocalMap& map,
                    const std::vector<std::int64_t>& tracks, std::ostream& out) {
  const std::vector<std::int64_t> points = points_of_clusters(frame.scan, map);
  for (std::size_t i = 0; i < map.clusters.size(); ++i) {
    const ldm::Cluster& c = map.clusters[i];
    Row row(frame, out);
    row.add(static_cast<std::int64_t>(i));
    row.add(tracks[i]);
    row.add_place(c.position);
    row.add(c.size);
    row.add(c.velocity);
    row.add(std::int64_t{c.voxels});
    row.add(points[i]);
    row.add(std::int64_t{c.dynamic});
  }
}

void write_frame(const datasets::Frame& frame, const ldm::LocalMap& map, std::ostream& out) {
  Row row(frame, out);
  row.add_place(frame.scan.T_world_uav.translation);
  row.add_place(Eigen::Vector3d(map.window.origin.cast<double>() * map.resolution));
  row.add(Eigen::Vector3d(map.window.size.cast<double>() * map.resolution));
  row.add(static_cast<std::int64_t>(frame.scan.points.size()));
  row.add(static_cast<std::int64_t>(map.clusters.size()));
  row.add(map.dynamic_clusters());
}

void write_timing(const std::vector<std::int64_t>& frames, const StageClock& clock,
                  std::ostream& out) {
  out << "frame";
  for (const StageClock::Stage& stage : clock.stages()) out << ',' << stage.name << "_ms";
  out << ",total_ms\n";
  for (std::size_t i = 0; i < frames.size(); ++i) {
    out << frames[i];
    for (const StageClock::Stage& stage : clock.stages()) out << ',' << stage.ms[i];
    out << ',' << clock.totals()[i] << '\n';
  }
}

}  // namespace experiments
