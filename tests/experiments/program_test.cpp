/// The command line of `ldm`, from outside: exit codes, messages, files.
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/program.h"
#include "tests/source_folder.h"

namespace experiments {
namespace {

constexpr char kSmall[] = " --frames 4 --set particles.count=500 --set execution.threads=1";

TEST_F(Program, ListsWhatThereIs) {
  EXPECT_NE(ldm("methods").out.find("circular_buffer_pf  "), std::string::npos);
  EXPECT_NE(ldm("scenarios").out.find("scenario2"), std::string::npos);
  EXPECT_NE(ldm("studies").out.find("table1  "), std::string::npos);
  EXPECT_NE(ldm("parameters").out.find("particles.count"), std::string::npos);
  EXPECT_EQ(ldm("parameters octomap").out.find("particles.count"), std::string::npos);
  EXPECT_EQ(ldm("parameters octomap").code, 0);
  EXPECT_EQ(ldm("--version").out.rfind("ldm ", 0), 0u);
}

TEST_F(Program, EveryHelpHasAnExample) {
  for (const char* command : {"methods", "scenarios", "parameters", "studies", "trials", "trial",
                              "info", "simulate", "run", "score", "render", "view", "fly"}) {
    const Result result = ldm(std::string(command) + " --help");
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.out.find("Example: ldm " + std::string(command)), std::string::npos)
        << command;
  }
  EXPECT_EQ(ldm("--help").code, 0);
}

TEST_F(Program, RefusesABadCommandLine) {
  expect_bad("swim", "unknown subcommand swim: allowed: methods, scenarios");
  expect_bad("--seed 3", "subcommand");
  expect_bad("run ldm scenario1", "--output");
  for (const char* command : {"run ldm scenario1", "simulate scenario1", "fly ldm moving10_10"}) {
    expect_bad(command + std::string(" --seed -1 -o o"),
               "--seed: -1: allowed: a whole number from 0 on");
  }
  expect_bad("trials table1 --seeds 0", "--seeds");
  expect_bad("trials table1 --seeds many", "many");
  expect_bad("methods --colour", "--colour");
}

TEST_F(Program, BareItPrintsItsHelp) {
  const Result bare = ldm("");
  EXPECT_EQ(bare.code, 0);
  EXPECT_EQ(bare.out, ldm("--help").out);
  EXPECT_EQ(bare.error, "");
}

TEST_F(Program, AsksWhatWasMeant) {
  expect_bad("rnu ldm scenario1 -o o", "; did you mean run?");
  expect_bad("run lmd scenario1 -o o", "; did you mean ldm?");
  expect_bad("run ldm scenaro1 -o o", "; did you mean scenario1?");
  expect_bad("run ldm scenario1 -o o -c raod", "; did you mean road?");
  expect_bad("trials tabel1", "; did you mean table1?");
  expect_bad("run ldm scenario1 -o o --set particles.cuont=3", "; did you mean particles.count?");
  expect_bad("run ldm scenario1 -o o --set scenario.sensor.rate_h=3",
             "; did you mean sensor.rate_hz?");
  expect_bad("run ldm scenario1 -o o --save-frame 3", "; did you mean --save-frames?");
  expect_bad("run ldm scenario1 -o o --format kiti", "; did you mean kitti?");
  expect_bad("run ldm scenario1 -o o --save-as plz", "; did you mean ply?");
  expect_bad("fly lmd still8 -o o", "; did you mean ldm?");
  expect_bad("fly ldm stil8 -o o", "; did you mean still8?");
  expect_bad("fly ldm still8 -o o --set flight.dealy_s=0.1", "; did you mean flight.delay_s?");
  expect_bad("parameters scenario33", "; did you mean scenario3?");
  expect_bad("trial " + write_study() + " scenario1.curent_scan.s001 -o r.json",
             "; did you mean scenario1.current_scan.s001?");
  expect_bad("trials " + write_study("serie = true\n"), "; did you mean series?");
  EXPECT_EQ(ldm("run kalman scenario1 -o o").error.find("did you mean"), std::string::npos);
}

TEST_F(Program, ListsForPrograms) {
  const std::string methods = ldm("methods --json").out;
  EXPECT_EQ(methods.rfind("[{\"name\":\"ldm\",\"help\":\"the paper's Local", 0), 0u) << methods;
  EXPECT_NE(methods.find("\"overrides\":{\"sensor_model.log_odds_max\":\"1.0\"}"),
            std::string::npos);
  const std::string parameters = ldm("parameters ldm --json").out;
  EXPECT_NE(parameters.find("{\"name\":\"map.resolution_m\",\"symbol\":\"r\",\"value\":\"0.15\","
                            "\"unit\":\"m\",\"min\":0.01,\"max\":10.0,\"words\":[],"),
            std::string::npos)
      << parameters;
  EXPECT_NE(parameters.find("\"min\":null,\"max\":null,\"words\":[\"free\",\"drop\"]"),
            std::string::npos);
}

TEST_F(Program, ListsTheValuesOfScenarios) {
  const std::string any = ldm("parameters scenario").out;
  EXPECT_NE(any.find("sensor.range_sigma_m "), std::string::npos) << any;
  for (const char* name : {"uav.waypoints ", "uav.timetable_s_m ", "groups.NAME.stride_m ",
                           "groups.NAME.pause_s ", "groups.NAME.lateness_s "}) {
    EXPECT_NE(any.find(name), std::string::npos) << name;
  }
  const std::string one = ldm("parameters scenario3").out;
  EXPECT_NE(one.find("sensor.rate_hz "), std::string::npos) << one;
  EXPECT_NE(one.find("groups.boxes.count "), std::string::npos);
  EXPECT_EQ(one.find("groups.NAME"), std::string::npos);
  expect_bad("parameters scenario4", "unknown method or scenario scenario4");
}

TEST_F(Program, CompletesWhatIsTyped) {
  EXPECT_EQ(ldm("complete sc").out, "scenarios\nscore\n");
  EXPECT_EQ(ldm("complete run circ").out,
            "circular_buffer\ncircular_buffer_low_clamp\ncircular_buffer_pf\n"
            "circular_buffer_pf_eq17\ncircular_buffer_pf_free\n");
  EXPECT_EQ(ldm("complete run ldm scenario").out,
            "scenario1\nscenario1_fast\nscenario2\nscenario3\nscenario3_fast\n");
  EXPECT_EQ(ldm("complete run octomap scenario1 --set map.").out,
            "map.resolution_m=\nmap.voxels=\n");
  EXPECT_EQ(ldm("complete run octomap scenario1 --set particles.").out, "");
  EXPECT_EQ(ldm("complete simulate scenario1 --set scenario.sensor.range").out,
            "scenario.sensor.range_m=\nscenario.sensor.range_sigma_m=\n");
  EXPECT_EQ(ldm("complete simulate scenario1 --set map").out, "");
  EXPECT_EQ(ldm("complete view ldm --paus").out, "--paused\n");
  EXPECT_EQ(ldm("complete run ldm scenario1 -c r").out, "road\n");
  EXPECT_EQ(ldm("complete run ldm scenario1 --format kit").out, "kitti\nkitti-raw\n");
  EXPECT_EQ(ldm("complete trial " + write_study() + " scenario1.current_scan.s00").out,
            "scenario1.current_scan.s001\nscenario1.current_scan.s002\n"
            "scenario1.current_scan.s003\n");
  EXPECT_EQ(ldm("complete nothing ").code, 0);
}

TEST_F(Program, CompletesFlights) {
  EXPECT_EQ(ldm("complete fly or").out, "oracle\noracle_future\n");
  EXPECT_EQ(ldm("complete fly oc").out, "octomap\n");
  EXPECT_EQ(ldm("complete fly ldm reversing").out, "reversing_01\nreversing_03\n");
  EXPECT_EQ(ldm("complete fly ldm scenario").out, "") << "those are no worlds to fly through";
  EXPECT_EQ(ldm("complete fly ldm still8 --set trust.").out,
            "trust.margin_m=\ntrust.doubt=\ntrust.moving_from_mps=\n");
  EXPECT_EQ(ldm("complete fly ldm still8 --set particles.c").out, "particles.count=\n");
  EXPECT_EQ(ldm("complete fly octomap still8 --set particles.").out, "");
  EXPECT_EQ(ldm("complete fly oracle still8 --set map.").out, "map.resolution_m=\nmap.voxels=\n");
  EXPECT_EQ(ldm("complete fly oracle still8 --set scenario.sensor.range").out,
            "scenario.sensor.range_m=\nscenario.sensor.range_sigma_m=\n");
  EXPECT_EQ(ldm("complete fly nobody still8 --set flight.d").out, "flight.delay_s=\n");
  EXPECT_EQ(ldm("complete fly ldm still8 --vid").out, "--video\n");
}

TEST_F(Program, BashCompletes) {
  const std::string script = (tests::source_folder() / "experiments/shell/ldm.bash").string();
  const auto complete = [&](const std::string& line) {
    return run("bash", "-c '. " + script + "; ldm() { " + LDM_PROGRAM + " \"$@\"; }; " +
                           "COMP_LINE=\"" + line + "\"; COMP_POINT=${#COMP_LINE}; _ldm; " +
                           "printf \"%s\\n\" \"${COMPREPLY[@]}\"'")
        .out;
  };
  EXPECT_EQ(complete("ldm sim"), "simulate\n");
  EXPECT_EQ(complete("ldm run "), ldm("complete run \"\"").out);
  EXPECT_EQ(complete("ldm run ldm scenario1 --format kit"), "kitti\nkitti-raw\n");
  EXPECT_EQ(complete("ldm run ldm scenario1 --set map.v"), "map.voxels=\n");
}

TEST_F(Program, SetsValuesOfScenarios) {
  const std::string sigma = " --set scenario.sensor.range_sigma_m=0.5";
  const std::string run = "run ldm scenario1" + std::string(kSmall);
  ASSERT_EQ(ldm(run + " -o plain").code, 0);
  const Result noisy = ldm(run + sigma + " -o noisy");
  ASSERT_EQ(noisy.code, 0) << noisy.error;
  EXPECT_NE(folder_.read("noisy/clusters.csv"), folder_.read("plain/clusters.csv"));
  EXPECT_NE(
      folder_.read("noisy/summary.json").find("\"set\":[\"scenario.sensor.range_sigma_m=0.5\"]"),
      std::string::npos);

  ASSERT_EQ(ldm("simulate scenario1 --frames 4" + sigma + " -o a.rawlog").code, 0);
  EXPECT_NE(folder_.read("a.log.toml").find("range_sigma_m = 0.5\n"), std::string::npos);
  ASSERT_EQ(ldm("run ldm a.rawlog -o log" + std::string(kSmall)).code, 0);
  EXPECT_EQ(folder_.read("log/clusters.csv"), folder_.read("noisy/clusters.csv"));

  folder_.write("p.toml", "[scenario.sensor]\nrange_sigma_m = 0.5\n");
  ASSERT_EQ(ldm(run + " -c p.toml -o file").code, 0);
  EXPECT_EQ(folder_.read("file/clusters.csv"), folder_.read("noisy/clusters.csv"));

  const std::string picture = "render ldm scenario1 --frame 1 --set particles.count=500 -o ";
  ASSERT_EQ(ldm(picture + "plain.png").code, 0);
  ASSERT_EQ(ldm(picture + "noisy.png" + sigma).code, 0);
  EXPECT_NE(folder_.read("plain.png"), folder_.read("noisy.png"));
  ASSERT_EQ(ldm("render noisy --frame 1 -o again.png").code, 0);
  EXPECT_EQ(folder_.read("again.png"), folder_.read("noisy.png"));

  expect_bad("run ldm a.rawlog -o b" + sigma,
             "--set: scenario.sensor.range_sigma_m = 0.5: allowed: "
             "with a scenario");
  expect_bad("run ldm scenario1 -o b --set scenario.sensor.range_sigma_m=99",
             "--set: scenario: sensor.range_sigma_m = 99: allowed: a number in [0, 10]");
  expect_bad("simulate scenario1 -o b.rawlog --set map.voxels=8", "allowed: scenario.NAME=VALUE");
}

TEST_F(Program, TrialsOfAStudy) {
  const Result result = ldm("trials " + write_study() + " --seeds 2");
  EXPECT_EQ(result.out, "scenario1.current_scan.s001\nscenario1.current_scan.s002\n");
  const std::string json = ldm("trials " + write_study() + " --seeds 2 --json").out;
  EXPECT_NE(json.find("\"study\": \"tiny\""), std::string::npos);
  EXPECT_NE(json.find("\"methods\": {\"current_scan\":\"current_scan\"}"), std::string::npos);
  EXPECT_NE(json.find("\"datasets/scenarios/scenario1.toml\":"), std::string::npos);
  EXPECT_NE(json.find("{\"id\":\"scenario1.current_scan.s002\",\"scenario\":\"scenario1\","
                      "\"method\":\"current_scan\",\"replicate\":2}"),
            std::string::npos);
  EXPECT_NE(ldm("studies --json").out.find("\"study\": \"table1\""), std::string::npos);
  expect_bad("trials moon", "unknown study moon: allowed: a .toml file, ablation");
  expect_bad("trials " + write_study("speed = 1\n"), "tiny.toml:6: speed");
}

TEST_F(Program, TrialWritesItsRecord) {
  const Result result = ldm("trial " + write_study() + " scenario1.current_scan.s003 -o r.json");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_NE(folder_.read("r.json").find("\"status\": \"ok\""), std::string::npos);
  EXPECT_NE(folder_.read("r.json").find("\"frames\": 4"), std::string::npos);
}

TEST_F(Program, TheCommandOfARecordRepeatsIt) {
  ldm("trial " + write_study() + " scenario1.current_scan.s002 --frames 3 --seeds 9 -o r.json");
  const std::string record = folder_.read("r.json");
  constexpr std::string_view kKey = "\"command\": \"ldm ";
  const std::size_t begin = record.find(kKey) + kKey.size();
  const Result result = ldm(record.substr(begin, record.find('"', begin) - begin));
  EXPECT_EQ(result.code, 0) << result.error;
  const auto untimed = [](const std::string& text) {
    return text.substr(0, text.find("\"timing\""));
  };
  EXPECT_EQ(untimed(folder_.read("scenario1.current_scan.s002.json")), untimed(record));
}

TEST_F(Program, BadTrialsLeaveNoRecord) {
  const std::string study = write_study();
  expect_bad("trial " + study + " scenario1.current_scan.s004 -o r.json", "has no trial");
  expect_bad("trial " + study + " scenario1.current_scan.s001 --frames 9999 -o r.json",
             "frames = 9999: allowed: at most");
  expect_bad("trial " + study + " scenario1.current_scan.s001 -o none/r.json",
             "none/r.json: cannot be written");
  EXPECT_FALSE(exists("r.json"));
}

TEST_F(Program, AFailedTrialLeavesARecordAndCodeOne) {
  const std::string study = write_study("[set]\n\"scenario.area.size_m\" = [1, 1]\n");
  const Result result = ldm("trial " + study + " scenario1.current_scan.s001 -o r.json");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(lines(result.error), 1u) << result.error;
  EXPECT_NE(result.error.find("ldm: trial scenario1.current_scan.s001 failed: "),
            std::string::npos);
  EXPECT_NE(folder_.read("r.json").find("\"status\": \"failed\""), std::string::npos);
}

TEST_F(Program, RecordsHowATrialEndedWithoutRunningIt) {
  const Result result = ldm("trial " + write_study() +
                            " scenario1.current_scan.s001 -o r.json --failed 'killed by SIGSEGV'");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_NE(folder_.read("r.json").find("\"error\": \"killed by SIGSEGV\""), std::string::npos);
}

TEST_F(Program, RunWritesItsTables) {
  const Result result = ldm("run ldm scenario1 -o o" + std::string(kSmall));
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.error, "");  // no progress line: stderr is no terminal
  EXPECT_EQ(folder_.read("o/clusters.csv")
                .rfind("frame,time_s,cluster,track,age_s,x_m,y_m,z_m,size_x_m,size_y_m,size_z_m,"
                       "vx_mps,vy_mps,vz_mps,vx_vx_m2ps2,vx_vy_m2ps2,vy_vy_m2ps2,voxels,points,"
                       "dynamic\n0,0.000000,0,1,0.000000,",
                       0),
            0u);
  EXPECT_EQ(lines(folder_.read("o/timing.csv")), 5u);
  EXPECT_EQ(folder_.read("o/timing.csv").rfind("frame,occupancy_prediction_ms,", 0), 0u);
  EXPECT_NE(folder_.read("o/summary.json").find("\"scores\": {\"accuracy_pct\":"),
            std::string::npos);
}

