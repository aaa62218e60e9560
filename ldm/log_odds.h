#pragma once
/// Log-odds notation of occupancy: paper Sec. 3.1.
#include <cmath>

namespace ldm {

/// P / (1 - P): measurements multiply it.  Eq. (7)
inline double odds(double p) {
  return p / (1 - p);
}

/// l = log(P / (1 - P)); 0 for P = 0.5, unknown.  Eq. (1)
inline double log_odds(double p) {
  return std::log(odds(p));
}

/// P of the log-odds l: the inverse of eq. 1.
inline double probability(double l) {
  return 1 / (1 + std::exp(-l));
}

}  // namespace ldm
