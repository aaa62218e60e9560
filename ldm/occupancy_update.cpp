#include "ldm/occupancy_update.h"

#include <algorithm>
#include <cstring>

#include "ldm/log_odds.h"
#include "ldm/measurement_flags.h"

namespace ldm {
namespace {

constexpr int kStretch = 16;  // voxels looked at as one
using Flags = std::array<std::uint8_t, kStretch>;

Flags flags_at(const std::uint8_t* flags) {
  Flags some;
  std::memcpy(some.data(), flags, kStretch);
  return some;
}

bool all_are(const Flags& flags, std::uint8_t value) {
  int others = 0;
  for (const std::uint8_t f : flags) others |= f ^ value;
  return others == 0;
}

bool any_is_shadow(const Flags& flags) {
  int shadows = 0;
  for (const std::uint8_t f : flags) {
    shadows |= static_cast<int>(f != flag::kNone && f <= flag::kShadow);
  }
  return shadows != 0;
}

}  // namespace

MeasurementLogOdds::MeasurementLogOdds(const SensorModelParameters& p)
    : occupied(static_cast<float>(log_odds(p.p_occ))),
      free(static_cast<float>(log_odds(p.p_free))) {}

OccupancyUpdate::OccupancyUpdate(const MapParameters& map, const SensorModelParameters& sensor,
                                 const SurvivalParameters& survival, std::int64_t threads)
    : min_(static_cast<float>(sensor.log_odds_min)),
      max_(static_cast<float>(sensor.log_odds_max)),
      parallel_(threads) {
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

void OccupancyUpdate::apply(std::span<const std::uint8_t> flags, std::span<const std::uint8_t> kept,
                            RingBuffer<float>& log_odds) const {
  const auto layers = static_cast<std::size_t>(log_odds.index().window().size.z());
  parallel_.run([&](int part) {
    const auto [begin, end] = parallel_.share(part, layers);
    apply_to_layers(static_cast<int>(begin), static_cast<int>(end), flags, kept, log_odds);
  });
}

void OccupancyUpdate::apply_to_layers(int begin, int end, std::span<const std::uint8_t> flags,
                                      std::span<const std::uint8_t> kept,
                                      RingBuffer<float>& log_odds) const {
  const RingIndex& index = log_odds.index();
  const Eigen::Vector3i& n = index.window().size;
  float* const cells = log_odds.cells().data();
  const std::uint8_t* row_flags = flags.data() + std::ptrdiff_t{begin} * n.x() * n.y();
  for (int z = begin; z < end; ++z) {
    for (int y = 0; y < n.y(); ++y, row_flags += n.x()) {
      for (const RowPiece& piece : row_pieces(index, 0, n.x(), y, z)) {
        apply_to_row(piece.length, row_flags + piece.x,
                     kept.empty() ? nullptr : kept.data() + piece.slot, cells + piece.slot);
      }
    }
  }
}

/// Most stretches of a map hold what rays met or did not, and no shadow: without a look at the
/// tables for each voxel they become vectors, which makes the stage 3 times faster at 128^3.
void OccupancyUpdate::apply_to_row(int n, const std::uint8_t* flags, const std::uint8_t* kept,
                                   float* l) const {
  int x = 0;
  for (; x + kStretch <= n; x += kStretch) {
    const Flags some = flags_at(flags + x);
    if (all_are(some, flag::kNone) && keeps(flag::kNone)) continue;
    if (any_is_shadow(some) || (kept != nullptr && !all_are(flags_at(kept + x), 0))) {
      apply_to_each(x, x + kStretch, flags, kept, l);
      continue;
    }
    const float p_s = survival(flag::kNone);
    const float free = gain_[flag::kFree];
    const float occupied = gain_[flag::kOccupied];
    const bool keeps_unmet = keeps(flag::kNone);
    for (int i = 0; i < kStretch; ++i) {
      const bool unmet = some[i] == flag::kNone;
      const float l_z = some[i] == flag::kOccupied ? occupied : some[i] == flag::kFree ? free : 0;
      const float before = l[x + i];
      const float after = measured(survived(before, unmet ? p_s : 1), l_z);
      l[x + i] = unmet && keeps_unmet ? before : after;
    }
  }
  apply_to_each(x, n, flags, kept, l);
}

void OccupancyUpdate::apply_to_each(int begin, int end, const std::uint8_t* flags,
                                    const std::uint8_t* kept, float* l) const {
  for (int x = begin; x < end; ++x) {
    if (keeps(flags[x])) continue;
    const bool stays = kept != nullptr && kept[x] != 0;
    l[x] = measured(survived(l[x], stays ? 1.0F : survival(flags[x])), gain_[flags[x]]);
  }
}

}  // namespace ldm
