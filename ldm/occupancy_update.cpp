#include "ldm/occupancy_update.h"

#include <algorithm>

#include "ldm/log_odds.h"
#include "ldm/measurement_flags.h"

namespace ldm {

MeasurementLogOdds::MeasurementLogOdds(const SensorModelParameters& p)
    : occupied(static_cast<float>(log_odds(p.p_occ))),
      free(static_cast<float>(log_odds(p.p_free))) {}

OccupancyUpdate::OccupancyUpdate(const MapParameters& map, const SensorModelParameters& sensor,
                                 const SurvivalParameters& survival)
    : min_(static_cast<float>(sensor.log_odds_min)), max_(static_cast<float>(sensor.log_odds_max)) {
  const MeasurementLogOdds z(sensor);
  factor_.fill(1);
  gain_.fill(0);
  gain_[flag::kFree] = z.free;
  gain_[flag::kOccupied] = z.occupied;
  if (!survival.enabled) return;
  factor_[flag::kNone] = static_cast<float>(survival.outside_view);
  for (int f = 1; f <= flag::kShadow; ++f) {
    const auto code = static_cast<std::uint8_t>(f);
    const double behind = flag::shadow_distance(code) * map.resolution;  // [m]
    factor_[code] = static_cast<float>(
        survival.shadow * std::min(1.0, survival.shadow_range / std::max(behind, 1e-9)));
  }
}

float OccupancyUpdate::measured(float l, float l_z) const {
  return std::clamp(l + l_z, min_, max_);
}

void OccupancyUpdate::apply(std::span<const std::uint8_t> flags, std::span<const std::uint8_t> kept,
                            RingBuffer<float>& log_odds) const {
  const RingIndex& index = log_odds.index();
  const Eigen::Vector3i& n = index.window().size;
  float* const cells = log_odds.cells().data();
  const std::uint8_t* row_flags = flags.data();
  for (int z = 0; z < n.z(); ++z) {
    for (int y = 0; y < n.y(); ++y, row_flags += n.x()) {
      for (const RowPiece& piece : row_pieces(index, 0, n.x(), y, z)) {
        float* const l = cells + piece.slot;
        const std::uint8_t* const f = row_flags + piece.x;
        const std::uint8_t* const keep = kept.empty() ? nullptr : kept.data() + piece.slot;
        for (int x = 0; x < piece.length; ++x) {
          const bool stays = keep != nullptr && keep[x] != 0;
          l[x] = measured(survived(l[x], stays ? 1.0F : survival(f[x])), gain_[f[x]]);
        }
      }
    }
  }
}

}  // namespace ldm
