#pragma once
/// Log-odds of paper eq. 1, once more: the oracle borrows nothing from the code it checks.
#include <cmath>

namespace reference {

inline double to_log_odds(double p) {
  return std::log(p / (1 - p));
}
inline double to_probability(double l) {
  return 1 / (1 + std::exp(-l));
}

}  // namespace reference
