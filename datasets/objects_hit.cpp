#include "datasets/objects_hit.h"

#include <algorithm>

namespace datasets {
namespace {

constexpr double kIntoObject = 1e-4;  // [m]: hits are floats on the surface

bool contains(const ObjectState& object, const Eigen::Vector3d& p) {
  const Eigen::Vector3d beyond = (p - object.position).cwiseAbs() - object.size / 2;
  if ((beyond.array() > kIntoObject).any()) return false;
  return std::any_of(object.solids.begin(), object.solids.end(),
                     [&](const Solid& solid) { return solid.contains(p); });
}

}  // namespace

std::vector<std::int32_t> objects_hit(const Truth& truth, const Eigen::Vector3d& sensor) {
  std::vector<std::int32_t> owners;
  owners.reserve(truth.noise_free_hits.size());
  for (const ldm::Point& hit : truth.noise_free_hits) {
    const Eigen::Vector3d p = hit.cast<double>();
    const Eigen::Vector3d inside = p + kIntoObject * (p - sensor).normalized();
    const auto found = std::find_if(truth.objects.begin(), truth.objects.end(),
                                    [&](const auto& object) { return contains(object, inside); });
    owners.push_back(found == truth.objects.end()
                         ? -1
                         : static_cast<std::int32_t>(found - truth.objects.begin()));
  }
  return owners;
}

}  // namespace datasets
