#pragma once
/// The rays that met nothing of scans whose points were measured one after the other (no paper
/// section).
#include <cstdint>
#include <vector>

#include "datasets/input_counts.h"
#include "datasets/recording/rays/missing_rays.h"
#include "datasets/recording/scans/deskew.h"

namespace datasets {

/// For readers of such scans: before their points are moved to the time of the scan.
class ScanRays {
 public:
  /// @param sought false: there never are any
  explicit ScanRays(bool sought) : sought_(sought) {}

  /// Those of MissingRays, and when each was fired: rays of which that is not known are left out.
  /// @param delays of the points [s]; empty: all were measured at once
  TimedRays of(const std::vector<ldm::Point>& points, const std::vector<float>& delays,
               const LostAzimuths& lost = {});

  /// Adds scans whose pattern was not certain to the reasons for what is counted.
  void count(InputCounts::ByReason& reasons) const;

 private:
  bool sought_;
  MissingRays missing_rays_;
  std::int64_t without_pattern_ = 0;
};

}  // namespace datasets
