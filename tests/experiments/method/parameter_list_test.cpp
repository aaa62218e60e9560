#include "experiments/method/parameter_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>

#include "datasets/files/text.h"
#include "datasets/scenario/scenario.h"
#include "tests/source_folder.h"

namespace experiments {
namespace {

const DataFolders kShipped{tests::source_folder().string()};

std::string document() {
  std::ostringstream text;
  text << std::ifstream(tests::source_folder() / "docs/scenarios.md").rdbuf();
  return text.str();
}

TEST(ParameterList, OfScenariosIsTheTableOfTheDocument) {
  std::string table = "| key | unit | range | meaning |\n|---|---|---|---|\n";
  for (const ListedParameter& p : listed_parameters("scenario", kShipped)) {
    const std::string range = p.words.empty() ? p.range() : datasets::joined(p.words);
    table += "| `" + p.name + "` | " + (p.unit.empty() ? "-" : p.unit) + " | " + range + " | " +
             p.help + " |\n";
  }
  EXPECT_NE(document().find("\n" + table + "\n"), std::string::npos) << table;
}

TEST(ParameterList, HasEveryValueOfTheShippedScenarios) {
  std::set<std::string> known;
  for (const ListedParameter& p : listed_parameters("scenario", kShipped)) {
    EXPECT_TRUE(known.insert(p.name).second) << p.name;
    EXPECT_FALSE(p.help.empty() || p.source.empty()) << p.name;
  }
  for (const std::string& name : kShipped.scenarios.names()) {
    const auto list = listed_parameters(name, kShipped);
    const datasets::Scenario scenario = datasets::read_scenario(kShipped.scenarios.file(name));
    const auto values = datasets::scenario_values(scenario);
    ASSERT_EQ(list.size(), values.size()) << name;
    for (std::size_t i = 0; i < list.size(); ++i) {
      EXPECT_EQ(list[i].name, values[i].first);
      EXPECT_EQ(list[i].value, values[i].second);
      std::string general = list[i].name;
      if (general.starts_with("groups."))
        general = "groups.NAME" + general.substr(general.rfind('.'));
      EXPECT_TRUE(known.contains(general)) << general;
    }
  }
}

TEST(ParameterList, UnitsAreThoseOfTheNames) {
  const std::pair<std::string, std::string> endings[] = {
      {"_mps2", "m/s^2"}, {"_mps", "m/s"}, {"_deg", "deg"}, {"_hz", "Hz"},
      {"_s_m", "s, m"},   {"_m", "m"},     {"_s", "s"}};
  for (const auto& of : {std::optional<std::string>(), std::optional<std::string>("scenario")}) {
    for (const ListedParameter& p : listed_parameters(of, kShipped)) {
      const auto* const ending =
          std::find_if(std::begin(endings), std::end(endings),
                       [&](const auto& e) { return p.name.ends_with(e.first); });
      EXPECT_EQ(p.unit, ending == std::end(endings) ? "" : ending->second) << p.name;
    }
  }
}

}  // namespace
}  // namespace experiments