TEST_F(Program, RunTakesParametersFromFileAndCommandLine) {
  folder_.write("p.toml", "[particles]\ncount = 700\nsigma_xy_mps = 0.5\n");
  const Result result = ldm("run ldm scenario1 -o o -c p.toml" + std::string(kSmall));
  EXPECT_EQ(result.code, 0) << result.error;
  const std::string summary = folder_.read("o/summary.json");
  EXPECT_NE(summary.find("\"particles.count\":500"), std::string::npos);
  EXPECT_NE(summary.find("\"particles.sigma_xy_mps\":0.5"), std::string::npos);
}

TEST_F(Program, ARecordedLogRunsLikeItsScenario) {
  ASSERT_EQ(ldm("simulate scenario1 --seed 7 --frames 4 -o a.rawlog").code, 0);
  ASSERT_EQ(ldm("run ldm a.rawlog -o log" + std::string(kSmall)).code, 0);
  ASSERT_EQ(ldm("run ldm scenario1 --seed 7 -o live" + std::string(kSmall)).code, 0);
  EXPECT_EQ(folder_.read("log/clusters.csv"), folder_.read("live/clusters.csv"));
  const auto scores = [](const std::string& summary) {
    const std::size_t begin = summary.find("\"scores\"");
    return summary.substr(begin, summary.find("\"timing\"") - begin);
  };
  EXPECT_EQ(scores(folder_.read("log/summary.json")), scores(folder_.read("live/summary.json")));
}

