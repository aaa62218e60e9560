#pragma once
/// In which directions a spinning LiDAR looks, found from its returns (no paper section).
#include <cstdint>
#include <vector>

#include "datasets/recording/rays/ray_angles.h"

namespace datasets {

/// Rings of constant elevation, fired at equal steps around the circle. Every scan adds to what is
/// known; what a sensor did before its pattern changed is not forgotten here, see MissingRays.
class RayPattern {
 public:
  /// Of angles that lie near to each other [rad].
  struct Sum {
    std::int64_t count = 0;
    double sum = 0;

    void add(float angle) {
      ++count;
      sum += static_cast<double>(angle);
    }
    void operator+=(const Sum& other) {
      count += other.count;
      sum += other.sum;
    }
    double mean() const { return sum / static_cast<double>(count); }
  };

  RayPattern();

  /// Points in the order of the recording. The beams of a real sensor do not start in its origin:
  /// if returns beyond `kNearBeams` are not on evenly spaced rings, only those beyond
  /// `kFarFromBeams` tell of elevations.
  /// Cost: one pass over the points.
  void learn(const std::vector<RayAngles>& returns);

  /// True if rings and step are certain, and `returns`, which were learned last, lie on them:
  /// returns of a sensor that moved during the scan do not, nor do those of one that does not spin,
  /// or whose pattern is not what it was.
  bool holds(const std::vector<RayAngles>& returns) const;

  /// True if rings and step are certain.
  bool is_certain() const { return !slopes_.empty() && step_ > 0; }
  /// True if scans of the other pattern, which is certain, may be of this one.
  bool includes(const RayPattern& other) const;

  /// Tangents of the rings' elevations, ascending, with those that must lie between the ones with
  /// returns: where rings are evenly spaced, or as those of a model.
  const std::vector<float>& slopes() const { return slopes_; }
  /// Position of the ring in `slopes` that is nearest. Requires rings.
  std::size_t ring_of(float slope) const;
  /// Between two firings [rad].
  float step() const { return step_; }
  /// True if anything returned within 30 degrees of this azimuth, in any scan: where nothing ever
  /// did, a sensor may not look at all.
  bool in_view(float azimuth) const;

  static constexpr float kNearBeams = 1, kFarFromBeams = 3;  ///< [m]

 private:
  void count_steps(const std::vector<RayAngles>& returns);
  void find_rings();
  void find_step();
  bool is_step(float step) const;
  bool are_neighbours(const std::vector<std::int64_t>& returns_of_rings) const;

  std::vector<Sum> elevations_, far_elevations_;  ///< returns by elevation
  std::vector<Sum> steps_;                        ///< by what they are
  std::vector<std::uint8_t> sectors_;             ///< 1: something returned
  std::vector<float> slopes_;
  std::vector<std::uint16_t> rings_;  ///< by slope, a table
  float step_ = 0;                    ///< 0: not certain
  std::vector<Sum> scan_steps_;       ///< as steps_, of the scan that was learned last
  float scan_step_ = 0;               ///< the commonest of these; 0: too few
  std::vector<float> last_azimuth_;   ///< of each ring, in one scan
};

}  // namespace datasets
