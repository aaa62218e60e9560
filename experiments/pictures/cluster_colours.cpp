#include "experiments/pictures/cluster_colours.h"

#include <algorithm>

#include "ldm/cluster_tracker.h"

namespace experiments {

std::vector<std::size_t> ClusterColours::next(double time,
                                              const std::vector<ldm::Cluster>& clusters) {
  ++frame_;
  std::erase_if(seen_, [&](const auto& entry) {
    return time - entry.second.time > ldm::ClusterTracker::kMemory &&
           frame_ - entry.second.frame > ldm::ClusterTracker::kMemoryFrames;
  });
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const auto known = seen_.find(clusters[c].id);
    if (known == seen_.end()) continue;
    known->second.time = time;
    known->second.frame = frame_;
    known->second.voxels = clusters[c].voxels;
  }
  std::vector<std::size_t> colour_of;
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    const auto known =
        seen_.try_emplace(clusters[c].id, time, frame_, clusters[c].voxels, rarest()).first;
    colour_of.push_back(known->second.colour);
  }
  return colour_of;
}

std::size_t ClusterColours::rarest() const {
  std::vector<std::int64_t> voxels(colours_);
  for (const auto& [id, seen] : seen_) voxels[seen.colour] += seen.voxels;
  return static_cast<std::size_t>(std::min_element(voxels.begin(), voxels.end()) - voxels.begin());
}

}  // namespace experiments
