#include "experiments/runs/saved_maps.h"

#include <cstdio>

#include "baselines/octomap_file.h"
#include "datasets/files/partial_file.h"
#include "datasets/files/text.h"
#include "experiments/metrics/truth_grid.h"
#include "experiments/pictures/map_picture.h"
#include "experiments/runs/ply_file.h"

namespace experiments {
namespace {

constexpr Colour kFree{200, 220, 235};

std::string name_of(std::int64_t frame) {
  char name[40];
  std::snprintf(name, sizeof name, "frame_%06lld", static_cast<long long>(frame));
  return name;
}

void write_ply_file(const std::vector<PlyVertex>& vertices, const std::string& comment,
                    const std::filesystem::path& name) {
  datasets::PartialFile file(name);
  write_ply(vertices, comment, file.stream());
  file.commit();
}

}  // namespace

std::filesystem::path occupied_ply(const std::filesystem::path& folder, std::int64_t frame) {
  return folder / (name_of(frame) + ".occupied.ply");
}

SavedMaps::SavedMaps(const SavedMapsRequest& request, std::filesystem::path folder)
    : frames_(request.frames.begin(), request.frames.end()),
      folder_(std::move(folder)),
      colours_(kClusterColours) {
  for (const std::string& format : request.formats) {
    if (format == "ply") {
      ply_ = true;
    } else if (format == "bt") {
      bt_ = true;
    } else {
      throw ldm::InvalidInput("--save-as " + format + ": allowed: ply, bt" +
                              datasets::did_you_mean(format, {"ply", "bt"}));
    }
  }
}

void SavedMaps::add(const datasets::Frame& frame, const ldm::LocalMap& map) {
  if (frames_.empty()) return;
  const std::vector<std::size_t> colours = colours_.next(frame.scan.time, map.clusters);
  if (frames_.erase(frame.index) == 0) return;
  try {
    write_files(frame, map, colours);
  } catch (const std::exception&) {
    if (!failure_) failure_ = std::current_exception();
  }
}

void SavedMaps::write_files(const datasets::Frame& frame, const ldm::LocalMap& map,
                            const std::vector<std::size_t>& colours) const {
  datasets::make_folder(folder_);
  const std::string name = name_of(frame.index);
  if (ply_) write_ply_files(frame, map, colours, name);
  if (bt_) {
    datasets::PartialFile file(folder_ / (name + ".bt"));
    baselines::write_bt(map, datasets::origin_text(frame), file.stream());
    file.commit();
  }
}

void SavedMaps::write_ply_files(const datasets::Frame& frame, const ldm::LocalMap& map,
                                const std::vector<std::size_t>& colours,
                                const std::string& name) const {
  std::vector<PlyVertex> occupied, free;
  for_each_voxel(map.window, [&](const ldm::VoxelIndex& v, std::size_t i) {
    const float p = map.occupancy[i];
    if (p == ldm::kUnknown) return;
    const Eigen::Vector3d centre = (v.cast<double>().array() + 0.5) * map.resolution;
    PlyVertex vertex{centre.cast<float>(), ldm::is_occupied(p) ? kNoClusterColour : kFree, p, 0};
    const auto cluster = static_cast<std::size_t>(map.labels[i]);
    if (map.labels[i] >= 0 && map.clusters[cluster].id != 0) {
      vertex.colour = cluster_colour(colours[cluster]);
      vertex.track = static_cast<std::int32_t>(map.clusters[cluster].id);
    }
    (ldm::is_occupied(p) ? occupied : free).push_back(vertex);
  });
  write_ply_file(occupied, datasets::origin_text(frame), occupied_ply(folder_, frame.index));
  write_ply_file(free, datasets::origin_text(frame), folder_ / (name + ".free.ply"));
}

void SavedMaps::check_complete() const {
  if (failure_) std::rethrow_exception(failure_);
  if (frames_.empty()) return;
  throw ldm::InvalidInput("--save-frames " + std::to_string(*frames_.begin()) +
                          ": allowed: frames of the run, which had none of this number");
}

}  // namespace experiments
