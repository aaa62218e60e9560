/// What is drawn where. One renderer serves a whole process: the tests may run together or apart.
#include "experiments/pictures/picture.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

#include <functional>

#include "tests/full_disk.h"
#include "tests/temporary_folder.h"
#include "tests/text_file.h"

namespace experiments {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

class PictureFile {
 public:
  explicit PictureFile(const Picture& picture) : file_("picture.png", "") {
    datasets::PartialFile file(file_.path());
    write_png(picture, file);
    file.commit();
    EXPECT_TRUE(image_.loadFromFile(file_.name()));
  }

  int width() const { return static_cast<int>(image_.getWidth()); }
  int height() const { return static_cast<int>(image_.getHeight()); }
  Colour at(int column, int row) const {
    const std::uint8_t* bgr = image_.ptrLine<std::uint8_t>(static_cast<unsigned>(row)) + 3 * column;
    return {bgr[2], bgr[1], bgr[0]};
  }

  /// Number and mean place of the pixels of a kind.
  struct Patch {
    int pixels = 0;
    Vector2d centre = Vector2d::Zero();
  };
  Patch patch(const std::function<bool(Colour)>& is_one) const {
    Patch patch;
    for (int row = 0; row < height(); ++row) {
      for (int column = 0; column < width(); ++column) {
        if (!is_one(at(column, row))) continue;
        ++patch.pixels;
        patch.centre += Vector2d(column + 0.5, row + 0.5);
      }
    }
    patch.centre /= patch.pixels;
    return patch;
  }

