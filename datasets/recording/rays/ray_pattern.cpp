#include "datasets/recording/rays/ray_pattern.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace datasets {
namespace {

constexpr float kDegree = kTurn / 360;

// Elevations from -90 to 90 degrees.
constexpr float kElevationBin = 0.02F * kDegree;
constexpr std::size_t kElevationBins = 9000;
constexpr std::int64_t kFewestReturns = 5;  // of a ring; fewer are taken for noise
constexpr std::size_t kFewestRings = 4, kMostRings = 256;
constexpr std::size_t kMostRead = 16384;  // returns of a scan that elevations are counted of

constexpr float kStepBin = 0.005F * kDegree;
constexpr float kLeastStep = 0.02F * kDegree;  // nearer ones are of the same firing
constexpr std::size_t kStepBins = 1000;        // up to 5 degrees
constexpr std::int64_t kFewestSteps = 200;

constexpr int kSectors = 72, kSectorsAround = 6;  // 30 degrees
int sector_of(float azimuth) {
  const float turns = azimuth / kTurn + 1.5F;
  return static_cast<int>(turns * kSectors) % kSectors;
}

constexpr std::size_t kTable = 8192;

/// A run of elevations with returns.
struct Blob {
  float elevation = 0;  ///< mean [rad]
  float width = 0;      ///< [rad]
};

/// Runs of bins with returns, one empty bin or more apart; without those of a few returns.
std::vector<Blob> blobs_of(const std::vector<RayPattern::Sum>& bins) {
  std::vector<Blob> blobs;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    RayPattern::Sum all;
    const std::size_t first = i;
    for (; i < bins.size() && bins[i].count > 0; ++i) all += bins[i];
    if (all.count < kFewestReturns) continue;
    blobs.push_back(
        {static_cast<float>(all.mean()), kElevationBin * static_cast<float>(i - first)});
  }
  return blobs;
}

/// The elevations of rings, or none where the blobs are none: too few, or too wide.
std::vector<float> rings_of(const std::vector<Blob>& blobs) {
  if (blobs.size() < kFewestRings || blobs.size() > kMostRings) return {};
  std::vector<float> rings{blobs.front().elevation};
  for (std::size_t i = 1; i < blobs.size(); ++i) {
    const float apart = blobs[i].elevation - blobs[i - 1].elevation;
    if (2 * std::max(blobs[i].width, blobs[i - 1].width) > apart) return {};
    rings.push_back(blobs[i].elevation);
  }
  return rings;
}

/// The bin with most.
const RayPattern::Sum& commonest_of(const std::vector<RayPattern::Sum>& bins) {
  return *std::max_element(bins.begin(), bins.end(),
                           [](const auto& a, const auto& b) { return a.count < b.count; });
}

/// How many spacings lie between two rings, or none if that is no whole number.
std::optional<int> spacings(float apart, float spacing) {
  constexpr float kInexact = 0.1F;
  const float number = apart / spacing;
  if (std::abs(number - std::round(number)) > kInexact) return {};
  return static_cast<int>(std::lround(number));
}

/// Models whose rings are evenly spaced: elevations of the first and last [deg], and how many.
struct EvenModel {
  float first, last;
  int rings;
  float spacing() const { return kDegree * (last - first) / static_cast<float>(rings - 1); }
};
constexpr EvenModel kEvenModels[] = {
    {-15, 15, 16},                        // Velodyne VLP-16
    {-30 - 2.0F / 3, 10 + 2.0F / 3, 32},  // Velodyne HDL-32E
};

