#pragma once
/// A reference for a run: where objects were and how they moved, from a table (no paper section;
/// docs/scores.md).
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "ldm/types.h"

namespace experiments {

struct TruthObject {
  std::int64_t id = 0;
  bool dynamic = false;                                ///< it moves at some time of the table
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre, world frame [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< world frame [m/s]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();      ///< edges along the world's axes [m]

  bool moves() const;  ///< in this frame: faster than VelocityTally::kStanding
};

struct TruthFrame {
  std::optional<double> time;  ///< [s]
  std::vector<TruthObject> objects;
};

/// Frames by number; those without a row are not judged.
using TruthTable = std::map<std::int64_t, TruthFrame>;

/// Columns in any order, with or without units in their names: frame, id, x, y, z, vx, vy, vz, and
/// `size` (one edge for all) or sx, sy, sz; optional: time_s, dynamic (0 or 1; by default 1 for an
/// object that is somewhere faster than VelocityTally::kStanding). Others are ignored.
/// @throws ldm::InvalidInput naming file, line and column.
TruthTable read_truth_table(const std::filesystem::path& file);

}  // namespace experiments
