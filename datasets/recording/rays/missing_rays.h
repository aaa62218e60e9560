#pragma once
/// The rays of a scan that met nothing, of which a recording says nothing: without them what has
/// left a place lingers on there (paper Sec. 3.3.2 says nothing of them).
#include <vector>

#include "datasets/recording/rays/lost_azimuths.h"
#include "datasets/recording/rays/ray_pattern.h"
#include "ldm/types.h"

namespace datasets {

/// Where in a ring of the sensor's pattern returns are farther apart than a step, rays between them
/// met nothing. There are no rays
/// - if the pattern is not certain, or this scan does not follow it (see RayPattern);
/// - in gaps narrower than `kSurface` whose two ends are about as far: one surface that returned
///   nothing, such as black paint, a window, or wet asphalt;
/// - beside near returns, whose ring is not certain (see `kBeamOffset`);
/// - in directions from which nothing has ever returned (see RayPattern::in_view), and in those
///   that are lost.
///
/// A second pattern is learned from no more than `kRenewed` scans, again and again: where it is
/// certain, and its scans are none of the pattern that all scans before have made, that one is
/// forgotten. So another mode of the sensor, or other beams, cost that many to twice as many scans.
///
/// What a sensor cannot tell, this cannot: a ray that met something nearer than the sensor's least
/// range, or a wide surface that swallows light, is one without a return.
class MissingRays {
 public:
  static constexpr float kSurface = 1.0F;      ///< [m]
  static constexpr float kBeamOffset = 0.03F;  ///< of a beam's origin from the sensor's [m]
  static constexpr int kRenewed = 20;
  /// Reason under which scans without a certain pattern are counted.
  static constexpr char kNotCertain[] = "scans whose pattern of rays is not certain";

  /// Appends their unit directions to `rays`.
  /// @param points of one scan, in the sensor's frame when each was measured; in the order of the
  ///   recording, and before any are left out; not finite or 0: no return
  /// @param lost where the recording has no measurements of this scan
  /// @return false, and nothing is appended, if the pattern is not certain
  bool find(const std::vector<ldm::Point>& points, std::vector<ldm::Point>& rays,
            const LostAzimuths& lost = {});

 private:
  /// The returns in a cell of the range image: a ring and one step of azimuth.
  struct Cell {
    float first = 0, last = 0;  ///< azimuths [rad]
    float range = 0;            ///< of the nearest [m]; 0: none
  };

  void learn();
  void draw();
  void put(std::size_t ring, const RayAngles& angles);
  void fill_ring(std::size_t ring, std::vector<ldm::Point>& rays) const;
  void fill_gap(std::size_t ring, const Cell& from, const Cell& to, float width,
                std::vector<ldm::Point>& rays) const;
  void add_rays(std::size_t ring, double azimuth, double step, int count,
                std::vector<ldm::Point>& rays) const;

  RayPattern pattern_, fresh_;
  int fresh_scans_ = 0;  ///< that fresh_ was learned from
  LostAzimuths lost_;    ///< of this scan
  std::vector<RayAngles> returns_;
  std::size_t columns_ = 0;
  std::vector<Cell> image_;  ///< ring by ring
};

}  // namespace datasets