/// Adds the rings without a return to an evenly spaced pattern: between the others, and those of a
/// model outside of them, too.
/// @return false, and nothing is added, if it is none
bool complete(std::vector<float>& rings) {
  if (rings.empty()) return false;
  float spacing = rings[1] - rings[0];
  for (std::size_t i = 2; i < rings.size(); ++i) {
    spacing = std::min(spacing, rings[i] - rings[i - 1]);
  }
  const std::optional<int> last = spacings(rings.back() - rings.front(), spacing);
  constexpr std::size_t kMost = 2;  // of the rings may be missing, a half
  if (!last || static_cast<std::size_t>(*last) >= kMost * rings.size()) return false;
  spacing = (rings.back() - rings.front()) / static_cast<float>(*last);
  for (const float ring : rings) {
    if (!spacings(ring - rings.front(), spacing)) return false;
  }
  float lowest = rings.front();
  int count = *last + 1;
  for (const EvenModel& model : kEvenModels) {
    const std::optional<int> below = spacings(lowest - kDegree * model.first, model.spacing());
    constexpr float kSame = 0.01F;
    const bool same = std::abs(spacing / model.spacing() - 1) < kSame;
    if (!same || !below || *below < 0 || *below + count > model.rings) continue;
    lowest = kDegree * model.first;
    spacing = model.spacing();
    count = model.rings;
    break;
  }
  rings.clear();
  for (int i = 0; i < count; ++i) rings.push_back(lowest + spacing * static_cast<float>(i));
  return true;
}

}  // namespace

RayPattern::RayPattern()
    : elevations_(kElevationBins),
      far_elevations_(kElevationBins),
      steps_(kStepBins),
      sectors_(kSectors),
      rings_(kTable),
      scan_steps_(kStepBins) {}

void RayPattern::learn(const std::vector<RayAngles>& returns) {
  const std::size_t stride = returns.size() / kMostRead + 1;
  for (std::size_t i = 0; i < returns.size(); i += stride) {
    const RayAngles& angles = returns[i];
    if (angles.range < kNearBeams) continue;
    const float elevation = std::atan(angles.slope);
    const auto bin = std::min(static_cast<std::size_t>((elevation + kTurn / 4) / kElevationBin),
                              kElevationBins - 1);
    elevations_[bin].add(elevation);
    if (angles.range > kFarFromBeams) far_elevations_[bin].add(elevation);
  }
  find_rings();
  if (slopes_.empty()) return;
  count_steps(returns);
  find_step();
}

void RayPattern::find_rings() {
  std::vector<float> rings = rings_of(blobs_of(elevations_));
  if (!complete(rings)) {
    rings = rings_of(blobs_of(far_elevations_));
    complete(rings);
  }
  slopes_.clear();
  for (const float elevation : rings) slopes_.push_back(std::tan(elevation));
  if (slopes_.empty()) return;
  std::size_t ring = 0;
  const float cell = (slopes_.back() - slopes_.front()) / kTable;
  for (std::size_t i = 0; i < kTable; ++i) {
    const float slope = slopes_.front() + (static_cast<float>(i) + 0.5F) * cell;
    while (ring + 1 < slopes_.size() && slopes_[ring] + slopes_[ring + 1] < 2 * slope) ++ring;
    rings_[i] = static_cast<std::uint16_t>(ring);
  }
}

std::size_t RayPattern::ring_of(float slope) const {
  const float share = (slope - slopes_.front()) / (slopes_.back() - slopes_.front());
  return rings_[static_cast<std::size_t>(std::clamp(share, 0.0F, 0.9999F) * kTable)];
}

void RayPattern::count_steps(const std::vector<RayAngles>& returns) {
  last_azimuth_.assign(slopes_.size(), std::numeric_limits<float>::quiet_NaN());
  scan_steps_.assign(kStepBins, {});
  std::int64_t all = 0;
  for (const RayAngles& angles : returns) {
    sectors_[static_cast<std::size_t>(sector_of(angles.azimuth))] = 1;
    float& last = last_azimuth_[ring_of(angles.slope)];
    const float apart = std::abs(within_half_a_turn(angles.azimuth - last));
    last = angles.azimuth;
    if (!(apart >= kLeastStep && apart < kStepBin * kStepBins)) continue;
    scan_steps_[static_cast<std::size_t>(apart / kStepBin)].add(apart);
    ++all;
  }
  for (std::size_t i = 0; i < kStepBins; ++i) steps_[i] += scan_steps_[i];
  scan_step_ = all < kFewestSteps ? 0 : static_cast<float>(commonest_of(scan_steps_).mean());
}

