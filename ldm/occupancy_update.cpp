#include "ldm/occupancy_update.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include "ldm/log_odds.h"
#include "ldm/measurement_flags.h"

namespace ldm {
namespace {

constexpr std::size_t kAhead = 256;   // voxels that are on their way from the memory
constexpr int kToWrite = 1;           // of a prefetch
constexpr std::size_t kStretch = 16;  // voxels whose flags are looked at together

UInt8x16 bytes_at(const std::uint8_t* bytes) {
  UInt8x16 lanes;
  std::memcpy(&lanes, bytes, sizeof lanes);
  return lanes;
}

/// Bytes kFirst to kFirst + 3, each in a lane of its own.
template <int kFirst>
Int32x4 four_bytes(const UInt8x16& bytes) {
  constexpr int k0 = 16;  // of the zeros
  return reinterpret_cast<Int32x4>(__builtin_shufflevector(bytes, UInt8x16{}, kFirst, k0, k0, k0,
                                                           kFirst + 1, k0, k0, k0, kFirst + 2, k0,
                                                           k0, k0, kFirst + 3, k0, k0, k0));
}

bool have_shadow(const UInt8x16& flags) {
  return !is_zero(reinterpret_cast<UInt8x16>(flags - 1 < flag::kShadow));
}

}  // namespace

/// Four voxels side by side: what OccupancyUpdate::Clamps::changed does to one. All that a loop
/// over them needs is here, so that the compiler keeps it in registers.
class OccupancyUpdate::FourVoxels {
 public:
  explicit FourVoxels(const OccupancyUpdate& update)
      : change_(update.change_),
        min_(Float32x4{} + update.clamps_.min),
        max_(Float32x4{} + update.clamps_.max),
        unseen_survival_(Float32x4{} + change_[flag::kNone].survival),
        free_(Float32x4{} + change_[flag::kFree].gain),
        occupied_(Float32x4{} + change_[flag::kOccupied].gain),
        unseen_stay_(Int32x4{} - static_cast<std::int32_t>(change_[flag::kNone].is_none())) {}

  /// Bounds are those of the values from now on.
  void restart_range() {
    low_ = Float32x4{} + LogOddsRange{}.low;
    high_ = Float32x4{} + LogOddsRange{}.high;
  }
  void include(const LogOddsRange& range) {
    include(Float32x4{} + range.low, Float32x4{} + range.high);
  }

  /// Free, occupied or unseen: comparisons tell what is to be done.
  template <int kFirst>
  void change_seen(const UInt8x16& flags, float* l) {
    const Int32x4 f = four_bytes<kFirst>(flags);
    const auto unseen = f == flag::kNone;
    const auto gain = (reinterpret_cast<Int32x4>(free_) & (f == flag::kFree)) |
                      (reinterpret_cast<Int32x4>(occupied_) & (f == flag::kOccupied));
    change(unseen ? unseen_survival_ : kOne, reinterpret_cast<Float32x4>(gain),
           unseen & unseen_stay_, l);
  }
  /// Any flags, beside static objects: `kept` is 1 there, or null.
  void change_any(const std::uint8_t* flags, const std::uint8_t* kept, float* l) {
    Float32x4 survival{};
    Float32x4 gain{};
    Int32x4 stays{};
    for (int k = 0; k < 4; ++k) {
      const Change change = change_[flags[k]];
      survival[k] = kept != nullptr && kept[k] != 0 ? 1 : change.survival;
      gain[k] = change.gain;
      stays[k] = -static_cast<std::int32_t>(change.is_none());
    }
    change(survival, gain, stays, l);
  }
  /// Of all that was changed or included. Halves are compared: four bounds one after the other
  /// would take longer than the changes.
  LogOddsRange range() {
    include(__builtin_shufflevector(low_, low_, 2, 3, 0, 1),
            __builtin_shufflevector(high_, high_, 2, 3, 0, 1));
    include(__builtin_shufflevector(low_, low_, 1, 0, 3, 2),
            __builtin_shufflevector(high_, high_, 1, 0, 3, 2));
    return {low_[0], high_[0]};
  }

 private:
  static constexpr Float32x4 kOne = {1, 1, 1, 1};

  void change(const Float32x4& survival, const Float32x4& gain, const Int32x4& stays, float* l) {
    Float32x4 before;
    std::memcpy(&before, l, sizeof before);
    const Float32x4 rest = before * survival;
    const Float32x4 sum = (rest * rest < 1e-12F ? Float32x4{} : rest) + gain;
    const Float32x4 at_least = sum < min_ ? min_ : sum;
    const Float32x4 clamped = max_ < at_least ? max_ : at_least;
    const Float32x4 after = stays ? before : clamped;
    std::memcpy(l, &after, sizeof after);
    include(after, after);
  }
  void include(const Float32x4& low, const Float32x4& high) {
    low_ = low < low_ ? low : low_;
    high_ = high > high_ ? high : high_;
  }

