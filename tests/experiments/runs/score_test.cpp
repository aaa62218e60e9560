/// `ldm score`, from outside: docs/scores.md.
#include <gtest/gtest.h>

#include <string>

#include "tests/experiments/program.h"

namespace experiments {
namespace {

class Score : public Program {
 protected:
  void SetUp() override {
    ASSERT_EQ(ldm("simulate scenario3 --seed 2 --frames 25 -o a.rawlog").code, 0);
    ASSERT_EQ(ldm("run ldm a.rawlog -o o --set particles.count=5000").code, 0);
  }
};

TEST_F(Score, TheTruthOfOurOwnLogsIsAReference) {
  const Result result = ldm("score o --truth a.truth.csv");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out.rfind("object     kind       frames   detected", 0), 0u) << result.out;
  EXPECT_NE(result.out.find(" dynamic "), std::string::npos);
  EXPECT_NE(result.out.find("in 25 frames\n"), std::string::npos) << result.out;
  EXPECT_EQ(folder_.read("o/score.csv")
                .rfind("id,dynamic,frames,matched,position_error_m,velocity_error_mps,", 0),
            0u);
  // Two sums, and two lines more.
  EXPECT_EQ(lines(folder_.read("o/score.csv")) + 4, lines(result.out));
  EXPECT_NE(result.out.find("moving objects: "), std::string::npos);
  const std::string json = folder_.read("o/score.json");
  EXPECT_NE(json.find("\"frames\": 25,"), std::string::npos) << json;
  EXPECT_NE(json.find("\"frames_not_in_run\": 0,"), std::string::npos);
}

TEST_F(Score, AReferenceOfOneFrameIsEnough) {
  folder_.write("labels.csv", "frame,id,x,y,z,vx,vy,vz,size\n24,car,0,0,0,0,0,0,1\n");
  expect_bad("score o --truth labels.csv", "labels.csv:2: id = car: allowed: an integer");
  folder_.write("labels.csv", "frame,id,x,y,z,vx,vy,vz,size\n24,1,0,0,0,0,0,0,1\n");
  EXPECT_NE(ldm("score o --truth labels.csv").out.find("in 1 frames\n"), std::string::npos);
}

TEST_F(Score, LabelsAreAReferenceToo) {
  ASSERT_EQ(ldm("run ldm a.rawlog -o l --save-labels --set particles.count=5000").code, 0);
  const Result result = ldm("score l --labels l/true_labels");
  EXPECT_EQ(result.code, 0) << result.error;
  EXPECT_EQ(result.out.rfind("moving points: intersection over union ", 0), 0u) << result.out;
  EXPECT_NE(result.out.find(" points in 25 frames, "), std::string::npos);
  EXPECT_NE(folder_.read("l/score.json").find("\"moving_iou\":0."), std::string::npos);
  EXPECT_FALSE(exists("l/score.csv"));
  // The run against itself.
  ASSERT_EQ(ldm("score l --labels l/labels --truth a.truth.csv").code, 0);
  EXPECT_NE(folder_.read("l/score.json").find("\"moving_iou\":1.0"), std::string::npos);
  EXPECT_TRUE(exists("l/score.csv"));
  // A run of the same folder without labels leaves none of the former's.
  ASSERT_EQ(ldm("run empty_map scenario3 --frames 2 -o l").code, 0);
  EXPECT_FALSE(exists("l/labels"));
  EXPECT_FALSE(exists("l/true_labels"));
}

TEST_F(Score, RefusesBadRunsAndTruths) {
  folder_.write("far.csv", "frame,id,x,y,z,vx,vy,vz,size\n25,1,0,0,0,0,0,0,1\n");
  expect_bad("score o --truth far.csv", "no frame of the truth is in the run");
  expect_bad("score o", "no reference: allowed: --truth FILE.csv, --labels FOLDER, or both");
  expect_bad("score o --labels o", "o/labels: no labels");
  expect_bad("score none --truth a.truth.csv", "none/frames.csv: cannot be read");
  expect_bad("score o --truth none.csv", "none.csv: cannot be read");
  expect_bad("score o --truth a.truth.csv --gate -1", "--gate");
  std::string clusters = folder_.read("o/clusters.csv");
  clusters.replace(clusters.find('\n') + 1, 1, "77");
  folder_.write("o/clusters.csv", clusters);
  expect_bad("score o --truth a.truth.csv", "o/clusters.csv:2: frame 77");
  EXPECT_FALSE(exists("o/score.json"));
}

}  // namespace
}  // namespace experiments
