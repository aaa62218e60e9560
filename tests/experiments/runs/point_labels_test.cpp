#include "experiments/runs/point_labels.h"

#include <gtest/gtest.h>

#include "experiments/runs/label_score.h"
#include "tests/experiments/metrics/tiny_world.h"
#include "tests/temporary_folder.h"

namespace experiments {
namespace {

using Labels = std::vector<PointLabel>;

constexpr PointLabel kMovingSeven = 7 << 16 | kMovingPoint;

/// Voxels of 1 m: object 7 moves in the one at the origin, object 8 stands two beside it.
ldm::LocalMap map() {
  ldm::LocalMap map = unknown_map(3);
  add_cluster(map, {{0, 0, 0}});
  add_cluster(map, {{2, 0, 0}});
  map.clusters[0].id = 7;
  map.clusters[0].dynamic = true;
  map.clusters[1].id = 8;
  return map;
}

/// On the first, on the second, on neither, and out of the map.
datasets::Frame frame() {
  datasets::Frame frame;
  frame.scan.points = {{0.5F, 0.5F, 0.5F}, {2.5F, 0.5F, 0.5F}, {0.5F, 2.5F, 0.5F}, {9, 0, 0}};
  return frame;
}

TEST(PointLabels, SayWhatTheMapKnowsOfEachPoint) {
  EXPECT_EQ(labels_of(frame(), map()),
            (Labels{kMovingSeven, kStaticPoint, kStaticPoint, kUnlabelled}));
}

TEST(PointLabels, AreInTheSensorsFrame) {
  datasets::Frame moved = frame();
  moved.scan.T_world_sensor.translation << -2, 0, 0;
  EXPECT_EQ(labels_of(moved, map()), (Labels{kUnlabelled, kMovingSeven, kUnlabelled, kUnlabelled}));
}

TEST(PointLabels, CountThePointsThatWereLeftOut) {
  datasets::Frame filtered = frame();
  filtered.kept = {6, {0, 1, 3, 5}};
  EXPECT_EQ(labels_of(filtered, map()), (Labels{kMovingSeven, kStaticPoint, kStaticPoint,
                                                kStaticPoint, kStaticPoint, kUnlabelled}));
}

TEST(PointLabels, OfANumberBeyond65535ItsLowBitsAreLeft) {
  ldm::LocalMap large = map();
  large.clusters[0].id = 3 * 65536 + 7;
  EXPECT_EQ(labels_of(frame(), large)[0], kMovingSeven);
}

TEST(PointLabels, AreTrueOfAnObjectThatMovesAtThisTime) {
  datasets::Frame frame;
  frame.scan.T_world_sensor.translation << -10, 1, 1;
  frame.truth.emplace();
  frame.truth->objects = {box_object(7, {0, 0, 0}, {1, 1, 1}), box_object(8, {5, 0, 0}, {6, 1, 1})};
  frame.truth->objects[0].velocity.x() = 1;
  const auto side = [&](std::size_t i) {
    const datasets::ObjectState& object = frame.truth->objects[i];
    return ldm::Point(static_cast<float>(object.position.x() - object.size.x() / 2), 1, 1);
  };
  frame.truth->noise_free_hits = {side(0), side(1), {3, 1, 1}};
  EXPECT_EQ(true_labels(frame), (Labels{kMovingSeven, kStaticPoint, kStaticPoint}));
  frame.truth->objects[0].velocity.x() = 0.05;  // no faster than what stands
  EXPECT_EQ(true_labels(frame)[0], kStaticPoint);
}

TEST(PointLabels, TheClassesOfTheBenchmarkThatMove) {
  for (const PointLabel label : {0U, 1U, 9U, 10U, 250U, 260U}) EXPECT_FALSE(is_moving(label));
  for (const PointLabel label : {251U, 252U, 259U, kMovingSeven}) EXPECT_TRUE(is_moving(label));
}

class LabelFiles : public testing::Test {
 protected:
  void write(const std::string& folder, std::int64_t frame, const Labels& labels) {
    std::filesystem::create_directories(folder_.path() / folder);
    write_labels(labels, label_file(folder_.path() / folder, frame));
  }
  LabelScore score() { return score_labels(folder_.path() / "run", folder_.path() / "true"); }
  std::string refusal() {
    return tests::message_of([this] { score(); });
  }

  tests::TemporaryFolder folder_;
};

TEST_F(LabelFiles, ReadBack) {
  write(".", 12, {kMovingSeven, kStaticPoint});
  EXPECT_EQ(read_labels(folder_.path() / "000012.label"), (Labels{kMovingSeven, kStaticPoint}));
  EXPECT_EQ(folder_.read("000012.label"), std::string("\xfb\0\x07\0\x09\0\0\0", 8));
}

TEST_F(LabelFiles, AreRefusedIfTheyHoldAPartOfALabel) {
  folder_.write("000000.label", "seven b");
  EXPECT_NE(tests::message_of([this] {
              read_labels(folder_.path() / "000000.label");
            }).find("7 bytes: allowed: four for each point"),
            std::string::npos);
  EXPECT_NE(tests::message_of([this] {
              read_labels(folder_.path() / "000001.label");
            }).find("000001.label: cannot be read"),
            std::string::npos);
}

TEST_F(LabelFiles, AreCountedPointByPoint) {
  const PointLabel moving_car = 252, outlier = 1, car = 10;
  write("run/labels", 0, {kMovingSeven, kMovingSeven, kStaticPoint, kUnlabelled, kMovingSeven});
  write("true", 0, {moving_car, car, moving_car, moving_car, outlier});
  write("run/labels", 1, {kMovingSeven, kStaticPoint});
  write("true", 1, {moving_car, car});
  write("run/labels", 2, {kMovingSeven});  // of no reference
  const LabelScore found = score();
  EXPECT_EQ(found.frames, 2);
  EXPECT_EQ(found.all.both_moving, 2);
  EXPECT_EQ(found.all.run_only, 1);
  EXPECT_EQ(found.all.reference_only, 2);
  EXPECT_EQ(found.all.both_static, 1);
  EXPECT_EQ(found.all.points(), 6);
  EXPECT_DOUBLE_EQ(*found.all.moving_iou(), 0.4);
  EXPECT_DOUBLE_EQ(*found.in_map.moving_iou(), 0.5);
}

TEST_F(LabelFiles, OfNothingThatMovesThereIsNoIntersectionOverUnion) {
  write("run/labels", 0, {kStaticPoint});
  write("true", 0, {kStaticPoint});
  EXPECT_EQ(score().all.moving_iou(), std::nullopt);
}

TEST_F(LabelFiles, AreRefusedIfTheyDoNotFit) {
  EXPECT_NE(refusal().find("run/labels: no labels: allowed: a folder of *.label files"),
            std::string::npos);
  write("run/labels", 0, {kStaticPoint});
  EXPECT_NE(refusal().find("true: no frame of the run: allowed: files named as in "),
            std::string::npos);
  write("true", 0, {kStaticPoint, kStaticPoint});
  EXPECT_NE(refusal().find("000000.label: 2 points: allowed: 1, as in "), std::string::npos);
}

}  // namespace
}  // namespace experiments
