#pragma once
/// Log-odds of paper Sec. 3.1, once more: the oracle borrows nothing from the code it checks.
#include <cmath>

namespace ldm::plain {

/// P / (1 - P).  Eq. (7)
inline double odds(double p) {
  return p / (1 - p);
}
/// l = log(P / (1 - P)).  Eq. (1)
inline double log_odds(double p) {
  return std::log(odds(p));
}
/// P of the log-odds l.
inline double probability(double l) {
  return 1 / (1 + std::exp(-l));
}

}  // namespace ldm::plain
