#pragma once
/// Which colour each cluster has in a picture: the same from frame to frame (no paper section).
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "ldm/types.h"

namespace experiments {

/// An object keeps its colour as long as it is followed. A new one takes the colour of the fewest
/// voxels. Colours are numbers from 0.
class ClusterColours {
 public:
  explicit ClusterColours(std::size_t colours) : colours_(colours) {}

  /// The colour of each cluster of the next frame, taken at `time` [s].
  std::vector<std::size_t> next(double time, const std::vector<ldm::Cluster>& clusters);

 private:
  struct Seen {
    double time;         ///< last seen [s]
    std::int64_t frame;  ///< and its number
    std::int32_t voxels;
    std::size_t colour;
  };

  std::size_t rarest() const;

  std::size_t colours_;
  std::int64_t frame_ = 0;
  std::map<std::int64_t, Seen> seen_;  ///< by id, each as it was last found
};

}  // namespace experiments
