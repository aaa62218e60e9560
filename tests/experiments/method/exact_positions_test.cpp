#include "experiments/method/exact_positions.h"

#include <gtest/gtest.h>

#include "tests/experiments/metrics/tiny_world.h"
#include "tests/temporary_folder.h"

namespace experiments {
namespace {

/// A box of 0.5 m whose front moves to the left, 2 m before the sensor, at 1 m/s; its return is
/// noisy by 5 cm.
datasets::Frame frame(int k) {
  datasets::Frame frame;
  frame.index = k;
  frame.scan.time = 0.1 * k;
  datasets::ObjectState object;
  object.id = 4;
  object.position = {2.25, 0.1 * k, 0};
  object.velocity = {0, 1, 0};
  object.size = {0.5, 0.5, 0.5};
  datasets::Solid solid;
  solid.T_world_solid.translation = object.position;
  solid.size = object.size;
  object.solids = {solid};
  const ldm::Point hit(2, 0.1F * static_cast<float>(k), 0);
  frame.scan.points = {hit + ldm::Point(0.05F, 0, 0)};
  frame.truth = datasets::Truth{{object}, {hit}};
  return frame;
}

TEST(ExactPositions, FollowTheTrueCentreOfWhatIsSeen) {
  ExactPositions mapper{ldm::Parameters()};
  ldm::LocalMap map;
  for (int k = 0; k < 15; ++k) update(mapper, frame(k));
  mapper.read(map);
  ASSERT_EQ(map.clusters.size(), 1u);
  EXPECT_EQ(map.clusters[0].id, 5);
  EXPECT_EQ(map.clusters[0].voxels, 1);
  EXPECT_NEAR(map.clusters[0].age, 1.4, 1e-9);
  EXPECT_NEAR(map.clusters[0].velocity.y(), 1, 0.01);
  EXPECT_TRUE(map.clusters[0].dynamic);
}

/// What no ray meets is not known: the oracle knows places, not what is hidden.
TEST(ExactPositions, HiddenObjectsHaveNoCluster) {
  ExactPositions mapper{ldm::Parameters()};
  ldm::LocalMap map;
  for (int k = 0; k < 15; ++k) update(mapper, frame(k));
  datasets::Frame hidden = frame(15);
  hidden.scan.points.clear();
  hidden.truth->noise_free_hits.clear();
  update(mapper, hidden);
  mapper.read(map);
  EXPECT_TRUE(map.clusters.empty());
  update(mapper, frame(16));
  mapper.read(map);
  ASSERT_EQ(map.clusters.size(), 1u);
  EXPECT_NEAR(map.clusters[0].velocity.y(), 1, 0.1) << "it was predicted";
  datasets::Frame late = frame(10);
  late.scan.time = 6;
  update(mapper, late);
  mapper.read(map);
  EXPECT_EQ(map.clusters.at(0).age, 0) << "unseen for more than 4 s";
}

TEST(ExactPositions, OneLineRefusesFramesWithoutATruth) {
  ExactPositions mapper{ldm::Parameters()};
  datasets::Frame recorded = frame(3);
  recorded.truth.reset();
  EXPECT_EQ(tests::message_of([&] { update(mapper, recorded); }),
            "frame 3: has no truth: allowed for an oracle: scenarios, and logs of `ldm simulate` "
            "with their truth");
}

}  // namespace
}  // namespace experiments
