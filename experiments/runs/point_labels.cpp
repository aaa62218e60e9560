#include "experiments/runs/point_labels.h"

#include <bit>
#include <cstdio>
#include <fstream>

#include "datasets/files/partial_file.h"
#include "datasets/objects_hit.h"
#include "experiments/metrics/velocity_score.h"

namespace experiments {
namespace {

static_assert(std::endian::native == std::endian::little, "labels are copied as they are");

constexpr PointLabel kClass = 0xFFFF;
constexpr int kIdShift = 16;

PointLabel moving(std::int64_t id) {
  return kMovingPoint | static_cast<PointLabel>(id) << kIdShift;
}

PointLabel label_at(const Eigen::Vector3d& p, const ldm::LocalMap& map) {
  const ldm::VoxelIndex v = ldm::voxel_at(p, map.resolution);
  if (!map.window.contains(v)) return kUnlabelled;
  const std::int32_t c = map.labels[map.window.index(v)];
  if (c < 0) return kStaticPoint;
  const ldm::Cluster& cluster = map.clusters[static_cast<std::size_t>(c)];
  return cluster.dynamic ? moving(cluster.id) : kStaticPoint;
}

}  // namespace

bool is_moving(PointLabel label) {
  constexpr PointLabel kLast = 259;
  return (label & kClass) >= kMovingPoint && (label & kClass) <= kLast;
}

std::vector<PointLabel> labels_of(const datasets::Frame& frame, const ldm::LocalMap& map) {
  const std::vector<ldm::Point>& points = frame.scan.points;
  std::vector<PointLabel> labels(frame.kept ? frame.kept->recorded : points.size(), kStaticPoint);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3d p = frame.scan.T_world_sensor * points[i].cast<double>();
    labels[frame.kept ? frame.kept->was[i] : i] = label_at(p, map);
  }
  return labels;
}

std::vector<PointLabel> true_labels(const datasets::Frame& frame) {
  std::vector<PointLabel> labels;
  for (const std::int32_t owner :
       datasets::objects_hit(*frame.truth, frame.scan.T_world_sensor.translation)) {
    const bool moves =
        owner >= 0 && frame.truth->objects[static_cast<std::size_t>(owner)].velocity.norm() >
                          VelocityTally::kStanding;
    labels.push_back(moves ? moving(frame.truth->objects[static_cast<std::size_t>(owner)].id)
                           : kStaticPoint);
  }
  return labels;
}

std::filesystem::path label_file(const std::filesystem::path& folder, std::int64_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "%06lld.label", static_cast<long long>(frame));
  return folder / name;
}

void write_labels(const std::vector<PointLabel>& labels, const std::filesystem::path& file) {
  datasets::PartialFile out(file);
  out.stream().write(reinterpret_cast<const char*>(labels.data()),
                     static_cast<std::streamsize>(labels.size() * sizeof(PointLabel)));
  out.commit();
}

std::vector<PointLabel> read_labels(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) throw ldm::InvalidInput(file.string() + ": cannot be read: allowed: a file of labels");
  const auto bytes = static_cast<std::size_t>(in.tellg());
  if (bytes % sizeof(PointLabel) != 0) {
    throw ldm::InvalidInput(file.string() + ": " + std::to_string(bytes) +
                            " bytes: allowed: four for each point");
  }
  std::vector<PointLabel> labels(bytes / sizeof(PointLabel));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(labels.data()), static_cast<std::streamsize>(bytes));
  if (!in) throw ldm::InvalidInput(file.string() + ": cannot be read: allowed: a file of labels");
  return labels;
}

}  // namespace experiments