/// The commonest distance, if nearly all others are multiples of it.
void RayPattern::find_step() {
  step_ = 0;
  const Sum& commonest = commonest_of(steps_);
  if (commonest.count == 0) return;
  constexpr double kAround = 0.1, kInexact = 0.2, kNearlyAll = 0.9;
  Sum near;
  for (const Sum& bin : steps_) {
    if (bin.count > 0 && std::abs(bin.mean() / commonest.mean() - 1) < kAround) near += bin;
  }
  std::int64_t all = 0, multiples = 0;
  for (const Sum& bin : steps_) {
    if (bin.count == 0) continue;
    const double number = bin.mean() / near.mean();
    all += bin.count;
    if (number > 0.5 && std::abs(number - std::round(number)) < kInexact) multiples += bin.count;
  }
  const auto share = static_cast<double>(multiples) / static_cast<double>(all);
  if (all >= kFewestSteps && share >= kNearlyAll) step_ = static_cast<float>(near.mean());
}

bool RayPattern::holds(const std::vector<RayAngles>& returns) const {
  if (returns.empty() || !is_certain() || (scan_step_ > 0 && !is_step(scan_step_))) return false;
  std::size_t far = 0, on_rings = 0;
  std::vector<std::int64_t> returns_of_rings(slopes_.size());
  for (const RayAngles& angles : returns) {
    if (angles.range < kFarFromBeams) continue;
    ++far;
    const std::size_t ring = ring_of(angles.slope);
    ++returns_of_rings[ring];
    const float off = angles.slope - slopes_[ring];
    const bool up = off > 0 ? ring + 1 < slopes_.size() : ring == 0;
    const float apart = up ? slopes_[ring + 1] - slopes_[ring] : slopes_[ring] - slopes_[ring - 1];
    on_rings += 4 * std::abs(off) < apart;
  }
  constexpr double kNearlyAll = 0.95;
  return static_cast<double>(on_rings) >= kNearlyAll * static_cast<double>(far) &&
         are_neighbours(returns_of_rings);
}

bool RayPattern::includes(const RayPattern& other) const {
  if (!is_certain() || !is_step(other.step_)) return false;
  std::vector<std::int64_t> returns_of_rings(slopes_.size());
  for (const float slope : other.slopes_) returns_of_rings[ring_of(slope)] = kFewestReturns;
  return are_neighbours(returns_of_rings);
}

/// Of one mode of a sensor to another the step doubles, as a rule.
bool RayPattern::is_step(float step) const {
  constexpr float kSame = 0.25F;
  return std::abs(step / step_ - 1) < kSame;
}

/// False if returns are of every other ring, or of fewer still: the others are then no rings of
/// this sensor, or not any more.
bool RayPattern::are_neighbours(const std::vector<std::int64_t>& returns_of_rings) const {
  const auto used = [&](std::size_t ring) {
    return ring < returns_of_rings.size() && returns_of_rings[ring] >= kFewestReturns;
  };
  std::size_t rings = 0, neighbours = 0;
  for (std::size_t k = 0; k < returns_of_rings.size(); ++k) {
    rings += used(k);
    neighbours += used(k) && (used(k + 1) || (k > 0 && used(k - 1)));
  }
  return rings < kFewestRings || 2 * neighbours >= rings;
}

bool RayPattern::in_view(float azimuth) const {
  const int sector = sector_of(azimuth);
  for (int i = -kSectorsAround; i <= kSectorsAround; ++i) {
    if (sectors_[static_cast<std::size_t>((sector + i + kSectors) % kSectors)] != 0) return true;
  }
  return false;
}

}  // namespace datasets