 private:
  tests::TextFile file_;
  mrpt::img::CImage image_;
};

bool reddish(Colour c) {
  return c.red > 100 && c.red > c.green + 60 && c.red > c.blue + 60;
}
bool greenish(Colour c) {
  return c.green > c.red + 60 && c.green > c.blue + 60;
}
bool dark(Colour c) {
  return c.red < 90 && c.green < 90 && c.blue < 90;
}

/// An empty map of 4.8 m around the UAV, which stands in its upper back corner.
Picture empty_map() {
  Picture picture;
  picture.border = {Vector3d::Constant(-2.4), Vector3d::Constant(2.4)};
  picture.T_world_uav.translation = {-2, 2, 2};
  return picture;
}

TEST(Picture, IsLightAndHasTheSizeThatWasPromised) {
  const PictureFile file(empty_map());
  EXPECT_EQ(file.width(), 1280);
  EXPECT_EQ(file.height(), 720);
  EXPECT_EQ(file.at(3, 3), (Colour{255, 255, 255}));
  const auto white = file.patch([](Colour c) { return c == Colour{255, 255, 255}; });
  EXPECT_GT(white.pixels, 0.9 * 1280 * 720);
  EXPECT_EQ(file.patch(reddish).pixels, 0);
}

TEST(Picture, CubesStandWhereTheCameraSeesThem) {
  Picture picture = empty_map();
  picture.cube_edge = 0.3;
  picture.cubes = {{{0.9F, -1.2F, 0.6F}, {220, 0, 0}}, {{-1.2F, 0.6F, -1.5F}, {0, 200, 0}}};
  const PictureCamera camera = camera_of(picture);
  const PictureFile file(picture);

  const auto red = file.patch(reddish), green = file.patch(greenish);
  EXPECT_LT((red.centre - camera.pixel({0.9, -1.2, 0.6})).norm(), 2);
  EXPECT_LT((green.centre - camera.pixel({-1.2, 0.6, -1.5})).norm(), 2);
  // The silhouette of a cube covers 1 to sqrt(3) of a face, here near the upper bound.
  const double edge = 0.3 * camera.focal_length() / camera.depth();
  EXPECT_GT(red.pixels, 1.2 * edge * edge);
  EXPECT_LT(red.pixels, 1.9 * edge * edge);
}

TEST(Picture, PathsAreBallsWhereTheCameraSeesThem) {
  Picture picture = empty_map();
  picture.paths = {{{{0.9F, -1.2F, 0.6F}}, {220, 0, 0}, ""}, {{}, {0, 200, 0}, ""}};
  const PictureCamera camera = camera_of(picture);
  const PictureFile file(picture);
  const Vector2d place = camera.pixel({0.9, -1.2, 0.6});
  const auto pixel = [](double along) { return static_cast<int>(std::lround(along)); };
  EXPECT_TRUE(reddish(file.at(pixel(place.x()), pixel(place.y()))));
  EXPECT_GT(file.patch(greenish).pixels, 20) << "an empty path is in the legend, too";
}

TEST(Picture, ANearCubeHidesMostOfAFarOne) {
  Picture picture = empty_map();
  picture.cube_edge = 0.3;
  const PictureCamera camera = camera_of(picture);
  const Vector2d pixel(800, 330);
  const Vector3d near = camera.world(pixel, camera.depth() - 1);
  const Vector3d far = camera.world(pixel, camera.depth() + 1);
  for (const bool near_first : {true, false}) {
    picture.cubes = {{near.cast<float>(), {220, 0, 0}}, {far.cast<float>(), {0, 200, 0}}};
    if (!near_first) std::swap(picture.cubes[0], picture.cubes[1]);
    const PictureFile file(picture);
    EXPECT_TRUE(reddish(file.at(803, 335))) << near_first;
  }
}

TEST(Picture, PointsShowThroughTheirCube) {
  Picture picture = empty_map();
  picture.cube_edge = 0.6;
  picture.cubes = {{{0, 0, 0}, {240, 228, 66}}};
  const auto brightness = [&](const PictureFile& file) {
    const Vector2d p = camera_of(picture).pixel({0, 0, 0});
    const Colour c = file.at(static_cast<int>(p.x()), static_cast<int>(p.y()));
    return c.red + c.green + c.blue;
  };
  const int without = brightness(PictureFile(picture));
  picture.points.assign(1, {0, 0, 0});
  EXPECT_LT(brightness(PictureFile(picture)), without - 60);
}

TEST(Picture, AnArrowReachesFromEndToEnd) {
  Picture picture = empty_map();
  picture.arrows = {{{-1, -1, 0}, {1, -1, 0}, ""}};
  const PictureCamera camera = camera_of(picture);
  const auto arrow = PictureFile(picture).patch(reddish);
  const Vector2d from = camera.pixel({-1, -1, 0}), to = camera.pixel({1, -1, 0});
  EXPECT_GT(arrow.pixels, (to - from).norm());
  // On the line, and nearer to the head.
  const double along = (arrow.centre - from).dot(to - from) / (to - from).squaredNorm();
  EXPECT_GT(along, 0.5);
  EXPECT_LT(along, 0.9);
  EXPECT_LT((arrow.centre - from - along * (to - from)).norm(), 2);
}

TEST(Picture, TheUavIsDarkAndInItsPlace) {
  Picture picture = empty_map();
  picture.T_world_uav.translation = {0.5, -0.5, 1};
  const PictureFile file(picture);
  const Vector2d p = camera_of(picture).pixel(picture.T_world_uav.translation);
  EXPECT_TRUE(dark(file.at(static_cast<int>(p.x()), static_cast<int>(p.y()))));
}

TEST(Picture, TheSamePictureIsTheSameFile) {
  Picture picture = empty_map();
  picture.heading = {"twice"};
  const PictureFile first(picture), second(picture);
  bool same = true;
  for (int row = 0; row < first.height(); ++row) {
    for (int column = 0; column < first.width(); ++column) {
      same = same && first.at(column, row) == second.at(column, row);
    }
  }
  EXPECT_TRUE(same);
}

TEST(Picture, CutShortIsNoFile) {
  const tests::FullDisk disk(3000);
  const tests::TemporaryFolder folder;
  const std::string name = (folder.path() / "picture.png").string();
  EXPECT_EQ(tests::message_of<std::runtime_error>([&] {
              datasets::PartialFile file(name);
              write_png(empty_map(), file);
              file.commit();
            }),
            name + ": cannot be written: disk full?");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace experiments
