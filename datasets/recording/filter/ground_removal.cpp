#include "datasets/recording/filter/ground_removal.h"

namespace datasets {

GroundFinder::GroundFinder(const GroundParameters& parameters)
    : parameters_(parameters), plane_fit_(parameters) {
  if (parameters.removal == GroundRemoval::kGrid) grid_.emplace(parameters);
}

bool GroundFinder::mark(const ldm::Scan& scan, std::vector<std::uint8_t>& is_ground) {
  is_ground.assign(scan.points.size(), 0);
  const Eigen::Matrix3f turn = scan.T_world_sensor.rotation.cast<float>();
  levelled_.resize(scan.points.size());
  for (std::size_t i = 0; i < levelled_.size(); ++i) levelled_[i] = turn * scan.points[i];
  const std::optional<GroundPlane> plane = plane_fit_.fit(levelled_);
  if (!plane) return false;
  if (grid_) grid_->fit(*plane, levelled_);
  const auto margin = static_cast<float>(parameters_.margin);
  for (std::size_t i = 0; i < levelled_.size(); ++i) {
    const float above = grid_ ? grid_->above(levelled_[i]) : plane->above(levelled_[i]);
    is_ground[i] = above < margin ? 1 : 0;
  }
  return true;
}

}  // namespace datasets
