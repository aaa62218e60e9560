#pragma once
/// Which colour each cluster has in a picture: the same from frame to frame (no paper section).
#include <cstddef>
#include <vector>

#include "ldm/types.h"

namespace experiments {

/// A cluster keeps its colour while it is found again near the place its velocity leads to.
/// A new one takes the colour of the fewest voxels. Colours are numbers from 0.
class ClusterColours {
 public:
  explicit ClusterColours(std::size_t colours) : colours_(colours) {}

  /// The colour of each cluster of the next frame, taken at `time` [s].
  /// Cost: clusters times colours in use.
  std::vector<std::size_t> next(double time, const std::vector<ldm::Cluster>& clusters);

 private:
  struct Seen {
    double time;  ///< [s]
    ldm::Cluster cluster;
    std::size_t colour;
  };

  std::size_t rarest() const;

  std::size_t colours_;
  std::vector<Seen> seen_;  ///< each as it was last found
};

}  // namespace experiments
