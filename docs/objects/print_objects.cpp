/// Example of docs/objects.md: scans in, objects out.
#include <ldm/objects/object_tracker.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace {

/// What a LiDAR at 0, 0, 1 sees of a round post: its front half, 16 rings one above the other [m].
std::vector<Eigen::Vector3d> post(double x, double y) {
  std::vector<Eigen::Vector3d> points;
  const double facing = std::atan2(-y, -x);
  for (int ring = 0; ring < 16; ++ring) {
    for (double angle = facing - 1.5; angle <= facing + 1.5; angle += 0.1) {
      points.emplace_back(x + 0.2 * std::cos(angle), y + 0.2 * std::sin(angle), 0.4 + 0.08 * ring);
    }
  }
  return points;
}

}  // namespace

int main() {
  ldm::ObjectTracker tracker(0.15);
  for (int frame = 0; frame < 20; ++frame) {
    const double time = 0.1 * frame;
    std::vector<Eigen::Vector3d> points = post(3, 1);                    // one stands,
    for (const auto& p : post(2, -1 + 1.2 * time)) points.push_back(p);  // one goes at 1.2 m/s
    tracker.update(time, {0, 0, 1}, points);
  }
  for (const ldm::TrackedObject& object : tracker.objects()) {
    const Eigen::Matrix2d covariance = object.velocity_covariance();
    std::printf("object %d: at (%.2f, %.2f) m, velocity (%.2f, %.2f) m/s, sigma (%.3f, %.3f), %s\n",
                static_cast<int>(object.id()), object.position().x(), object.position().y(),
                object.velocity().x(), object.velocity().y(), std::sqrt(covariance(0, 0)),
                std::sqrt(covariance(1, 1)), object.dynamic() ? "moves" : "stands");
  }
}
