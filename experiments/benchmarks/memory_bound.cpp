#include "experiments/benchmarks/memory_bound.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace benchmarks {
namespace {

constexpr std::size_t kBuffersAtOnce = 5;  // that three passes touch
constexpr std::size_t kTimesTheCache = 4;  // between two uses of a buffer
constexpr std::size_t kCacheIfUnknown = 64 << 20;

}  // namespace

std::size_t largest_cache() {
  std::size_t largest = 0;
  for (int index = 0;; ++index) {
    std::ifstream file("/sys/devices/system/cpu/cpu0/cache/index" + std::to_string(index) +
                       "/size");
    std::size_t kibibytes = 0;  // the kernel writes, for instance, 32768K
    if (!(file >> kibibytes)) break;
    largest = std::max(largest, kibibytes * 1024);
  }
  return largest > 0 ? largest : kCacheIfUnknown;
}

MemoryBound::MemoryBound(State state, std::int64_t particles, std::int64_t threads)
    : state_(state), parallel_(threads) {
  const auto n = static_cast<std::size_t>(particles);
  std::size_t buffers = 2;
  if (state == State::kFromMemory) {
    buffers = kBuffersAtOnce + kTimesTheCache * largest_cache() / (n * sizeof(Particle));
  }
  ring_.assign(buffers, Buffer(n));
}

void MemoryBound::visit_pages() const {
  constexpr std::size_t kPage = 4096 / sizeof(Particle);
  [[maybe_unused]] volatile std::uint32_t word = 0;  // so that the compiler keeps the reads
  for (std::size_t i = 0; i < std::min(kBuffersAtOnce, ring_.size()); ++i) {
    const Buffer& buffer = after_next(i);
    for (std::size_t p = 0; p < buffer.size(); p += kPage) {
      word = buffer[p].words[0];
    }
  }
}

void MemoryBound::step() {
  if (state_ == State::kCached) {
    pass(ring_[0]);
    copy(ring_[0], ring_[1]);
    copy(ring_[1], ring_[0]);
    return;
  }
  pass(next());
  for (int i = 0; i < 2; ++i) {
    const Buffer& from = next();
    copy(from, next());
  }
}

MemoryBound::Buffer& MemoryBound::next() {
  next_ = (next_ + 1) % ring_.size();
  return ring_[next_];
}

void MemoryBound::pass(Buffer& buffer) const {
  parallel_.for_each_part([&](int part) {
    const auto [begin, end] = parallel_.share(part, buffer.size());
    for (std::size_t i = begin; i < end; ++i) {
      for (std::uint32_t& word : buffer[i].words) word += 1;
    }
  });
}

void MemoryBound::copy(const Buffer& from, Buffer& to) const {
  parallel_.for_each_part([&](int part) {
    const auto [begin, end] = parallel_.share(part, from.size());
    std::copy(from.data() + begin, from.data() + end, to.data() + begin);
  });
}

}  // namespace benchmarks
