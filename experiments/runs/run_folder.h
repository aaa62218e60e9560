#pragma once
/// What `ldm run` left in its folder, read again (no paper section; docs/run-output.md).
#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace experiments {

struct RunCluster {
  std::int64_t track = 0;
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centroid, world frame [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< [m/s]
  bool dynamic = false;
};

struct RunFrame {
  double time = 0;          ///< [s]
  Eigen::AlignedBox3d map;  ///< the space that the map covered, world frame [m]
  std::vector<RunCluster> clusters;
};

/// Frames by number, from frames.csv and clusters.csv.
/// @throws ldm::InvalidInput if they cannot be read, naming file and line.
std::map<std::int64_t, RunFrame> read_run_frames(const std::filesystem::path& folder);

/// Remove what a run, and its scores, left in a folder; nothing else.
void clear_run_folder(const std::filesystem::path& folder);

}  // namespace experiments
