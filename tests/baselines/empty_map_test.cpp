#include "baselines/empty_map.h"

#include <gtest/gtest.h>

#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

TEST(EmptyMap, KnowsNothingOfWhatIsScanned) {
  ldm::Parameters parameters;
  parameters.map.voxels = {6, 7, 8};
  EmptyMap mapper(parameters);
  ldm::Scan scan = reference::scan_at(0, {1.5, 0.075, -0.075});
  scan.points = {{0.3F, 0, 0}};
  mapper.update(scan);
  ldm::LocalMap map;
  mapper.read(map);
  EXPECT_EQ(map.window.origin, ldm::VoxelIndex(10 - 3, 0 - 3, -1 - 4));
  EXPECT_EQ(map.occupancy, std::vector<float>(6 * 7 * 8, 0.5F));
  EXPECT_EQ(map.labels, std::vector<std::int32_t>(6 * 7 * 8, -1));
  EXPECT_TRUE(map.clusters.empty());
}

TEST(EmptyMap, RefusesBadScansAsEveryMapperDoes) {
  EmptyMap mapper{ldm::Parameters()};
  mapper.update(reference::scan_at(1, {0, 0, 0}));
  EXPECT_THROW(mapper.update(reference::scan_at(0.5, {0, 0, 0})), ldm::InvalidInput);
}

}  // namespace
}  // namespace baselines
