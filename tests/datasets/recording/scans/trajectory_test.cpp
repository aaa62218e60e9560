/// Trajectories: both formats, poses between poses, and their ends.
#include "datasets/recording/scans/trajectory.h"

#include <gtest/gtest.h>

#include <numbers>

#include "datasets/recording/scans/broken_frame.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

ldm::Pose turned(double yaw, const Eigen::Vector3d& at = Eigen::Vector3d::Zero()) {
  return {Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()).toRotationMatrix(), at};
}

TEST(Trajectory, ReadsTum) {
  const tests::TextFile file(
      "a.tum", "# a comment\n\n12.5 1 2 3 0 0 0.70710678 0.70710678\r\n13 4 5 6 0 0 0 +1");
  TrajectoryFile trajectory(file.path());
  EXPECT_TRUE(trajectory.has_times());
  ASSERT_TRUE(trajectory.advance());
  const StampedPose first = trajectory.pose();
  EXPECT_EQ(first.time, 12.5);
  EXPECT_EQ(first.pose.translation, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(first.pose.rotation.isApprox(turned(std::numbers::pi / 2).rotation, 1e-7));
  ASSERT_TRUE(trajectory.advance());
  EXPECT_EQ(trajectory.pose().pose.translation, Eigen::Vector3d(4, 5, 6));
  EXPECT_FALSE(trajectory.advance());
  EXPECT_FALSE(trajectory.advance());
}

TEST(Trajectory, ReadsKitti) {
  const tests::TextFile file("a.txt", "0 -1 0 7 1 0 0 8 0 0 1 9\n");
  TrajectoryFile trajectory(file.path());
  EXPECT_FALSE(trajectory.has_times());
  ASSERT_TRUE(trajectory.advance());
  const ldm::Pose pose = trajectory.pose().pose;
  EXPECT_EQ(pose.translation, Eigen::Vector3d(7, 8, 9));
  EXPECT_TRUE(pose.rotation.isApprox(turned(std::numbers::pi / 2).rotation));
}

TEST(Trajectory, ARoundedRotationIsMadeOne) {
  Eigen::Matrix3d rounded = turned(0.5).rotation;
  rounded(0, 0) += 0.004;
  const auto rotation = nearest_rotation(rounded);
  ASSERT_TRUE(rotation);
  EXPECT_TRUE((*rotation * rotation->transpose()).isIdentity(1e-12));
  EXPECT_LT((*rotation - rounded).cwiseAbs().maxCoeff(), 0.005);
  EXPECT_FALSE(nearest_rotation(Eigen::Matrix3d::Zero()));
  EXPECT_FALSE(nearest_rotation(2 * Eigen::Matrix3d::Identity()));
  EXPECT_FALSE(nearest_rotation(Eigen::Vector3d(1, 1, -1).asDiagonal()));
}

TEST(Trajectory, ErrorsNameTheLine) {
  const auto error = [](const std::string& text) {
    const tests::TextFile file("bad.tum", text);
    return tests::message_of<ldm::InvalidInput>([&] {
             TrajectoryFile trajectory(file.path());
             while (trajectory.advance()) trajectory.pose();
             trajectory.pose();
           })
        .substr(file.name().size());
  };
  EXPECT_EQ(
      error(""),
      ":1: 0 numbers: allowed: 8 (TUM: time x y z qx qy qz qw) or 12 (KITTI), between blanks");
  EXPECT_EQ(error("1 2 3\n").substr(0, 13), ":1: 3 numbers");
  EXPECT_EQ(error("1 0 0 0 0 0 0 1\n2 0 0 0 0 0 0 1.2\n"),
            ":2: quaternion of norm 1.2: allowed: 1");
  EXPECT_EQ(error("1 0 0 0 0 0 0 1\n2 0 0 0 nan 0 0 1\n"), ":2: nan: allowed: a finite number");
  EXPECT_EQ(error("1 0 0 0 0 0 0 1\n\n2 0 0 0 0 0 1\n"), ":3: 7 numbers: allowed: 8");
  EXPECT_EQ(error("1 0 0 0 0 0 0 1e999\n"), ":1: 1e999: allowed: a finite number");
  EXPECT_EQ(error("1 0 0 0 0 0 0 1\n"), ":2: the file ends: allowed: a pose for each scan");
  EXPECT_NE(tests::message_of<ldm::InvalidInput>([] {
              TrajectoryFile("/no/such.tum");
            }).find("/no/such.tum: cannot be read"),
            std::string::npos);
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([] { TrajectoryFile("/tmp"); }),
            "/tmp: is a folder: allowed: a file");
}

TEST(PoseTrack, BetweenTwoPosesPositionAndTurnAreShared) {
  PoseTrack track;
  track.add({10, turned(0.2, {0, 0, 0})});
  track.add({11, turned(0.6, {4, 0, 8})});
  EXPECT_TRUE(track.covers(11));
  EXPECT_FALSE(track.covers(11.1));
  const auto pose = track.at(10.25, 1);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->translation.isApprox(Eigen::Vector3d(1, 0, 2)));
  EXPECT_TRUE(pose->rotation.isApprox(turned(0.3).rotation));
  EXPECT_FALSE(track.at(10.5, 0.9));  // the gap
  EXPECT_TRUE(track.at(11, 0.9));     // but not at its ends
}

TEST(PoseTrack, GoesOnForAWhileBeyondItsEnds) {
  PoseTrack track;
  EXPECT_FALSE(track.at(0, 1));
  track.add({10, turned(0, {0, 0, 0})});
  EXPECT_TRUE(track.at(10.1, 1)->translation.isZero());
  track.add({10.1, turned(0, {1, 0, 0})});
  EXPECT_NEAR(track.at(9.9, 1)->translation.x(), -1, 1e-9);
  EXPECT_NEAR(track.at(10.2, 1)->translation.x(), 2, 1e-9);
  EXPECT_FALSE(track.at(10.26, 1));
}

TEST(PoseTrack, KeepsOrder) {
  PoseTrack track;
  EXPECT_TRUE(track.add({1, turned(0, {1, 0, 0})}));
  EXPECT_TRUE(track.add({2, turned(0, {2, 0, 0})}));
  EXPECT_TRUE(track.add({2, turned(0, {9, 0, 0})}));  // in place of the one before
  EXPECT_FALSE(track.add({1.5, turned(0, {0, 0, 0})}));
  EXPECT_NEAR(track.at(1.5, 2)->translation.x(), 5, 1e-9);
  EXPECT_EQ(track.around(1.5), "poses at 1 and 2 s");
}

}  // namespace
}  // namespace datasets
