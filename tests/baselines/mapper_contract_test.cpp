// What ldm/mapper.h promises of every mapper, held against each baseline and the plain map.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "baselines/centroid_kalman.h"
#include "baselines/circular_buffer.h"
#include "baselines/circular_buffer_pf.h"
#include "baselines/current_scan.h"
#include "baselines/octomap.h"
#include "ldm/plain/local_dynamic_map.h"
#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
const Eigen::Vector3d kHome(0.075, 0.075, 0.075);  // centre of voxel 0

ldm::Parameters small_parameters() {
  ldm::Parameters parameters;
  parameters.map.voxels = {16, 17, 9};
  parameters.particles.count = 1000;
  return parameters;
}

template <class Mapper>
class MapperContract : public testing::Test {
 protected:
  const ldm::LocalMap& map() {
    mapper_.read(map_);
    return map_;
  }
  float at(const ldm::VoxelIndex& v) { return map().occupancy[map_.window.index(v)]; }

  Mapper mapper_{small_parameters()};
  ldm::LocalMap map_;
};
using Mappers = testing::Types<Octomap, CircularBuffer, CircularBufferPf, CurrentScan,
                               CentroidKalman, ldm::plain::LocalDynamicMap>;
TYPED_TEST_SUITE(MapperContract, Mappers);

/// One return `x`, `y`, `z` [m] from the sensor.
ldm::Scan one_return(double time, float x, float y, float z) {
  ldm::Scan scan = reference::scan_at(time, kHome);
  scan.points = {{x, y, z}};
  return scan;
}

TYPED_TEST(MapperContract, IsUnknownBeforeTheFirstScan) {
  const ldm::LocalMap& map = this->map();
  EXPECT_EQ(map.window.size, ldm::VoxelIndex(16, 17, 9));
  EXPECT_EQ(map.resolution, 0.15);
  EXPECT_EQ(map.occupancy, std::vector<float>(map.window.count(), 0.5F));
  EXPECT_EQ(map.labels, std::vector<std::int32_t>(map.window.count(), -1));
  EXPECT_TRUE(map.clusters.empty());
}

TYPED_TEST(MapperContract, HitsAreOccupiedAndTheWayThereIsFree) {
  this->mapper_.update(one_return(0, 0.6F, 0, 0));
  EXPECT_FLOAT_EQ(this->at({4, 0, 0}), 0.7F);
  for (int x = 0; x < 4; ++x) EXPECT_FLOAT_EQ(this->at({x, 0, 0}), 0.4F);
  EXPECT_EQ(this->at({5, 0, 0}), 0.5F);
  EXPECT_EQ(this->at({-1, 0, 0}), 0.5F);
  EXPECT_EQ(this->at({4, 1, 0}), 0.5F);
}

TYPED_TEST(MapperContract, ReadsRowByRowWithXFastest) {
  this->mapper_.update(one_return(0, 0.15F, 0.3F, -0.45F));
  const ldm::LocalMap& map = this->map();
  EXPECT_EQ(map.window.origin, ldm::VoxelIndex(-8, -8, -4));
  const std::size_t expected = (8 + 1) + 16 * ((8 + 2) + 17 * (4 - 3));
  for (std::size_t i = 0; i < map.occupancy.size(); ++i) {
    EXPECT_EQ(map.occupancy[i] > 0.5F, i == expected) << i;
  }
}

TYPED_TEST(MapperContract, PointsAreInTheSensorsFrame) {
  ldm::Scan scan = one_return(0, 0.6F, 0, 0);
  scan.T_world_sensor.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;  // x forward becomes y
  scan.T_world_sensor.translation.z() += 0.15;
  this->mapper_.update(scan);
  EXPECT_FLOAT_EQ(this->at({0, 4, 1}), 0.7F);
  EXPECT_FLOAT_EQ(this->at({0, 3, 1}), 0.4F);
}

TYPED_TEST(MapperContract, RaysWithoutAReturnAreFreeUpToTheBorder) {
  ldm::Scan scan = reference::scan_at(0, kHome);
  scan.no_returns = {{1, 0, 0}};
  this->mapper_.update(scan);
  for (int x = 0; x <= 7; ++x) EXPECT_FLOAT_EQ(this->at({x, 0, 0}), 0.4F);
}

