#include "datasets/recording/rays/scan_rays.h"

#include "datasets/recording/rays/firing_times.h"

namespace datasets {

TimedRays ScanRays::of(const std::vector<ldm::Point>& points, const std::vector<float>& delays,
                       const LostAzimuths& lost) {
  TimedRays found;
  if (!sought_) return found;
  std::vector<ldm::Point> rays;
  if (!missing_rays_.find(points, rays, lost)) ++without_pattern_;
  if (delays.empty()) {
    found.rays = std::move(rays);
    return found;
  }
  const FiringTimes times(points, delays);
  for (const ldm::Point& ray : rays) {
    const auto delay = times.at(static_cast<double>(azimuth_of(ray.y(), ray.x())));
    if (!delay) continue;
    found.rays.push_back(ray);
    found.delays.push_back(*delay);
  }
  return found;
}

void ScanRays::count(InputCounts::ByReason& reasons) const {
  if (without_pattern_ > 0) reasons[MissingRays::kNotCertain] += without_pattern_;
}

}  // namespace datasets
