#include "experiments/runs/truth_table.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace experiments {
namespace {

constexpr char kHeader[] = "frame,id,x,y,z,vx,vy,vz,size\n";

class TruthTableTest : public testing::Test {
 protected:
  TruthTable read(const std::string& text) {
    return read_truth_table(folder_.write("truth.csv", text));
  }
  void expect_bad(const std::string& text, const std::string& part) {
    const std::string message = tests::message_of([&] { read(text); });
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }

  tests::TemporaryFolder folder_;
};

TEST_F(TruthTableTest, TakesColumnsInAnyOrderWithOrWithoutUnits) {
  const TruthTable short_names = read(std::string(kHeader) + "3,7,1,2,3,0.5,0,-0.5,0.4\n");
  const TruthTable long_names = read(
      "colour,vx_mps,vy_mps,vz_mps,id,frame,x_m,y_m,z_m,sx_m,sy_m,sz_m\r\n"
      "red,0.5,0,-0.5,7,3,1,2,3,0.4,0.4,0.4\r\n");
  for (const TruthTable& table : {short_names, long_names}) {
    ASSERT_EQ(table.size(), 1u);
    const TruthFrame& frame = table.at(3);
    EXPECT_FALSE(frame.time);
    ASSERT_EQ(frame.objects.size(), 1u);
    EXPECT_EQ(frame.objects[0].id, 7);
    EXPECT_EQ(frame.objects[0].position, Eigen::Vector3d(1, 2, 3));
    EXPECT_EQ(frame.objects[0].velocity, Eigen::Vector3d(0.5, 0, -0.5));
    EXPECT_EQ(frame.objects[0].size, Eigen::Vector3d(0.4, 0.4, 0.4));
  }
}

TEST_F(TruthTableTest, WhatMovesAtSomeTimeIsDynamic) {
  const TruthTable table =
      read(std::string(kHeader) + "0,1,0,0,0,0,0,0,1\n0,2,5,0,0,0,0,0,1\n1,1,0,0,0,0,1,0,1\n");
  EXPECT_TRUE(table.at(0).objects[0].dynamic);
  EXPECT_FALSE(table.at(0).objects[1].dynamic);
  EXPECT_TRUE(table.at(1).objects[0].dynamic);
}

TEST_F(TruthTableTest, ItsOwnColumnSaysWhatIsDynamic) {
  const TruthTable table = read(
      "frame,time_s,id,dynamic,x,y,z,vx,vy,vz,size\n"
      "0,0.5,1,1,0,0,0,0,0,0,1\n");
  EXPECT_TRUE(table.at(0).objects[0].dynamic);
  EXPECT_EQ(table.at(0).time, 0.5);
}

TEST_F(TruthTableTest, TakesTheDialectsOfOtherPrograms) {
  const auto expect_read = [&](const std::string& text) {
    const TruthTable table = read(text);
    ASSERT_EQ(table.size(), 2u) << text;
    const TruthObject& object = table.at(1).objects.at(0);
    EXPECT_EQ(object.id, 7) << text;
    EXPECT_EQ(object.position, Eigen::Vector3d(1.5, -2, 3)) << text;
    EXPECT_TRUE(object.dynamic) << text;
    EXPECT_FALSE(table.at(0).objects.at(0).dynamic) << text;
  };
  const std::string header = "frame,id,x,y,z,vx,vy,vz,size,dynamic\n";
  const std::string first = "0,8,0,0,0,0,0,0,1,0\n";
  expect_read("\xef\xbb\xbf" + header + first + "1,7,1.5,-2,3,0,0,0,1,1\n");
  expect_read(header + first + "\n1,7,1.5,-2,3,0,0,0,1,1\n\r\n\n");
  expect_read(header + first + "1,7,1.5,-2,3,0,0,0,1,1");
  expect_read(header + first + "1.0,7.0,1.5,-2.0,3,0,0,0,1,True\n");
  expect_read(header + first + "1, 7, +1.5, -2 ,+3e0, 0,0,0,1,true\n");
  expect_read("frame;id;x;y;z;vx;vy;vz;size;dynamic\n0;8;0;0;0;0;0;0;1;false\n" +
              std::string("1;7;1.5;-2;3;0;0;0;1;1\n"));
  expect_read(
      "\"frame\",\"id\",\"x\",\"y\",\"z\",\"vx\",\"vy\",\"vz\",\"size\",\"dynamic\",\"what\"\n" +
      std::string("0,8,0,0,0,0,0,0,1,0,\"a, b\"\n\"1\",7,1.5,-2,3,0,0,0,1,\"1\",x\n"));
  expect_bad(header + first + "1.5,7,1.5,-2,3,0,0,0,1,1\n",
             "truth.csv:3: frame = 1.5: allowed: an");
  expect_bad(header + first + "1,7,1.5,-2,3,0,0,0,1,maybe\n", "truth.csv:3: dynamic = maybe");
}

TEST_F(TruthTableTest, RefusesBadTables) {
  expect_bad("", "truth.csv:1: the file is empty");
  expect_bad("frame,id,x,y,z,vy,vz,size\n",
             "truth.csv:1: no column vx: allowed: a column named vx");
  expect_bad("frame,id,x,y,z,vx,vy,vz,sx,sy\n", "no column sz: allowed: a column named sz");
  expect_bad(std::string(kHeader) + "0,1,0,0,0,fast,0,0,1\n",
             "truth.csv:2: vx = fast: allowed: a finite number");
  expect_bad(std::string(kHeader) + "0,1,0,0,0,nan,0,0,1\n", "vx = nan");
  expect_bad(std::string(kHeader) + "-1,1,0,0,0,0,0,0,1\n", "truth.csv:2: frame = -1");
  expect_bad(std::string(kHeader) + "0,1,0,0,0,0,0,0,-1\n", "truth.csv:2: a negative size");
  expect_bad(std::string(kHeader) + "0,1,0,0,0,0,0,0,1\n0,1,0,0,0,0,0,0,1\n",
             "truth.csv:3: object 1 a second time in frame 0");
  expect_bad(std::string(kHeader) + "0,1,0,0,0,0,0,0\n", "truth.csv:2: 8 values, allowed: 9");
  EXPECT_NE(
      tests::message_of([] { read_truth_table("/none.csv"); }).find("/none.csv: cannot be read"),
      std::string::npos);
}

}  // namespace
}  // namespace experiments
