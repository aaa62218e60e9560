#include "experiments/cluster_colours.h"

#include <algorithm>

namespace experiments {
namespace {

constexpr double kMemory = 1.0;  // [s]: an occluded object comes back in its colour
constexpr float kNearby = 0.6F;  // [m]: about the width of a person

struct Pair {
  float distance;
  std::size_t seen, cluster;
};

}  // namespace

std::vector<std::size_t> ClusterColours::next(double time,
                                              const std::vector<ldm::Cluster>& clusters) {
  std::erase_if(seen_, [&](const Seen& s) { return time - s.time > kMemory; });
  std::vector<Pair> pairs;
  for (std::size_t s = 0; s < seen_.size(); ++s) {
    const ldm::Cluster& old = seen_[s].cluster;
    const ldm::Point expected =
        old.position + static_cast<float>(time - seen_[s].time) * old.velocity;
    for (std::size_t c = 0; c < clusters.size(); ++c) {
      const float distance = (clusters[c].position - expected).norm();
      if (distance < kNearby) pairs.push_back({distance, s, c});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });

  std::vector<std::size_t> colour_of(clusters.size(), colours_);
  std::vector<bool> taken(seen_.size());
  for (const Pair& pair : pairs) {
    if (taken[pair.seen] || colour_of[pair.cluster] != colours_) continue;
    taken[pair.seen] = true;
    colour_of[pair.cluster] = seen_[pair.seen].colour;
    seen_[pair.seen] = {time, clusters[pair.cluster], seen_[pair.seen].colour};
  }
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    if (colour_of[c] != colours_) continue;
    colour_of[c] = rarest();
    seen_.push_back({time, clusters[c], colour_of[c]});
  }
  return colour_of;
}

std::size_t ClusterColours::rarest() const {
  std::vector<std::int64_t> voxels(colours_);
  for (const Seen& s : seen_) voxels[s.colour] += s.cluster.voxels;
  return static_cast<std::size_t>(std::min_element(voxels.begin(), voxels.end()) - voxels.begin());
}

}  // namespace experiments
