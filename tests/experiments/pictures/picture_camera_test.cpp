#include "experiments/pictures/picture_camera.h"

#include <gtest/gtest.h>

#include <numbers>

namespace experiments {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr PixelBox kWithin{.left = 0, .right = 200, .top = 0, .bottom = 100};
const Eigen::AlignedBox3d kBox(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));

TEST(PictureCamera, SeesTheBoxFromAsNearAsItFits) {
  // The near face fills the height: half an edge of 1 m at 50 / 100 of its distance, hence 2 m
  // away.
  const PictureCamera camera(kBox, kWithin, 0, 0, 100);
  EXPECT_DOUBLE_EQ(camera.depth(), 3);
  EXPECT_TRUE(camera.T_world_camera().translation.isApprox(Vector3d(3, 0, 0)));
  EXPECT_TRUE(camera.pixel({1, 1, 1}).isApprox(Vector2d(150, 0)));
  EXPECT_TRUE(camera.pixel({0, -1.5, -0.75}).isApprox(Vector2d(50, 75)));
}

TEST(PictureCamera, FromAboveItsOwnSideIsDown) {
  const PictureCamera camera(kBox, kWithin, 0, std::numbers::pi / 2, 100);
  EXPECT_TRUE(camera.pixel({0.5, 0, 1}).isApprox(Vector2d(100, 75)));
  EXPECT_TRUE(camera.pixel({0, 0.5, 1}).isApprox(Vector2d(125, 50)));
}

TEST(PictureCamera, WorldIsTheInverseOfPixel) {
  const PictureCamera camera(kBox, kWithin, -1, 0.5, 100);
  const Vector2d pixel(31, 77);
  const Vector3d p = camera.world(pixel, 2.5);
  EXPECT_TRUE(camera.pixel(p).isApprox(pixel));
  const ldm::Pose& T = camera.T_world_camera();
  EXPECT_NEAR((p - T.translation).dot(T.rotation.col(2)), 2.5, 1e-12);
}

TEST(PictureCamera, KeepsEveryCornerWithin) {
  const PixelBox within{.left = 40, .right = 140, .top = 5, .bottom = 95};
  const Eigen::AlignedBox3d flat(Vector3d(-20, 3, -2), Vector3d(18, 41, 7));
  const PictureCamera camera(flat, within, 2, 0.4, 300);
  double nearest = 1e9;  // [pixel] to an edge of the part
  for (int i = 0; i < 8; ++i) {
    const Vector2d p = camera.pixel(flat.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
    nearest = std::min({nearest, p.x() - within.left, within.right - p.x(), p.y() - within.top,
                        within.bottom - p.y()});
  }
  EXPECT_NEAR(nearest, 0, 1e-9);
}

}  // namespace
}  // namespace experiments
