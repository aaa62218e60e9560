#pragma once
/// The occupied and free voxels of chosen frames of a run, as files (no paper section;
/// docs/run-output.md).
#include <cstdint>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "datasets/frame.h"
#include "experiments/pictures/cluster_colours.h"

namespace experiments {

struct SavedMapsRequest {
  std::vector<std::int64_t> frames;  ///< their numbers
  std::vector<std::string> formats{"ply", "bt"};
};

/// The file in `folder` of a frame's occupied voxels.
std::filesystem::path occupied_ply(const std::filesystem::path& folder, std::int64_t frame);

/// Writes frame_NUMBER.occupied.ply and frame_NUMBER.free.ply, and frame_NUMBER.bt.
class SavedMaps {
 public:
  /// @param folder made when the first map is saved
  /// @throws ldm::InvalidInput on another format than ply and bt.
  SavedMaps(const SavedMapsRequest& request, std::filesystem::path folder);

  /// To be called for every frame: colours follow the clusters from frame to frame.
  /// A map that cannot be written costs no frame of the run: `check_complete` tells.
  void add(const datasets::Frame& frame, const ldm::LocalMap& map);

  /// @throws ldm::InvalidInput if a frame that was asked for did not come, or what kept the first
  /// map from being written.
  void check_complete() const;

 private:
  void write_files(const datasets::Frame& frame, const ldm::LocalMap& map,
                   const std::vector<std::size_t>& colours) const;
  void write_ply_files(const datasets::Frame& frame, const ldm::LocalMap& map,
                       const std::vector<std::size_t>& colours, const std::string& name) const;

  std::set<std::int64_t> frames_;  ///< still to come
  std::filesystem::path folder_;
  bool ply_ = false, bt_ = false;
  ClusterColours colours_;
  std::exception_ptr failure_;  ///< the first
};

}  // namespace experiments
