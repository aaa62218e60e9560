#include "experiments/method/methods.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/temporary_folder.h"

namespace experiments {
namespace {

TEST(Methods, HaveNamesOfTheirOwnAndKnownParameters) {
  std::set<std::string> known;
  ldm::Parameters defaults;
  ldm::visit_parameters(defaults, [&](const ldm::ParameterInfo& info, auto&, auto&...) {
    known.insert(std::string(info.name));
    known.insert(std::string(info.name.substr(0, info.name.find('.'))));
  });
  std::set<std::string_view> names;
  for (const Method& method : methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    for (const std::string_view used : method.parameters) {
      EXPECT_TRUE(known.contains(std::string(used))) << method.name << " uses " << used;
    }
    for (const auto& [name, value] : method.overrides) EXPECT_TRUE(uses(method, name)) << name;
  }
}

TEST(Methods, AllAnswerAnEmptyScanWithTheirWindow) {
  for (const Method& method : methods()) {
    ldm::Parameters parameters = default_parameters(method);
    parameters.particles.count = 100;
    parameters.map.voxels = {6, 7, 8};
    const std::unique_ptr<ldm::Mapper> mapper = method.create(parameters);
    mapper->update(ldm::Scan{});
    ldm::LocalMap map;
    mapper->read(map);
    EXPECT_EQ(map.window.size, parameters.map.voxels) << method.name;
    EXPECT_EQ(map.occupancy.size(), 336u) << method.name;
    EXPECT_TRUE(map.clusters.empty()) << method.name;
  }
}

TEST(Methods, DefaultsAreTheTableWithTheMethodsOverrides) {
  EXPECT_EQ(default_parameters(find_method("circular_buffer")).sensor_model.log_odds_max, 3.5);
  EXPECT_EQ(default_parameters(find_method("circular_buffer_low_clamp")).sensor_model.log_odds_max,
            1.0);
  EXPECT_FALSE(default_parameters(find_method("circular_buffer_pf")).clusters.readjust);
  EXPECT_EQ(default_parameters(find_method("ldm")).particles.count, 200000);
}

TEST(Methods, UnknownOneListsTheKnown) {
  const std::string message = tests::message_of([] { find_method("kalman"); });
  EXPECT_EQ(message,
            "unknown method kalman: allowed: ldm, object_ldm, circular_buffer, "
            "circular_buffer_low_clamp, circular_buffer_pf, circular_buffer_pf_eq17, "
            "circular_buffer_pf_free, octomap, current_scan, centroid_kalman, exact_positions, "
            "empty_map, "
            "plain_ldm, object_ldm_without_margin, object_ldm_without_outline, "
            "object_ldm_without_slices, object_ldm_without_edges, object_ldm_without_centre, "
            "object_ldm_without_manoeuvres, object_ldm_without_shift, "
            "object_ldm_without_one_return");
}

TEST(Methods, RefuseParametersTheyDoNotUse) {
  const Method& method = find_method("circular_buffer");
  ldm::Parameters parameters;
  apply({"map.voxels", "16", "--set"}, method, parameters);
  EXPECT_EQ(parameters.map.voxels, Eigen::Vector3i::Constant(16));
  EXPECT_EQ(tests::message_of([&] {
              apply({"particles.count", "5", "a.toml:3"}, method, parameters);
            }),
            "a.toml:3: particles.count = 5: allowed: parameters that circular_buffer uses: map, "
            "sensor_model");
}

TEST(Settings, OfACommandLine) {
  const Setting setting = parse_setting("map.voxels=8,8,8");
  EXPECT_EQ(setting.name, "map.voxels");
  EXPECT_EQ(setting.value, "8,8,8");
  EXPECT_NE(tests::message_of([] { parse_setting("map.voxels"); }).find("allowed: name=value"),
            std::string::npos);
  EXPECT_NE(tests::message_of([] { parse_setting("=3"); }).find("allowed: name=value"),
            std::string::npos);
}

}  // namespace
}  // namespace experiments
