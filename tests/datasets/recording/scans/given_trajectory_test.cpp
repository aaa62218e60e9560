/// Trajectories of other programs as they leave them: KISS-ICP's results, stamps that count scans.
#include "datasets/recording/scans/given_trajectory.h"

#include <gtest/gtest.h>

#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

class GivenTrajectory : public RecordingFolder {
 protected:
  /// Files as a run of KISS-ICP leaves them, with `poses` poses, 2 m from one to the next.
  void write_results(const std::string& run, int poses) const {
    std::string kitti, tum;
    for (int k = 0; k < poses; ++k) {
      const std::string x = std::to_string(2 * k);
      kitti += "1.0e+00 0.0e+00 0.0e+00 " + x +
               ".0e+00 0.0e+00 1.0e+00 0.0e+00 0.0e+00 0.0e+00 "
               "0.0e+00 1.0e+00 0.0e+00\n";
      tum += std::to_string(k) + ".0000 " + x + ".0000 0.0000 0.0000 0.0000 0.0000 0.0000 1.0000\n";
    }
    write(run + "/drive_poses_kitti.txt", kitti);
    write(run + "/drive_poses_tum.txt", tum);
    write(run + "/drive_poses.npy", "");
    write(run + "/config.yml", "out_dir: results\n");
  }
  void expect_poses() {
    const std::vector<Frame> all = frames();
    ASSERT_EQ(all.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(all[k].scan.T_world_sensor.translation.x(), 2 * static_cast<double>(k));
      EXPECT_DOUBLE_EQ(all[k].scan.time, 0.1 * static_cast<double>(k));
    }
  }
};

TEST_F(GivenTrajectory, TheFolderOfKissIcpsResults) {
  write_drive(3);
  fs::remove(folder_ / "poses.txt");
  write_results("results/2026-01-01_12-00-00", 3);
  options_.poses = folder_ / "results/2026-01-01_12-00-00";
  expect_poses();
  fs::create_directory_symlink(folder_ / "results/2026-01-01_12-00-00", folder_ / "results/latest");
  options_.poses = folder_ / "results";
  expect_poses();
  fs::remove(folder_ / "results/latest/drive_poses_kitti.txt");  // TUM's counts the scans
  expect_poses();
  fs::remove(folder_ / "times.txt");
  EXPECT_NE(failure().find("_poses_tum.txt: has no times of the scans: allowed: with times.txt"),
            std::string::npos)
      << failure();
}

TEST_F(GivenTrajectory, AsManyCountingStampsAsScans) {
  write_drive(3);
  options_.poses = write("slam.tum", "0 0 0 0 0 0 0 1\n1 2 0 0 0 0 0 1\n2 4 0 0 0 0 0 1\n");
  expect_poses();
  append("slam.tum", "3 6 0 0 0 0 0 1\n");  // then they are times, in seconds
  EXPECT_DOUBLE_EQ(frames().at(1).scan.T_world_sensor.translation.x(), 0.2);
}

TEST_F(GivenTrajectory, TooFewPosesAreRefused) {
  write_drive(3);
  write_results("results", 2);
  options_.poses = folder_ / "results";
  EXPECT_EQ(failure(), path("results/drive_poses_kitti.txt") +
                           ": 2 lines: allowed: 3, as many as " + path("times.txt") + " has");
  fs::remove(folder_ / "results/drive_poses_kitti.txt");
  EXPECT_EQ(failure(), path("results/drive_poses_tum.txt") + ": 2 lines: allowed: 3, as many as " +
                           path("times.txt") + " has");
}

TEST_F(GivenTrajectory, FoldersThatLeaveAChoiceOrNone) {
  write_drive(3);
  options_.poses = folder_ / "results";
  fs::create_directory(*options_.poses);
  EXPECT_EQ(failure(), path("results") +
                           ": has no trajectory: allowed: a file, KISS-ICP's results with a "
                           "*_poses_kitti.txt, or oxts/ of KITTI's raw data");
  write_results("results", 3);
  write("results/other_poses_kitti.txt", "");
  EXPECT_EQ(failure(), path("results") + ": several trajectories: allowed: --poses with one of " +
                           path("results/drive_poses_kitti.txt") + ", " +
                           path("results/other_poses_kitti.txt"));
}

}  // namespace
}  // namespace datasets