TYPED_TEST(MapperContract, RaysWithoutAReturnMayBeDropped) {
  ldm::Parameters parameters = small_parameters();
  parameters.sensor_model.no_returns = ldm::NoReturnRays::kDrop;
  TypeParam mapper(parameters);
  ldm::Scan scan = reference::scan_at(0, kHome);
  scan.no_returns = {{1, 0, 0}};
  mapper.update(scan);
  mapper.read(this->map_);
  EXPECT_EQ(this->map_.occupancy, std::vector<float>(this->map_.window.count(), 0.5F));
}

TYPED_TEST(MapperContract, ReturnsBeyondTheMapClearTheWay) {
  this->mapper_.update(one_return(0, 50, 0, 0));
  for (int x = 0; x <= 7; ++x) EXPECT_FLOAT_EQ(this->at({x, 0, 0}), 0.4F);
}

TYPED_TEST(MapperContract, AVoxelHitAndCrossedInOneScanIsOccupied) {
  ldm::Scan scan = one_return(0, 0.3F, 0, 0);
  scan.points.emplace_back(0.9F, 0.0F, 0.0F);
  this->mapper_.update(scan);
  EXPECT_FLOAT_EQ(this->at({2, 0, 0}), 0.7F);
  EXPECT_FLOAT_EQ(this->at({6, 0, 0}), 0.7F);
  EXPECT_FLOAT_EQ(this->at({4, 0, 0}), 0.4F);
}

TYPED_TEST(MapperContract, TheWindowFollowsTheUavsVoxel) {
  ldm::Scan scan = reference::scan_at(0, {0.149, -0.001, 3.01});
  this->mapper_.update(scan);
  EXPECT_EQ(this->map().window.origin, ldm::VoxelIndex(0 - 8, -1 - 8, 20 - 4));
  scan.T_world_uav.translation = {-0.15, 0.15, 0.15};
  this->mapper_.update(scan);
  EXPECT_EQ(this->map().window.origin, ldm::VoxelIndex(-1 - 8, 1 - 8, 1 - 4));
}

TYPED_TEST(MapperContract, AJumpBeyondTheMapFindsAFreshMap) {
  this->mapper_.update(one_return(0, 0.6F, 0, 0));
  this->mapper_.update(reference::scan_at(0.1, {100, -200, 50}));
  const ldm::LocalMap& map = this->map();
  EXPECT_TRUE(map.window.contains(ldm::voxel_at({100, -200, 50}, 0.15)));
  EXPECT_EQ(map.occupancy, std::vector<float>(map.window.count(), 0.5F));
  EXPECT_TRUE(map.clusters.empty());
}

TYPED_TEST(MapperContract, RefusesBadScansAndKeepsItsMap) {
  this->mapper_.update(one_return(1, 0.6F, 0, 0));
  const std::vector<float> before = this->map().occupancy;
  std::vector<ldm::Scan> bad(6, one_return(2, 0.3F, 0, 0));
  bad[0].points[0].y() = kNan;
  bad[1].no_returns = {{std::numeric_limits<float>::infinity(), 0, 0}};
  bad[2].T_world_uav.translation.x() = kNan;
  bad[3].T_world_sensor.rotation(1, 1) = kNan;
  bad[4].time = kNan;
  bad[5].time = 0.5;  // backwards
  for (const ldm::Scan& scan : bad) {
    EXPECT_THROW(this->mapper_.update(scan), ldm::InvalidInput);
    EXPECT_EQ(this->map().occupancy, before);
  }
  this->mapper_.update(one_return(1, 0.6F, 0, 0));  // the same time again is no step back
}

TYPED_TEST(MapperContract, RefusesBadParameters) {
  ldm::Parameters parameters = small_parameters();
  parameters.map.voxels.y() = -1;
  EXPECT_THROW(TypeParam{parameters}, ldm::InvalidInput);
  parameters = small_parameters();
  parameters.sensor_model.p_occ = 0.5;
  EXPECT_THROW(TypeParam{parameters}, ldm::InvalidInput);
}

/// Collects the names of the stages it is told of.
struct Stages : ldm::StageListener {
  void begin(std::string_view stage) override { names.emplace_back(stage); }
  std::vector<std::string> names;
};

TYPED_TEST(MapperContract, TellsItsStages) {
  Stages stages;
  this->mapper_.update(reference::scan_at(0, kHome), &stages);
  EXPECT_FALSE(stages.names.empty());
}

}  // namespace
}  // namespace baselines
