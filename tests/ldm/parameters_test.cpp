#include "ldm/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

#include "ldm/machine/parallel.h"

namespace ldm {
namespace {

/// What set_parameter says; empty if it takes the text. A refusal must change nothing.
std::string refusal(std::string_view name, std::string_view text) {
  Parameters parameters;
  try {
    set_parameter(parameters, name, text);
    return "";
  } catch (const InvalidInput& error) {
    const Parameters defaults;
    visit_parameters(defaults, [&](const ParameterInfo& info, const auto&, const auto&...) {
      EXPECT_EQ(get_parameter(parameters, info.name), get_parameter(defaults, info.name));
    });
    return error.what();
  }
}

/// Two values of each parameter, neither of which is the default for both.
template <class T>
std::vector<std::string> samples(const ParameterInfo& info, const T&) {
  if constexpr (std::is_same_v<T, bool>) {
    return {"true", "false"};
  } else if constexpr (std::is_same_v<T, Eigen::Vector3i>) {
    return {"5,12,512", "33,7,64"};
  } else if constexpr (std::is_same_v<T, double>) {
    return {std::to_string((info.min + info.max) / 2), std::to_string(info.max)};
  } else {
    const auto low = static_cast<std::int64_t>(info.min);
    return {std::to_string(low), std::to_string(low + 3)};
  }
}
template <class T, class Names>
std::vector<std::string> samples(const ParameterInfo&, const T&, const Names& names) {
  return {std::begin(names), std::end(names)};
}

TEST(ParametersTest, DefaultsAreThePapers) {
  const std::map<std::string, std::string> paper = {
      {"map.resolution_m", "0.15"},         {"map.voxels", "32,32,32"},
      {"particles.count", "200000"},        {"particles.birth", "true"},
      {"sensor_model.p_occ", "0.7"},        {"sensor_model.p_free", "0.4"},
      {"sensor_model.log_odds_min", "-2"},  {"sensor_model.log_odds_max", "3.5"},
      {"survival.enabled", "true"},         {"clusters.readjust", "true"},
      {"prediction.sub_voxel", "residual"}, {"prediction.min_speed_mps", "0.1"},
  };
  for (const auto& [name, value] : paper) EXPECT_EQ(get_parameter({}, name), value) << name;
  EXPECT_NO_THROW(checked(Parameters{}));
}

TEST(ParametersTest, ThreadsPayByTheSizeOfTheMap) {
  const std::int64_t cores = Parallel::at_once();
  Parameters parameters;
  EXPECT_EQ(threads_that_pay(parameters), 1);  // 32^3 and 200,000
  parameters.map.voxels = {100, 100, 80};      // 800,000: a million in all
  EXPECT_EQ(threads_that_pay(parameters), 1);
  ++parameters.particles.count;
  EXPECT_EQ(threads_that_pay(parameters), std::min<std::int64_t>(2, cores));
  parameters.map.voxels.setConstant(512);
  EXPECT_EQ(threads_that_pay(parameters), std::min<std::int64_t>(135, cores));
}

TEST(ParametersTest, EachIsSetFromItsText) {
  int seen = 0;
  Parameters parameters;
  visit_parameters(parameters, [&](const ParameterInfo& info, auto& value, const auto&... names) {
    const auto texts = samples(info, value, names...);
    ASSERT_GE(texts.size(), 2u);
    std::set<std::string> read;
    for (const std::string& text : texts) {
      set_parameter(parameters, info.name, text);
      const std::string back = get_parameter(parameters, info.name);
      read.insert(back);
      Parameters copy;
      set_parameter(copy, info.name, back);
      EXPECT_EQ(get_parameter(copy, info.name), back) << info.name;
      EXPECT_NO_THROW(checked(parameters)) << info.name << " = " << text;
    }
    EXPECT_EQ(read.size(), texts.size()) << info.name;
    ++seen;
  });
  EXPECT_GT(seen, 20);
}

TEST(ParametersTest, TextReachesTheMember) {
  Parameters p;
  set_parameter(p, "map.resolution_m", "0.1");
  set_parameter(p, "map.voxels", "7,8,9");
  set_parameter(p, "sensor_model.no_returns", "drop");
  set_parameter(p, "survival.enabled", "false");
  set_parameter(p, "prediction.sub_voxel", "trilinear");
  set_parameter(p, "particles.count", "1234");
  set_parameter(p, "execution.seed", "18446744073709551615");
  EXPECT_EQ(p.map.resolution, 0.1);
  EXPECT_EQ(p.map.voxels, Eigen::Vector3i(7, 8, 9));
  EXPECT_EQ(p.sensor_model.no_returns, NoReturnRays::kDrop);
  EXPECT_FALSE(p.survival.enabled);
  EXPECT_EQ(p.prediction.sub_voxel, SubVoxelMotion::kTrilinear);
  EXPECT_EQ(p.particles.count, 1234);
  EXPECT_EQ(p.execution.seed, std::numeric_limits<std::uint64_t>::max());
  set_parameter(p, "map.voxels", "16");
  EXPECT_EQ(p.map.voxels, Eigen::Vector3i(16, 16, 16));
}

TEST(ParametersTest, DoublesSurviveTheRoundTripBitForBit) {
  Parameters p;
  for (const double value : {0.1, 1.0 / 3, 0.7000000000000001, 2.5e-2}) {
    p.particles.sigma_xy = value;
    Parameters copy;
    set_parameter(copy, "particles.sigma_xy_mps", get_parameter(p, "particles.sigma_xy_mps"));
    EXPECT_EQ(copy.particles.sigma_xy, value);
  }
}

TEST(ParametersTest, RefusesWhatIsNoNumber) {
  for (const char* text : {"", " ", "abc", "0.15x", " 0.15", "0.15 ", "0,15", "nan", "inf", "-inf",
                           "1e999", "--1", "+0.15", "true"}) {
    EXPECT_EQ(refusal("map.resolution_m", text),
              std::string("map.resolution_m = ") + text + ": allowed: a number from 0.01 to 10 m");
  }
}

TEST(ParametersTest, RefusesWhatIsNoWholeNumber) {
  for (const char* text :
       {"", "abc", "1.5", "1e3", "0x10", "99999999999999999999", "12 ", "true"}) {
    EXPECT_EQ(refusal("particles.min_per_voxel", text),
              std::string("particles.min_per_voxel = ") + text +
                  ": allowed: a whole number from 1 to 10000");
  }
  for (const char* text : {"-1", "18446744073709551616", "1.0"}) {
    EXPECT_EQ(
        refusal("execution.seed", text)
            .find(std::string("execution.seed = ") + text + ": allowed: a whole number from 0 to "),
        0u);
  }
}

TEST(ParametersTest, RefusesWhatIsNoTruthValue) {
  for (const char* text : {"", "True", "1", "0", "yes", "true "}) {
    EXPECT_EQ(refusal("survival.enabled", text),
              std::string("survival.enabled = ") + text + ": allowed: true, false");
  }
}

TEST(ParametersTest, RefusesUnknownWords) {
  for (const char* text : {"", "Residual", "resid", "2", "residual "}) {
    EXPECT_EQ(refusal("prediction.sub_voxel", text),
              std::string("prediction.sub_voxel = ") + text +
                  ": allowed: none, round, residual, trilinear");
  }
  EXPECT_EQ(refusal("sensor_model.no_returns", "keep"),
            "sensor_model.no_returns = keep: allowed: free, drop");
}

TEST(ParametersTest, RefusesSizesThatAreNotOneOrThreeNumbers) {
  for (const char* text :
       {"", "32,32", "32,32,32,32", "32,32,32,", "32,", ",32", "32,,32", ",,", "32;32;32",
        "32, 32, 32", "32.0", "4", "513", "32,4,32", "32,32,513", "99999999999", "-32,32,32"}) {
    EXPECT_EQ(refusal("map.voxels", text),
              std::string("map.voxels = ") + text +
                  ": allowed: one or three whole numbers from 5 to 512, separated by commas");
  }
}

TEST(ParametersTest, RefusesUnknownNames) {
  for (const char* name : {"", "map", "map.voxel", "voxels", "map.voxels ", "Map.voxels"}) {
    EXPECT_EQ(refusal(name, "32"), std::string("unknown parameter ") + name +
                                       ": allowed: a name that `ldm parameters` lists");
    EXPECT_THROW(get_parameter({}, name), InvalidInput);
  }
}

/// Bounds are inclusive; one step beyond is refused, by text and by `checked`.
TEST(ParametersTest, RangesOfAllNumbers) {
  Parameters parameters;
  visit_parameters(parameters, [&](const ParameterInfo& info, auto& value, const auto&...) {
    using T = std::remove_reference_t<decltype(value)>;
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::int64_t>) {
      const T good = value;
      for (const double end : {info.min, info.max}) {
        value = static_cast<T>(end);
        EXPECT_EQ(refusal(info.name, get_parameter(parameters, info.name)), "");
        EXPECT_NO_THROW(checked(parameters)) << info.name;
        value = static_cast<T>(end == info.min ? end - 1 : end + 1);
        const std::string text = get_parameter(parameters, info.name);
        const std::string said = refusal(info.name, text);
        EXPECT_EQ(said.find(std::string(info.name) + " = " + text + ": allowed: a "), 0u) << said;
        EXPECT_THROW(checked(parameters), InvalidInput) << info.name;
        value = good;
      }
    }
  });
}

TEST(ParametersTest, NamesTheFirstBadParameter) {
  Parameters p;
  p.map.voxels.y() = 4;
  p.particles.count = 0;
  try {
    checked(p);
    FAIL() << "bad parameters were accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "map.voxels = 32,4,32: allowed: one or three whole numbers from 5 to 512, "
                 "separated by commas");
  }
  p.map.voxels.y() = 5;
  EXPECT_THROW(checked(p), InvalidInput);
  p.particles.count = 1;
  EXPECT_NO_THROW(checked(p));
  p.survival.shadow = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(checked(p), InvalidInput);
}

TEST(ParametersTest, NamesAValueThatIsNoWord) {
  Parameters p;
  p.prediction.sub_voxel = static_cast<SubVoxelMotion>(4);
  try {
    checked(p);
    FAIL() << "a bad parameter was accepted";
  } catch (const InvalidInput& error) {
    EXPECT_STREQ(error.what(),
                 "prediction.sub_voxel = 4: allowed: none, round, residual, trilinear");
  }
}

TEST(ParametersTest, NamesAreUniqueAndSourcesAreGiven) {
  std::set<std::string> names;
  const Parameters parameters;
  visit_parameters(parameters, [&](const ParameterInfo& info, const auto& value, const auto&...) {
    EXPECT_TRUE(names.insert(std::string(info.name)).second) << info.name;
    EXPECT_NE(info.name.find('.'), std::string_view::npos);
    EXPECT_FALSE(info.source.empty()) << info.name;
    EXPECT_FALSE(info.help.empty()) << info.name;
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (!std::is_same_v<T, bool>) {
      EXPECT_LT(info.min, info.max) << info.name;
    }
  });
}

}  // namespace
}  // namespace ldm
