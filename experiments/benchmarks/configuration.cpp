#include "experiments/benchmarks/configuration.h"

#include <algorithm>
#include <thread>

namespace benchmarks {
namespace {

constexpr char kLdm[] = "ldm";
constexpr std::int64_t kFewParticles = 200'000;  // the paper's number
constexpr std::int64_t kManyParticles = 1'000'000;
constexpr Pattern kFewRays{16, 1024};  // the paper's LiDAR
constexpr Pattern kManyRays{64, 2048};

/// Of the growth over threads: powers of two, and all cores.
std::vector<std::int64_t> thread_counts() {
  const auto cores = static_cast<std::int64_t>(std::thread::hardware_concurrency());
  std::vector<std::int64_t> counts{1, 2};
  for (std::int64_t n = 4; n < cores; n *= 2) counts.push_back(n);
  if (cores > 2) counts.push_back(cores);
  return counts;
}

class List {
 public:
  void add(const Configuration& c) {
    if (std::find(all_.begin(), all_.end(), c) == all_.end()) all_.push_back(c);
  }
  /// With the two bounds of as many particles and threads.
  void add_bounded(const Configuration& c) {
    add(c);
    for (const char* bound : {kBoundCache, kBoundMemory}) {
      add({bound, 0, c.particles, {0, 0}, c.threads});
    }
  }
  std::vector<Configuration> all_;
};

void add_targets(List& list) {
  for (const std::int64_t threads : {1, 2}) {
    for (const Pattern& pattern : {kFewRays, kManyRays}) {
      list.add_bounded({kLdm, 32, kFewParticles, pattern, threads});
      list.add_bounded({kLdm, 128, kManyParticles, pattern, threads});
    }
  }
  list.add({"plain_ldm", 32, kFewParticles, kFewRays, 1});
  list.add({"circular_buffer_pf", 32, kFewParticles, kFewRays, 1});
  for (const int edge : {32, 128}) {
    list.add({"circular_buffer", edge, 0, kFewRays, 1});
    list.add({"octomap", edge, 0, kFewRays, 1});
    list.add({kLibOctomap, edge, 0, kFewRays, 1});
  }
  list.add({kSimulate, 0, 0, kFewRays, 1});
}

void add_growth(List& list) {
  // 160^3 voxels are as many as 256 x 256 x 64.
  for (const int edge : {64, 128, 160}) list.add_bounded({kLdm, edge, kFewParticles, kFewRays, 1});
  for (const std::int64_t particles : {50'000, 500'000, 1'000'000}) {
    list.add_bounded({kLdm, 32, particles, kFewRays, 1});
  }
  for (const Pattern& pattern : {Pattern{16, 256}, Pattern{64, 1024}}) {
    list.add_bounded({kLdm, 32, kFewParticles, pattern, 1});
  }
  for (const std::int64_t threads : thread_counts()) {
    list.add_bounded({kLdm, 32, kFewParticles, kFewRays, threads});
    list.add_bounded({kLdm, 128, kManyParticles, kFewRays, threads});
  }
}

}  // namespace

std::string Configuration::name() const {
  const auto number_or_none = [](std::int64_t n) { return n == 0 ? "-" : std::to_string(n); };
  const std::string rays = pattern.channels == 0 ? "-"
                                                 : std::to_string(pattern.channels) + "x" +
                                                       std::to_string(pattern.azimuths);
  return subject + "/" + (edge == 0 ? "-" : std::to_string(edge) + "^3") + "/" +
         number_or_none(particles) + "/" + rays + "/" + std::to_string(threads);
}

std::vector<Configuration> configurations(const std::vector<std::string>& prefixes) {
  List list;
  add_targets(list);
  add_growth(list);
  if (!prefixes.empty()) {
    std::erase_if(list.all_, [&](const Configuration& c) {
      return std::none_of(prefixes.begin(), prefixes.end(),
                          [&](const std::string& prefix) { return c.name().starts_with(prefix); });
    });
  }
  return list.all_;
}

}  // namespace benchmarks