TEST_F(Program, RefusesBadRuns) {
  expect_bad("run kalman scenario1 -o o", "unknown method kalman: allowed: ldm");
  expect_bad(
      "run ldm moon -o o",
      "moon: no such recording or scenario: allowed: a file or folder that is there, a .toml");
  expect_bad("run ldm scenario1 -o o --set map.colour=3", "--set: unknown parameter map.colour");
  expect_bad("run ldm scenario1 -o o --set map.voxels=4", "--set: map.voxels = 4: allowed: ");
  expect_bad("run ldm scenario1 -o o --set particles.count=1.5", "particles.count = 1.5");
  expect_bad("run octomap scenario1 -o o --set particles.count=15", "parameters that octomap uses");
  expect_bad("run ldm scenario1 -o o --set particles.count", "allowed: name=value");
  expect_bad("run ldm scenario1 -o o -c none.toml", "none.toml: cannot be read");
  folder_.write("p.toml", "[map]\nresolution_m = \"fine\"\n");
  expect_bad("run ldm scenario1 -o o -c p.toml", "p.toml:2: map.resolution_m = fine");
  expect_bad("run ldm none.rawlog -o o", "none.rawlog: cannot be read");
  expect_bad("run ldm scenario1 -o p.toml/o", "p.toml/o: cannot be made");
  EXPECT_FALSE(exists("o"));
}

