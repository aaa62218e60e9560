#pragma once
/// The table of scores: name, unit, and how each follows from the counts (experiments/RECORD.md).
#include <optional>
#include <span>
#include <string_view>

#include "experiments/metrics/ghost_score.h"
#include "experiments/metrics/identity_score.h"
#include "experiments/metrics/mover_score.h"
#include "experiments/metrics/occupancy_score.h"
#include "experiments/metrics/velocity_score.h"

namespace experiments {

struct Tallies {
  OccupancyTally occupancy;
  GhostTally ghosts;
  VelocityTally velocity;  ///< stays empty for a method without clusters
  IdentityTally identity;  ///< the same
  MoverTally movers;       ///< of such a method the occupancy alone
};

/// One row. The value is absent where the score is not defined.
struct Score {
  std::string_view name;  ///< unit at its end
  std::optional<double> (*value)(const Tallies&);
};

/// In the order of the record. A new score is one function and its row.
std::span<const Score> scores();

}  // namespace experiments
