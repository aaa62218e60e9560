#include "ldm/occupancy_update.h"

#include <algorithm>
#include <cstring>

#include "ldm/log_odds.h"
#include "ldm/measurement_flags.h"

namespace ldm {
namespace {

constexpr int kStretch = 16;  // voxels looked at as one

UInt8x16 bytes_at(const std::uint8_t* bytes) {
  UInt8x16 lanes;
  std::memcpy(&lanes, bytes, kStretch);
  return lanes;
}

}  // namespace

MeasurementLogOdds::MeasurementLogOdds(const SensorModelParameters& p)
    : occupied(static_cast<float>(log_odds(p.p_occ))),
      free(static_cast<float>(log_odds(p.p_free))) {}

OccupancyUpdate::OccupancyUpdate(const MapParameters& map, const SensorModelParameters& sensor,
                                 const SurvivalParameters& survival, std::int64_t threads)
    : clamps_{static_cast<float>(sensor.log_odds_min), static_cast<float>(sensor.log_odds_max)},
      parallel_(threads) {
  const MeasurementLogOdds z(sensor);
  change_.fill({1, 0});
  change_[flag::kFree].gain = z.free;
  change_[flag::kOccupied].gain = z.occupied;
  if (!survival.enabled) return;
  change_[flag::kNone].survival = static_cast<float>(survival.outside_view);
  for (int f = 1; f <= flag::kShadow; ++f) {
    const auto code = static_cast<std::uint8_t>(f);
    const double behind = flag::shadow_distance(code) * map.resolution;  // [m]
    change_[code].survival = static_cast<float>(
        survival.shadow * std::min(1.0, survival.shadow_range / std::max(behind, 1e-9)));
  }
}

void OccupancyUpdate::apply(std::span<const std::uint8_t> flags, std::span<const std::uint8_t> kept,
                            RingBuffer<float>& log_odds) const {
  const auto layers = static_cast<std::size_t>(log_odds.index().window().size.z());
  parallel_.for_each_part([&](int part) {
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
  std::array<std::uint8_t, RingIndex::kMostVoxels> in_slots{};
  for (int z = begin; z < end; ++z) {
    for (int y = 0; y < n.y(); ++y, row_flags += n.x()) {
      const std::size_t row = row_slot(index, y, z);
      for (const RowPiece& piece : row_pieces(index, 0, n.x(), y, z)) {
        std::copy_n(row_flags + piece.x, piece.length, &in_slots[piece.slot - row]);
      }
      apply_to_row(n.x(), in_slots.data(), kept.empty() ? nullptr : kept.data() + row, cells + row);
    }
  }
}

/// All of it in slots: a row wraps, and would leave more than one rest that no stretch fills. A
/// look at all flags of a stretch, then vectors of log-odds.
void OccupancyUpdate::apply_to_row(int n, const std::uint8_t* flags, const std::uint8_t* kept,
                                   float* l) const {
  int x = 0;
  for (; x + kStretch <= n; x += kStretch) {
    const UInt8x16 stretch = bytes_at(flags + x);
    const bool one_flag = is_zero(stretch ^ stretch[0]);
    if (one_flag && change_[stretch[0]].is_none()) continue;
    if (kept != nullptr && !is_zero(bytes_at(kept + x))) {
      apply_to_each(x, x + kStretch, flags, kept, l);
    } else if (one_flag) {
      change_stretch(change_[stretch[0]], l + x);
    } else {
      change_stretch(stretch, l + x);
    }
  }
  apply_to_each(x, n, flags, kept, l);
}

void OccupancyUpdate::apply_to_each(int begin, int end, const std::uint8_t* flags,
                                    const std::uint8_t* kept, float* l) const {
  for (int x = begin; x < end; ++x) {
    const Change change = change_[flags[x]];
    if (change.is_none()) continue;
    const bool stays = kept != nullptr && kept[x] != 0;
    l[x] = clamps_.changed(l[x], {stays ? 1.0F : change.survival, change.gain});
  }
}

/// The change and the clamps are copies: the compiler knows that the loop does not write them.
void OccupancyUpdate::change_stretch(Change change, float* l) const {
  const Clamps clamps = clamps_;
  for (int i = 0; i < kStretch; ++i) l[i] = clamps.changed(l[i], change);
}

void OccupancyUpdate::change_stretch(UInt8x16 flags, float* l) const {
  const Clamps clamps = clamps_;
  std::array<float, kStretch> survivals{};
  std::array<float, kStretch> gains{};
  for (int i = 0; i < kStretch; i += 4) {
    // Four changes in two registers, then what they have in common side by side.
    const auto a = reinterpret_cast<Float32x4>(Int64x2{bytes_of(flags[i]), bytes_of(flags[i + 1])});
    const auto b =
        reinterpret_cast<Float32x4>(Int64x2{bytes_of(flags[i + 2]), bytes_of(flags[i + 3])});
    const Float32x4 p_s = __builtin_shufflevector(a, b, 0, 2, 4, 6);
    const Float32x4 l_z = __builtin_shufflevector(a, b, 1, 3, 5, 7);
    std::memcpy(&survivals[i], &p_s, sizeof p_s);
    std::memcpy(&gains[i], &l_z, sizeof l_z);
  }
  for (int i = 0; i < kStretch; ++i) {
    const Change change{survivals[i], gains[i]};
    const float after = clamps.changed(l[i], change);
    l[i] = change.is_none() ? l[i] : after;
  }
}

/// The change of a flag in one load.
std::int64_t OccupancyUpdate::bytes_of(std::uint8_t flag) const {
  std::int64_t bytes = 0;
  static_assert(sizeof bytes == sizeof(Change));
  std::memcpy(&bytes, &change_[flag], sizeof bytes);
  return bytes;
}

}  // namespace ldm
