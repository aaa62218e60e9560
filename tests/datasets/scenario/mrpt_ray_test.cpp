/// Our closed forms against MRPT's traceRay, for the shapes that it gets right.
#include <gtest/gtest.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CPolyhedron.h>
#include <mrpt/opengl/CSphere.h>

#include "datasets/scenario/ray_entry.h"
#include "tests/datasets/scenario/random_solids.h"

namespace datasets {
namespace {

constexpr double kTolerance = 1e-5;  ///< [m] MRPT keeps sizes in single precision

/// A ray of MRPT: it looks along the x axis of its pose.
mrpt::poses::CPose3D ray_pose(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) {
  const double yaw = std::atan2(direction.y(), direction.x());
  const double pitch = -std::asin(direction.z());
  return {origin.x(), origin.y(), origin.z(), yaw, pitch, 0};
}

/// Rays from outside around the origin; `trace` is MRPT's answer, `entry` is ours. How many hit.
template <class Entry>
int compare(const mrpt::opengl::CRenderizable& shape, const Solid& solid, Entry entry,
            Random& random) {
  int hits = 0;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d origin = 4 * random_vector(1, random).normalized();
    const Eigen::Vector3d direction = (random_vector(1, random) - origin).normalized();
    double range = 0;
    const bool hit = shape.traceRay(ray_pose(origin, direction), range);
    const double ours = entry(solid.size / 2, origin, direction);
    EXPECT_EQ(hit, ours != kNever) << "ray " << i;
    if (hit && ours != kNever) {
      EXPECT_NEAR(range, ours, kTolerance);
    }
    hits += hit;
  }
  return hits;
}

class MrptRayTest : public testing::Test {
 protected:
  /// Sizes that single precision holds exactly, so that no ray falls between two surfaces.
  Solid solid(Solid::Shape shape) {
    Solid s = random_solid(shape, 0, random_);
    s.size = s.size.cast<float>().cast<double>();
    return s;
  }

  Random random_{17};
  int hits_ = 0;
};

TEST_F(MrptRayTest, Spheres) {
  for (int i = 0; i < 20; ++i) {
    const Solid s = solid(Solid::Shape::kSphere);
    const mrpt::opengl::CSphere sphere(static_cast<float>(s.size.x() / 2));
    hits_ += compare(sphere, s, sphere_entry, random_);
  }
  EXPECT_GT(hits_, 300);
}

TEST_F(MrptRayTest, CylindersWithBases) {
  for (int i = 0; i < 20; ++i) {
    const Solid s = solid(Solid::Shape::kCylinder);
    const auto radius = static_cast<float>(s.size.x() / 2);
    mrpt::opengl::CCylinder cylinder(radius, radius, static_cast<float>(s.size.z()));
    cylinder.setHasBases(true, true);
    cylinder.setPose(mrpt::poses::CPose3D(0, 0, -s.size.z() / 2, 0, 0, 0));
    hits_ += compare(cylinder, s, cylinder_entry, random_);
  }
  EXPECT_GT(hits_, 300);
}

TEST_F(MrptRayTest, Prisms) {
  for (int i = 0; i < 20; ++i) {
    const Solid s = solid(Solid::Shape::kBox);
    const Eigen::Vector3d h = s.size / 2;
    const auto prism =
        mrpt::opengl::CPolyhedron::CreateCubicPrism(-h.x(), h.x(), -h.y(), h.y(), -h.z(), h.z());
    hits_ += compare(*prism, s, box_entry, random_);
  }
  EXPECT_GT(hits_, 300);
}

}  // namespace
}  // namespace datasets
