#pragma once
/// B3: what one frame of the particle filter costs if only moving its memory cost anything (no
/// paper section).
#include <cstdint>
#include <vector>

#include "ldm/machine/parallel.h"

namespace benchmarks {

/// One in-place pass and two copies of a particle state of 16 bytes a particle: a prediction, a
/// sort by voxel and a resampling cannot do with less.
class MemoryBound {
 public:
  enum class State {
    kCached,      ///< the same two buffers every time: whatever cache they fit in holds them
    kFromMemory,  ///< each pass over buffers that all caches have forgotten
  };
  MemoryBound(State state, std::int64_t particles, std::int64_t threads);

  /// Read a word of each page that the next step goes over: pages that lay untouched for seconds
  /// may cost a virtual machine a fault each, which no memory is to blame for.
  void visit_pages() const;
  /// The three passes.
  void step();

 private:
  struct Particle {
    std::uint32_t words[4];
  };
  using Buffer = std::vector<Particle>;

  const Buffer& after_next(std::size_t i) const { return ring_[(next_ + 1 + i) % ring_.size()]; }
  void pass(Buffer& buffer) const;
  void copy(const Buffer& from, Buffer& to) const;
  Buffer& next();

  State state_;
  ldm::Parallel parallel_;
  std::vector<Buffer> ring_;
  std::size_t next_ = 0;
};

/// Size of the largest cache of a core, as the kernel tells it, or a guess [bytes].
std::size_t largest_cache();

}  // namespace benchmarks
