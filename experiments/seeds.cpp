#include "experiments/seeds.h"

#include <string>

namespace experiments {

std::uint64_t hash(std::initializer_list<std::string_view> words) {
  // FNV-1a (Fowler, Noll, Vo), each word ended by a byte that text cannot hold.
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto take = [&h](unsigned char byte) { h = (h ^ byte) * 0x100000001b3u; };
  for (const std::string_view word : words) {
    for (const char c : word) take(static_cast<unsigned char>(c));
    take(0);
  }
  // FNV's high bits mix poorly: finish as SplitMix64 does (Steele, Lea, Flood 2014).
  h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 27)) * 0x94d049bb133111ebu;
  return h ^ (h >> 31);
}

std::uint64_t scenario_seed(std::string_view scenario, std::int64_t replicate) {
  return hash({"scenario", scenario, std::to_string(replicate)});
}

std::uint64_t filter_seed(std::string_view study, std::string_view point, std::int64_t replicate,
                          std::string_view method) {
  return hash({"filter", study, point, std::to_string(replicate), method});
}

}  // namespace experiments
