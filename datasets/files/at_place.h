#pragma once
/// The place where bad input was given, in front of what is wrong with it (no paper section).
#include <string>

#include "ldm/types.h"

namespace datasets {

/// Runs `action`. @throws ldm::InvalidInput what it throws of this kind, with `place: ` in front.
template <class Action>
void at_place(const std::string& place, Action action) {
  try {
    action();
  } catch (const ldm::InvalidInput& error) {
    throw ldm::InvalidInput(place + ": " + error.what());
  }
}

}  // namespace datasets
