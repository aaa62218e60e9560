#include "ldm/plugin.h"

#include <gtest/gtest.h>

#include <sstream>

namespace ldm {
namespace {

/// What a plugin compiled earlier relies on: where each parameter lies, and sizes.
std::string layout() {
  Parameters p;
  std::ostringstream text;
  const auto* const begin = reinterpret_cast<const char*>(&p);
  visit_parameters(p, [&](const ParameterInfo& info, auto& value, auto&...) {
    text << reinterpret_cast<const char*>(&value) - begin << ' ' << info.name << '\n';
  });
  text << sizeof(Parameters) << " Parameters, " << sizeof(Scan) << " Scan, " << sizeof(LocalMap)
       << " LocalMap, " << sizeof(Cluster) << " Cluster, " << sizeof(Method) << " Method";
  return text.str();
}

/// If this fails, raise kPluginInterface, and only then write the new layout here.
TEST(Plugin, InterfaceIsRaisedWithEveryChangeOfLayout) {
  EXPECT_EQ(kPluginInterface, 2);
  EXPECT_EQ(layout(), R"(0 map.resolution_m
8 map.voxels
24 sensor_model.p_occ
32 sensor_model.p_free
40 sensor_model.log_odds_min
48 sensor_model.log_odds_max
56 sensor_model.no_returns
64 survival.enabled
72 survival.outside_view
80 survival.shadow
88 survival.shadow_range_m
96 prediction.sub_voxel
104 prediction.min_speed_mps
112 particles.count
120 particles.sigma_xy_mps
128 particles.sigma_z_mps
136 particles.birth
144 particles.min_per_voxel
152 clusters.occupied_above
160 clusters.static_below_mps
168 clusters.readjust
176 execution.threads
184 execution.seed
192 Parameters, 248 Scan, 104 LocalMap, 80 Cluster, 96 Method)");
}

}  // namespace
}  // namespace ldm
