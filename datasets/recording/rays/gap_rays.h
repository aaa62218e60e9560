#pragma once
/// Rays that met nothing by the gaps of a range image, where a sensor's pattern is not certain: in
/// scans that were moved to one time before they were recorded (no paper section).
#include <cstdint>
#include <vector>

#include "datasets/recording/rays/ray_angles.h"
#include "ldm/types.h"

namespace datasets {

/// The image has pixels of half a degree. A pixel is in a gap if nothing returned within `kAround`
/// of azimuth and one and a half times the usual distance of two rings, between the lowest and the
/// highest returns, less the outermost hundredths of them. No rays are found
/// - in gaps narrower than `kSurface` whose two ends are about as far (see MissingRays);
/// - more than 30 degrees of azimuth from everything that returned in the scan;
/// - of a scan of few returns, or of one whose returns do not stand above each other.
///
/// It is less than MissingRays finds, and a surface that returns nothing is a gap as well.
class GapRays {
 public:
  static constexpr float kAround = 1;   ///< [deg]
  static constexpr float kSurface = 1;  ///< [m]

  /// Appends their unit directions to `rays`.
  /// @param points of one scan, in the sensor's frame; not finite or 0: no return
  /// @return false, and nothing is appended, if there are too few to tell
  bool find(const std::vector<ldm::Point>& points, std::vector<ldm::Point>& rays);

 private:
  void draw();
  int usual_distance() const;
  void spread(int rows);
  void fill_row(int row, std::vector<ldm::Point>& rays) const;
  bool in_view(int column) const;
  float& range_at(int row, int column);

  std::vector<RayAngles> returns_;
  std::vector<float> image_;        ///< ranges of the nearest returns, row by row [m]; 0: none
  std::vector<float> spread_;       ///< the same, of what is around each pixel
  std::vector<std::uint8_t> view_;  ///< columns with returns
  int lowest_ = 0, highest_ = 0;    ///< rows
};

}  // namespace datasets
