#include "experiments/metrics/nearest_pairs.h"

#include <algorithm>
#include <set>

namespace experiments {

std::vector<CandidatePair> nearest_pairs(std::vector<CandidatePair> candidates) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
  std::set<std::size_t> lefts, rights;
  std::erase_if(candidates, [&](const CandidatePair& pair) {
    if (lefts.contains(pair.left) || rights.contains(pair.right)) return true;
    lefts.insert(pair.left);
    rights.insert(pair.right);
    return false;
  });
  return candidates;
}

}  // namespace experiments