TEST_F(Program, ATruncatedLogLeavesNoTables) {
  ASSERT_EQ(ldm("simulate scenario1 --frames 4 -o a.rawlog").code, 0);
  std::filesystem::resize_file(folder_.path() / "a.rawlog",
                               std::filesystem::file_size(folder_.path() / "a.rawlog") / 2);
  expect_bad("run current_scan a.rawlog -o o", "a.rawlog");
  EXPECT_TRUE(!exists("o") || std::filesystem::is_empty(folder_.path() / "o"));
}

TEST_F(Program, ALogHasNoSeed) {
  ASSERT_EQ(ldm("simulate scenario1 --frames 2 -o a.rawlog").code, 0);
  expect_bad("run current_scan a.rawlog --seed 3 -o o", "--seed 3: allowed: with a scenario");
}

TEST_F(Program, DataFolderFromOptionOrEnvironment) {
  std::filesystem::create_directories(folder_.path() / "data/datasets/scenarios");
  std::filesystem::copy_file(tests::source_folder() / "datasets/scenarios/scenario1.toml",
                             folder_.path() / "data/datasets/scenarios/mine.toml");
  EXPECT_EQ(ldm("--data-dir data scenarios").out.rfind("mine  ", 0), 0u);
  EXPECT_EQ(ldm("scenarios", "LDM_DATA_DIR=data").out.rfind("mine  ", 0), 0u);
  expect_bad("--data-dir none scenarios", "none/datasets/scenarios: cannot be read");
}

}  // namespace
}  // namespace experiments
