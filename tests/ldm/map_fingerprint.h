#pragma once
/// One number for the whole state of a map: equal numbers, equal bits.
#include <bit>
#include <cstdint>

#include "ldm/local_dynamic_map.h"

namespace ldm {

/// FNV-1a over words (Fowler, Noll and Vo).
class Fingerprint {
 public:
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 1099511628211ULL; }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

/// Goes over all particles, log-odds and clusters.
inline std::uint64_t fingerprint(const LocalDynamicMap& map) {
  Fingerprint print;
  for (const Particle& p : map.particles().all()) {
    for (const int part : {int{p.x}, int{p.y}, int{p.z}, int{p.vx}, int{p.vy}, int{p.vz}}) {
      print.add(static_cast<std::uint64_t>(part));
    }
    print.add(p.slot);
  }
  for (const float l : map.log_odds().cells()) print.add(std::bit_cast<std::uint32_t>(l));
  LocalMap local;
  map.read(local);
  for (const Cluster& c : local.clusters) {
    for (const float v : c.velocity) print.add(std::bit_cast<std::uint32_t>(v));
  }
  return print.value();
}

}  // namespace ldm
