/// The parameters of recordings as a table.
#include "datasets/recording/scans/input_parameters.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "tests/text_file.h"

namespace datasets {
namespace {

TEST(InputParameters, EveryOneHasANameAndReadsBack) {
  std::set<std::string> names;
  InputParameters parameters;
  visit_parameters(parameters, [&](const ldm::ParameterInfo& info, auto&, const auto&...) {
    const std::string name(info.name);
    EXPECT_TRUE(is_input_parameter(name)) << name;
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_LE(info.min, info.max) << name;
    InputParameters copy;
    set_parameter(copy, name, get_parameter(parameters, name));
    EXPECT_EQ(get_parameter(copy, name), get_parameter(parameters, name));
  });
  EXPECT_EQ(names.size(), 30u);
  EXPECT_FALSE(is_input_parameter("map.voxels"));
}

TEST(InputParameters, SetByText) {
  InputParameters parameters;
  set_parameter(parameters, "input.ground.removal", "plane");
  EXPECT_EQ(parameters.ground.removal, GroundRemoval::kPlane);
  set_parameter(parameters, "input.sensor.from_log", "false");
  EXPECT_FALSE(parameters.sensor.from_log);
  set_parameter(parameters, "input.sensor.yaw_deg", "-90");
  EXPECT_EQ(parameters.sensor.yaw, -90);
  const auto error = [&](const std::string& name, const std::string& text) {
    return tests::message_of<ldm::InvalidInput>([&] { set_parameter(parameters, name, text); });
  };
  EXPECT_EQ(error("input.ground.removal", "constant"),
            "input.ground.removal = constant: allowed: none, plane, grid");
  EXPECT_EQ(error("input.min_range_m", "-1"),
            "input.min_range_m = -1: allowed: a number from 0 to 1000 m");
  EXPECT_EQ(error("input.colour", "red"),
            "unknown parameter input.colour: allowed: a name that `ldm parameters` lists");
}

}  // namespace
}  // namespace datasets
