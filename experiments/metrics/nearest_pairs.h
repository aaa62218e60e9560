#pragma once
/// One-to-one assignment, nearest first (no paper section).
#include <cstddef>
#include <vector>

namespace experiments {

/// That `left` and `right` may belong together, and how well: less is better.
struct CandidatePair {
  double cost = 0;
  std::size_t left = 0, right = 0;  ///< positions in two lists
};

/// The candidates that no cheaper one excludes: each left and each right at most once, cheapest
/// first; of equally cheap ones the first. Cost: n log n.
std::vector<CandidatePair> nearest_pairs(std::vector<CandidatePair> candidates);

}  // namespace experiments