  const std::array<Change, 256>& change_;
  Float32x4 min_, max_, unseen_survival_, free_, occupied_;
  Int32x4 unseen_stay_;
  Float32x4 low_{}, high_{};
};

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

/// Threads share out rows in the order of their slots, as many at a time as fill whole bricks.
void OccupancyUpdate::apply(std::span<const std::uint8_t> flags, const StaticVoxels& kept,
                            RingBuffer<float>& log_odds) const {
  const VoxelBox& window = log_odds.index().window();
  const auto row = static_cast<std::size_t>(window.size.x());
  const std::size_t rows = window.count() / row;
  const std::size_t together = kBrick / std::gcd(kBrick, row);
  parallel_.for_each_part([&](int part) {
    const auto [begin, end] = parallel_.share(part, (rows + together - 1) / together);
    apply_to_rows(begin * together, std::min(end * together, rows), flags, kept, log_odds);
  });
}

void OccupancyUpdate::apply_to_rows(std::size_t begin, std::size_t end,
                                    std::span<const std::uint8_t> flags, const StaticVoxels& kept,
                                    RingBuffer<float>& log_odds) const {
  const Eigen::Vector3i offset = log_odds.index().offset();
  const auto nx = static_cast<std::size_t>(log_odds.index().window().size.x());
  const auto ny = static_cast<std::size_t>(log_odds.index().window().size.y());
  const auto nz = static_cast<std::size_t>(log_odds.index().window().size.z());
  const auto wrap = nx - static_cast<std::size_t>(offset.x());
  const auto [cells, ranges] = log_odds.contents();
  std::array<std::uint8_t, RingIndex::kMostVoxels> in_slots{};  // flags of the row at hand
  std::array<std::uint8_t, kBrick> in_brick{};                  // static objects
  FourVoxels four(*this);
  for (std::size_t row = begin; row < end; ++row) {
    const std::size_t y = (row % ny + static_cast<std::size_t>(offset.y())) % ny;
    const std::size_t z = (row / ny + static_cast<std::size_t>(offset.z())) % nz;
    const std::uint8_t* const in_window = flags.data() + (z * ny + y) * nx;
    std::copy_n(in_window + offset.x(), wrap, in_slots.begin());
    std::copy_n(in_window, offset.x(), in_slots.begin() + static_cast<std::ptrdiff_t>(wrap));
    for (std::size_t first = row * nx; first < (row + 1) * nx;) {
      const std::size_t brick = first / kBrick;
      const std::size_t last = std::min((brick + 1) * kBrick, (row + 1) * nx);
      for (std::size_t slot = first; kept.any_in(brick) && slot < last; ++slot) {
        in_brick[slot - first] = kept.at(slot) ? 1 : 0;
      }
      const Piece piece{&in_slots[first - row * nx], kept.any_in(brick) ? in_brick.data() : nullptr,
                        &cells[first], last - first};
      if (first % kBrick == 0) four.restart_range();
      if (stays(piece, ranges[brick])) {
        four.include(ranges[brick]);
      } else {
        apply_to_piece(piece, ranges[brick], four);
      }
      if (last % kBrick == 0 || last == cells.size()) ranges[brick] = four.range();
      first = last;
    }
  }
}

/// True if all voxels are left as they are, which the range of their brick tells. Static objects do
/// not matter: where survival would change nothing, neither does its absence.
bool OccupancyUpdate::stays(const Piece& piece, const LogOddsRange& range) const {
  std::size_t first = 0;
  const UInt8x16 flag = UInt8x16{} + piece.flags[0];
  UInt8x16 differences{};
  for (; first + kStretch <= piece.size; first += kStretch) {
    differences |= bytes_at(piece.flags + first) ^ flag;
  }
  for (; first < piece.size; ++first) {
    differences[0] |= static_cast<std::uint8_t>(piece.flags[first] ^ piece.flags[0]);
  }
  if (!is_zero(differences)) return false;
  const Change change = change_[piece.flags[0]];
  return change.is_none() || (range.is_one() && clamps_.changed(range.low, change) == range.low);
}

/// @param before range of the brick, for what stays in it unread
void OccupancyUpdate::apply_to_piece(const Piece& piece, const LogOddsRange& before,
                                     FourVoxels& four) const {
  const bool unseen_stay = change_[flag::kNone].is_none();
  std::size_t first = 0;
  for (; first + kStretch <= piece.size; first += kStretch) {
    const std::uint8_t* const flags = piece.flags + first;
    const std::uint8_t* const kept = piece.kept == nullptr ? nullptr : piece.kept + first;
    float* const l = piece.l + first;
    if (unseen_stay && is_zero(bytes_at(flags))) {
      four.include(before);
      continue;
    }
    __builtin_prefetch(l + kAhead, kToWrite);
    if (have_shadow(bytes_at(flags)) || (kept != nullptr && !is_zero(bytes_at(kept)))) {
      for (std::size_t i = 0; i < kStretch; i += 4) {
        four.change_any(flags + i, kept == nullptr ? nullptr : kept + i, l + i);
      }
    } else {
      four.change_seen<0>(bytes_at(flags), l);
      four.change_seen<4>(bytes_at(flags), l + 4);
      four.change_seen<8>(bytes_at(flags), l + 8);
      four.change_seen<12>(bytes_at(flags), l + 12);
    }
  }
  for (; first < piece.size; ++first) {
    float& l = piece.l[first];
    const Change change = change_[piece.flags[first]];
    const bool stays = piece.kept != nullptr && piece.kept[first] != 0;
    if (!change.is_none()) l = clamps_.changed(l, {stays ? 1 : change.survival, change.gain});
    four.include({l, l});
  }
}

}  // namespace ldm
