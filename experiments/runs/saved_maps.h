#pragma once
/// The occupied and free voxels of chosen frames of a run, as files (no paper section;
/// docs/run-output.md).
#include <cstdint>
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

/// Writes frame_NUMBER.occupied.ply and frame_NUMBER.free.ply, and frame_NUMBER.bt.
class SavedMaps {
 public:
  /// @param folder made when the first map is saved
  /// @throws ldm::InvalidInput on another format than ply and bt.
  SavedMaps(const SavedMapsRequest& request, std::filesystem::path folder);

  /// To be called for every frame: colours follow the clusters from frame to frame.
  /// @param tracks of the clusters, see ClusterTracks
  /// @throws ldm::InvalidInput if the folder cannot be written.
  void add(const datasets::Frame& frame, const ldm::LocalMap& map,
           const std::vector<std::int64_t>& tracks);

  /// @throws ldm::InvalidInput if a frame that was asked for did not come.
  void check_complete() const;

 private:
  void write_ply_files(const ldm::LocalMap& map, const std::vector<std::int64_t>& tracks,
                       const std::vector<std::size_t>& colours, const std::string& name) const;

  std::set<std::int64_t> frames_;  ///< still to come
  std::filesystem::path folder_;
  bool ply_ = false, bt_ = false;
  ClusterColours colours_;
};

}  // namespace experiments
