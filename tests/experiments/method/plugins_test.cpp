#include "experiments/method/plugins.h"

#include <gtest/gtest.h>

#include "tests/experiments/program.h"

namespace experiments {
namespace {

const std::string kPlugins = LDM_PLUGINS;
const std::string kExample = " --plugin " + kPlugins + "fading_buffer.so";

/// A record or summary up to its timing, from its parameters on.
std::string results(const std::string& json) {
  const std::size_t begin = json.find("\"parameters\"");
  return json.substr(begin, json.find("\"timing\"") - begin);
}

TEST(Plugins, ThatAreNoneAreRefused) {
  const tests::TemporaryFolder folder;
  const std::string none = (folder.path() / "none.so").string();
  EXPECT_EQ(tests::message_of([&] { load_plugin(none); }),
            "--plugin " + none + ": no such file: allowed: a shared object");
  const std::string text = folder.write("text.so", "no code").string();
  EXPECT_EQ(tests::message_of([&] { load_plugin(text); }),
            "--plugin " + text + ": cannot be loaded (" + text +
                ": file too short): allowed: a shared object");
  EXPECT_EQ(tests::message_of([] { load_plugin(kPlugins + "no_plugin.so"); }),
            "--plugin " + kPlugins +
                "no_plugin.so: has no ldm_plugin_interface: allowed: a shared object with "
                "LDM_PLUGIN of ldm/plugin.h");
}

TEST(Plugins, OfAnotherInterfaceAreRefused) {
  const std::string ours = std::to_string(ldm::kPluginInterface);
  const std::string theirs = std::to_string(ldm::kPluginInterface + 1);
  EXPECT_EQ(tests::message_of([] { load_plugin(kPlugins + "other_interface.so"); }),
            "--plugin " + kPlugins + "other_interface.so: interface " + theirs +
                ": allowed: interface " + ours + "; build it with the library of this program");
}

TEST(Plugins, WithABadRowAddNone) {
  EXPECT_EQ(tests::message_of([] { load_plugin(kPlugins + "no_create.so"); }),
            "--plugin " + kPlugins + "no_create.so: method idle has no create");
  EXPECT_NE(tests::message_of([] {
              load_plugin(kPlugins + "taken_name.so");
            }).find("taken_name.so: method ldm exists already: allowed: other names than "),
            std::string::npos);
  EXPECT_NE(tests::message_of([] { find_method("new"); }).find("unknown method new"),
            std::string::npos);
}

class PluginProgram : public Program {};

TEST_F(PluginProgram, RefusesNamesThatNoFileMayHave) {
  const std::string list = "methods --plugin " + kPlugins + "bad_names.so";
  for (const std::string name : {"", "../../x y", "a.b", "a/b"}) {
    const Result result = ldm(list, "LDM_TEST_NAME='" + name + "'");
    EXPECT_EQ(result.code, 2) << name;
    EXPECT_NE(result.error.find("bad_names.so: method \"" + name +
                                "\": allowed: a name of letters, digits, _ and -\n"),
              std::string::npos)
        << result.error;
  }
  EXPECT_EQ(ldm(list, "LDM_TEST_NAME=a_B-9").code, 0);
}

TEST_F(PluginProgram, AMapThatIsNoneFailsItsTrial) {
  const std::pair<std::string, std::string> faults[] = {
      {"not_a_number", "not_a_number, frame 2: map.occupancy[4] = nan: allowed: 0 to 1"},
      {"short_array", "short_array, frame 2: length of map.occupancy = 100: allowed: 32768, "},
      {"wild_label", "wild_label, frame 2: map.labels[8] = 999: allowed: -1 to "},
      {"wild_cluster", "].velocity = (nan, 0, 0): allowed: finite numbers"}};
  const std::string study = write_study();
  const std::string plugin = " --plugin " + kPlugins + "bad_maps.so";
  for (const auto& [method, message] : faults) {
    const Result trial = ldm("trial " + study + " --method " + method + plugin + " scenario1." +
                             method + ".s001 -o r.json");
    EXPECT_EQ(trial.code, 1) << method;
    EXPECT_NE(trial.error.find(message), std::string::npos) << trial.error;
    const std::string record = folder_.read("r.json");
    EXPECT_NE(record.find("\"status\": \"failed\""), std::string::npos) << method;
    EXPECT_NE(record.find(message), std::string::npos) << record;
    EXPECT_EQ(record.find("\"scores\""), std::string::npos) << method;
  }
  const Result flown = ldm("fly wild_label still8 -o f --set particles.count=500" + plugin);
  EXPECT_EQ(flown.code, 1);
  EXPECT_NE(flown.error.find("wild_label, frame 2: map.labels[8] = 999"), std::string::npos)
      << flown.error;
  const Result picture =
      ldm("render wild_label scenario1 --frame 3 -o p.png --set particles.count=500" + plugin);
  EXPECT_EQ(picture.code, 1);
  EXPECT_NE(picture.error.find("wild_label, frame 2: map.labels[8]"), std::string::npos);
}

TEST_F(PluginProgram, ListsTheirMethodsAndParameters) {
  EXPECT_NE(ldm("methods" + kExample).out.find("fading_buffer  "), std::string::npos);
  EXPECT_EQ(ldm("methods").out.find("fading_buffer  "), std::string::npos);
  const Result parameters = ldm(kExample + " parameters fading_buffer");
  EXPECT_NE(parameters.out.find("P_s     0.95 "), std::string::npos) << parameters.out;
  EXPECT_EQ(parameters.out.find("particles."), std::string::npos);
}

TEST_F(PluginProgram, RefusesBadOnesInOneLine) {
  expect_bad("methods --plugin none.so", "none.so: no such file");
  expect_bad("methods --plugin " + kPlugins + "other_interface.so", ": allowed: interface ");
  expect_bad("methods" + kExample + kExample, "method fading_buffer exists already");
}

TEST_F(PluginProgram, RunsTheirMethodsAndSaysWhereTheyCameFrom) {
  const Result result =
      ldm("run fading_buffer scenario1 -o o --frames 4 --set survival.shadow=0.5" + kExample);
  EXPECT_EQ(result.code, 0) << result.error;
  const std::string summary = folder_.read("o/summary.json");
  EXPECT_NE(summary.find("\"plugin\":{\"file\":\"fading_buffer.so\",\"hash\":\""),
            std::string::npos);
  EXPECT_NE(summary.find("\"survival.outside_view\":0.95"), std::string::npos);
  expect_bad("run fading_buffer scenario1 -o p --set particles.count=9" + kExample,
             "parameters that fading_buffer uses");
}

TEST_F(PluginProgram, CatchesWhatTheyThrow) {
  const std::string plugin = " --plugin " + kPlugins + "refusing.so";
  expect_bad("run refusing scenario1 -o o" + plugin, "ldm: map.voxels = 32: allowed: none");
  const Result failed = ldm("run failing scenario1 -o o" + plugin);
  EXPECT_EQ(failed.code, 1);
  EXPECT_EQ(failed.error, "ldm: out of luck\n");
}

TEST_F(PluginProgram, JoinsAStudy) {
  const std::string study = write_study();
  const std::string beside = study + " --method fading_buffer" + kExample;
  EXPECT_EQ(ldm("trials " + beside + " --seeds 2").out,
            "scenario1.fading_buffer.s001\nscenario1.fading_buffer.s002\n");
  expect_bad("trials " + study + " --method fading_buffer", "--method: unknown method fading_buf");
  expect_bad("trials " + beside + " --method fading_buffer", "--method: fading_buffer comes twice");

  const Result trial = ldm("trial " + beside + " scenario1.fading_buffer.s002 -o r.json");
  EXPECT_EQ(trial.code, 0) << trial.error;
  const std::string record = folder_.read("r.json");
  EXPECT_NE(record.find("\"command\": \"ldm" + kExample + " trial "), std::string::npos) << record;
  EXPECT_NE(record.find(" -o scenario1.fading_buffer.s002.json --method fading_buffer\""),
            std::string::npos);
}

TEST_F(PluginProgram, IsNamedByAStudy) {
  const std::string study = folder_
                                .write("mine.toml",
                                       "title = \"mine\"\nscenarios = [\"scenario1\"]\n"
                                       "methods = [\"ldm\", \"fading_buffer\"]\n"
                                       "seeds = 1\nframes = 4\n")
                                .string();
  EXPECT_EQ(ldm("trials " + study + kExample).out,
            "scenario1.ldm.s001\nscenario1.fading_buffer.s001\n");
  expect_bad("trials " + study, "mine.toml:3: unknown method fading_buffer: allowed: ldm");
}

TEST_F(PluginProgram, IsNoPartOfTheRecordsOfOtherMethods) {
  const std::string trial = "trial " + write_study() + " scenario1.current_scan.s001 -o r.json";
  ASSERT_EQ(ldm(trial).code, 0);
  const std::string without = results(folder_.read("r.json"));
  ASSERT_EQ(ldm(trial + kExample).code, 0);
  EXPECT_EQ(results(folder_.read("r.json")), without);
}

/// docs/variants.md: the same file, as a plugin and as a row of the table.
TEST_F(PluginProgram, AVariantInsideAndOutsideIsTheSame) {
  const std::string run = "run fading_buffer scenario1 --frames 4 -o ";
  ASSERT_EQ(ldm(run + "outside" + kExample).code, 0);
  const Result inside = this->run(LDM_WITH_VARIANT, run + "inside");
  ASSERT_EQ(inside.code, 0) << inside.error;
  const auto scores = [this](const std::string& folder) {
    const std::string text = results(folder_.read(folder + "/summary.json"));
    return text.substr(text.find("\"scores\""));
  };
  EXPECT_EQ(scores("inside"), scores("outside"));
  EXPECT_EQ(folder_.read("inside/summary.json").find("\"plugin\""), std::string::npos);
}

}  // namespace
}  // namespace experiments
