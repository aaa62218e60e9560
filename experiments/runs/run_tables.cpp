#include "experiments/runs/run_tables.h"

#include <string>
#include <utility>

namespace experiments {
namespace {

// Decimals of [s], of [m] and [m/s], and of [m^2/s^2].
constexpr int kMicroseconds = 6, kTenthsOfMillimetres = 4, kSquares = 6;

/// A place of the frame's world, with the origin of that [m].
template <class Vector>
Eigen::Vector3d place(const datasets::Frame& frame, const Vector& v) {
  const Eigen::Vector3d p = v.template cast<double>();
  return frame.origin.isZero() ? p : Eigen::Vector3d(p + frame.origin);  // -0 stays -0
}

}  // namespace

void write_clusters(const datasets::Frame& frame, const ldm::LocalMap& map,
                    datasets::CsvWriter& out) {
  for (std::size_t i = 0; i < map.clusters.size(); ++i) {
    const ldm::Cluster& c = map.clusters[i];
    out.add(frame.index).add(frame.scan.time, kMicroseconds);
    out.add(static_cast<std::int64_t>(i)).add(c.id).add(c.age, kMicroseconds);
    out.add_vector(place(frame, c.position), kTenthsOfMillimetres);
    out.add_vector(c.size, kTenthsOfMillimetres).add_vector(c.velocity, kTenthsOfMillimetres);
    for (const auto& [row, column] : {std::pair(0, 0), {0, 1}, {1, 1}}) {
      out.add(static_cast<double>(c.velocity_covariance(row, column)), kSquares);
    }
    out.add(std::int64_t{c.voxels}).add(std::int64_t{c.points});
    out.add(std::int64_t{c.dynamic}).end_row();
  }
}

void write_frame(const datasets::Frame& frame, const ldm::LocalMap& map, datasets::CsvWriter& out) {
  out.add(frame.index).add(frame.scan.time, kMicroseconds);
  const Eigen::Vector3d origin = map.window.origin.cast<double>() * map.resolution;
  const Eigen::Vector3d size = map.window.size.cast<double>() * map.resolution;
  out.add_vector(place(frame, frame.scan.T_world_uav.translation), kTenthsOfMillimetres);
  out.add_vector(place(frame, origin), kTenthsOfMillimetres);
  out.add_vector(size, kTenthsOfMillimetres);
  out.add(static_cast<std::int64_t>(frame.scan.points.size()));
  out.add(static_cast<std::int64_t>(map.clusters.size())).add(map.dynamic_clusters()).end_row();
}

void write_timing(const std::vector<std::int64_t>& frames, const StageClock& clock,
                  std::ostream& out) {
  std::string header = "frame";
  for (const StageClock::Stage& stage : clock.stages())
    header.append(",").append(stage.name).append("_ms");
  datasets::CsvWriter csv(out, header + ",total_ms");
  constexpr int kDecimals = 4;  // tenths of a microsecond
  for (std::size_t i = 0; i < frames.size(); ++i) {
    csv.add(frames[i]);
    for (const StageClock::Stage& stage : clock.stages()) csv.add(stage.ms[i], kDecimals);
    csv.add(clock.totals()[i], kDecimals).end_row();
  }
}

}  // namespace experiments
