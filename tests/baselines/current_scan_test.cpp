#include "baselines/current_scan.h"

#include <gtest/gtest.h>

#include "tests/reference/scan_of_boxes.h"

namespace baselines {
namespace {

TEST(CurrentScan, RemembersNothing) {
  CurrentScan mapper{ldm::Parameters()};
  ldm::Scan scan = reference::scan_at(0, {0.075, 0.075, 0.075});
  ldm::LocalMap map;
  for (int k = 0; k < 5; ++k) {
    scan.points = {{0.6F, 0, 0}};
    mapper.update(scan);
    mapper.read(map);
    EXPECT_FLOAT_EQ(map.occupancy[map.window.index({4, 0, 0})], 0.7F);
    EXPECT_FLOAT_EQ(map.occupancy[map.window.index({2, 0, 0})], 0.4F);
  }
  scan.points.clear();
  mapper.update(scan);
  mapper.read(map);
  EXPECT_EQ(map.occupancy, std::vector<float>(map.window.count(), 0.5F));
}

}  // namespace
}  // namespace baselines
