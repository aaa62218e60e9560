/// MRPT's rawlogs: scans from real sensors as packaged by Debian, and logs written by hand.
#include "datasets/recording/formats/mrpt_log_reader.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/io/CFileOutputStream.h>
#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>
#include <mrpt/obs/CSensoryFrame.h>
#include <mrpt/serialization/CArchive.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

namespace obs = mrpt::obs;

const fs::path kPackaged = "/usr/share/mrpt/datasets";

/// The first frame of a recording whose sensor stands still.
Frame first_frame(const fs::path& log, RecordingOptions options = {}) {
  options.input.poses = PoseSource::kStill;
  options.input.min_range = 0;
  Frame frame;
  EXPECT_TRUE(open_recording(log, options)->next(frame));
  return frame;
}

TEST(PackagedLog, AVelodyneScan) {
  const Frame frame = first_frame(kPackaged / "test_velodyne_VLP16.rawlog");
  EXPECT_EQ(frame.scan.points.size(), 22591u);  // all that its packets hold
  EXPECT_NEAR(frame.scan.time, 1519637061.085268, 1e-5);
  EXPECT_NEAR(frame.scan.T_world_sensor.translation.z(), 0.09, 1e-6);
  EXPECT_EQ(frame.scan.T_world_uav.translation, Eigen::Vector3d::Zero());
  for (const ldm::Point& p : frame.scan.points) {  // a VLP-16: odd elevations up to 15 degrees
    const double elevation = std::atan2(p.z(), std::hypot(p.x(), p.y())) * 180 / std::numbers::pi;
    EXPECT_NEAR(std::remainder(elevation - 1, 2), 0, 0.01);
    EXPECT_LT(std::abs(elevation), 15.01);
  }
}

/// The same sweep is packaged as packets and, without its elevations, with its azimuths smoothed
/// and of every other firing only, as MRPT converts it, as a range image.
TEST(PackagedLog, ARotatingScanIsTheVelodynesToCentimetres) {
  const Frame packets = first_frame(kPackaged / "test_velodyne_VLP16.rawlog");
  const Frame image = first_frame(kPackaged / "rot_scan_velodyne.rawlog");
  EXPECT_EQ(image.scan.time, packets.scan.time);
  ASSERT_EQ(image.scan.points.size(), 11305u);
  std::vector<float> distances;
  for (std::size_t i = 0; i < image.scan.points.size(); i += 20) {
    float nearest = 1e9F;
    for (const ldm::Point& p : packets.scan.points) {
      nearest = std::min(nearest, (p - image.scan.points[i]).norm());
    }
    distances.push_back(nearest);
  }
  std::sort(distances.begin(), distances.end());
  EXPECT_LT(distances[distances.size() / 2], 0.02F);
  EXPECT_LT(distances[distances.size() * 9 / 10], 0.06F);
}

TEST(PackagedLog, WithoutAPoseItNeedsTheUsersWord) {
  const fs::path log = kPackaged / "test_velodyne_VLP16.rawlog";
  const auto source = open_recording(log, {});
  Frame frame;
  try {
    source->next(frame);
    FAIL() << "no exception";
  } catch (const ldm::InvalidInput& error) {
    EXPECT_EQ(std::string(error.what()),
              log.string() +
                  ": object 0: no pose at 1519637061.085268 s: the log has no "
                  "CObservationRobotPose: allowed: --set input.poses=still for a sensor "
                  "at rest, or odometry");
  }
}

/// Writes logs by hand.
class MrptLog : public RecordingFolder {
 protected:
  template <class Observation>
  static Observation stamped(double time, const std::string& label) {
    Observation observation;
    observation.timestamp = mrpt::Clock::fromDouble(time);
    observation.sensorLabel = label;
    return observation;
  }
  static obs::CObservationPointCloud cloud(double time, float x, const std::string& label = "top") {
    auto observation = stamped<obs::CObservationPointCloud>(time, label);
    auto map = mrpt::maps::CSimplePointsMap::Create();
    map->insertPointFast(x, 0, 0);
    observation.pointcloud = map;
    observation.sensorPose = mrpt::poses::CPose3D(0, 0, 1.5, 0, 0, 0);
    return observation;
  }
  static obs::CObservationRobotPose pose(double time, double x, const std::string& label = "car") {
    auto observation = stamped<obs::CObservationRobotPose>(time, label);
    observation.pose.mean = mrpt::poses::CPose3D(x, 0, 0, 0, 0, 0);
    return observation;
  }
  template <class... Objects>
  void write_log(const Objects&... objects) {
    mrpt::io::CFileGZOutputStream file((folder_ / "a.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(file);
    (archive << ... << objects);
  }
  std::vector<Frame> frames_of_log() {
    std::vector<Frame> all;
    const auto source = open_recording(folder_ / "a.rawlog", options_);
    for (Frame frame; source->next(frame);) all.push_back(frame);
    counts_ = source->counts();
    return all;
  }
  std::string log_failure() {
    try {
      frames_of_log();
    } catch (const ldm::InvalidInput& error) {
      return error.what();
    }
    return "none";
  }
};

TEST_F(MrptLog, ScansGetThePoseBetweenThoseAround) {
  write_log(pose(1, 0), cloud(1.25, 7), cloud(1.5, 8), pose(2, 4), pose(3, 5), cloud(3, 9));
  const std::vector<Frame> all = frames_of_log();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_DOUBLE_EQ(all[0].scan.time, 1.25);
  EXPECT_NEAR(all[0].scan.T_world_uav.translation.x(), 1, 1e-6);
  EXPECT_NEAR(all[1].scan.T_world_uav.translation.x(), 2, 1e-6);
  EXPECT_NEAR(all[2].scan.T_world_uav.translation.x(), 5, 1e-6);
  EXPECT_TRUE(all[2].scan.T_world_sensor.translation.isApprox(Eigen::Vector3d(5, 0, 1.5), 1e-6));
  EXPECT_EQ(all[2].scan.points.at(0), ldm::Point(9, 0, 0));
}

TEST_F(MrptLog, ScansInSensoryFramesAndOtherObservations) {
  obs::CSensoryFrame frame;
  frame.insert(std::make_shared<obs::CObservationPointCloud>(cloud(1, 7)));
  frame.insert(std::make_shared<obs::CObservationPointCloud>(cloud(1, 8, "rear")));
  write_log(obs::CActionCollection(), frame, pose(1, 3), pose(1, 99, "other car"));
  const std::vector<Frame> all = frames_of_log();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].scan.points.at(0), ldm::Point(7, 0, 0));
  EXPECT_NEAR(all[0].scan.T_world_uav.translation.x(), 3, 1e-9);
  EXPECT_EQ(counts_.other,
            (InputCounts::ByReason{{"other observations in the log", 3},
                                   {"scans whose pattern of rays is not certain", 1}}));
  EXPECT_EQ(counts_.other_sensors,
            (InputCounts::ByReason{{"mrpt::obs::CObservationPointCloud `rear`", 1}}));
}

TEST_F(MrptLog, OdometryIfAskedFor) {
  auto odometry = stamped<obs::CObservationOdometry>(1, "wheels");
  odometry.odometry = mrpt::poses::CPose2D(2, 3, std::numbers::pi / 2);
  write_log(odometry, cloud(1, 7));
  EXPECT_NE(log_failure().find("object 1: no pose at 1 s: the log has no CObservationRobotPose"),
            std::string::npos)
      << log_failure();
  options_.input.poses = PoseSource::kOdometry;
  const ldm::Scan scan = frames_of_log().at(0).scan;
  EXPECT_TRUE(scan.T_world_uav.translation.isApprox(Eigen::Vector3d(2, 3, 0)));
  EXPECT_TRUE(
      (scan.T_world_sensor * Eigen::Vector3d(1, 0, 0)).isApprox(Eigen::Vector3d(2, 4, 1.5)));
}

TEST_F(MrptLog, TheMountOfTheLogOrOfTheParameters) {
  write_log(cloud(1, 7), pose(1, 0));
  options_.input.sensor.z = 2;
  EXPECT_NE(log_failure().find("object 0: the log says where its sensor sits"), std::string::npos);
  options_.input.sensor.from_log = false;
  EXPECT_EQ(frames_of_log().at(0).scan.T_world_sensor.translation.z(), 2);
}

TEST_F(MrptLog, RotatingScansOfUnknownModels) {
  auto scan = stamped<obs::CObservationRotatingScan>(1, "top");
  scan.rowCount = 3;
  scan.columnCount = 4;
  scan.rangeResolution = 0.01;
  scan.startAzimuth = 0;
  scan.azimuthSpan = 1.5 * std::numbers::pi;
  scan.rangeImage.setZero(3, 4);
  scan.rangeImage(0, 0) = 100;  // -10 degrees
  scan.rangeImage(1, 3) = 200;  // level, three quarters round
  write_log(scan, pose(1, 0));
  EXPECT_NE(log_failure().find("its elevations are unknown (model UNKNOWN_SCANNER): allowed: "
                               "input.rotating.elevation_first_deg"),
            std::string::npos)
      << log_failure();
  options_.input.rotating = {-10, 10, ZeroRanges::kNothing};
  const ldm::Scan plain = frames_of_log().at(0).scan;
  ASSERT_EQ(plain.points.size(), 2u);
  const double angle = std::numbers::pi / 18;
  EXPECT_TRUE(plain.points[0].isApprox(
      Eigen::Vector3d(std::cos(angle), 0, -std::sin(angle)).cast<float>(), 1e-5F));
  EXPECT_TRUE(plain.points[1].isApprox(ldm::Point(0, -2, 0), 1e-5F));
  EXPECT_TRUE(plain.no_returns.empty());
  options_.input.rotating.zeros = ZeroRanges::kNoReturn;
  const ldm::Scan rays = frames_of_log().at(0).scan;
  EXPECT_EQ(rays.no_returns.size(), 10u);
  EXPECT_NEAR(rays.no_returns.at(0).norm(), 1, 1e-6);
}

TEST_F(MrptLog, ScansWithoutPointsNameTheirObject) {
  const auto expect = [&](const auto& scan, const std::string& why) {
    options_ = {};
    write_log(pose(1, 0), scan);
    EXPECT_NE(log_failure().find("a.rawlog: object 1: " + why), std::string::npos) << log_failure();
    options_.keep_going = true;
    EXPECT_TRUE(frames_of_log().empty());
    EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"broken scan", 1}}));
  };
  expect(stamped<obs::CObservationPointCloud>(1, "top"), "it has no points");
  auto elsewhere = stamped<obs::CObservationPointCloud>(1, "top");
  elsewhere.setAsExternalStorage(path("none.bin"),
                                 obs::CObservationPointCloud::ExternalStorageFormat::KittiBinFile);
  expect(elsewhere, "its points in " + path("none.bin") + " cannot be read");
  auto image = stamped<obs::CObservationRotatingScan>(1, "top");
  image.rowCount = 3;
  image.columnCount = 4;
  expect(image, "its range image is not as large as it says");
  auto packets = stamped<obs::CObservationVelodyneScan>(1, "top");
  packets.calibration = mrpt::obs::VelodyneCalibration::LoadDefaultCalibration("VLP16");
  packets.scan_packets.resize(1);
  expect(packets, "its packets are none of a sensor that is known");
  for (auto& block : packets.scan_packets[0].blocks) {
    std::memset(static_cast<void*>(&block), 0, sizeof block);
    std::memcpy(static_cast<void*>(&block), "\xff\xee", 2);  // as a valid block begins
  }
  expect(packets, "its packets hold no points");
  for (auto& block : packets.scan_packets[0].blocks) {
    std::memset(static_cast<void*>(&block), 0x11, sizeof block);
    std::memcpy(static_cast<void*>(&block), "\xff\xee", 2);  // as a valid block begins
  }
  packets.calibration = {};
  expect(packets, "its packets are none of a sensor that is known");
}

TEST_F(MrptLog, LogsWithoutScansAndOptionsOfFolders) {
  write_log(pose(1, 0));
  EXPECT_NE(log_failure().find("a.rawlog: has no scan: allowed: "), std::string::npos);
  options_.format = RecordingFormat::kMrptRawlog;
  EXPECT_EQ(failure(), folder_.string() + ": cannot be read");  // a folder
  options_.times = folder_ / "times.txt";
  EXPECT_NE(log_failure().find("--times " + path("times.txt") + ": allowed: with a folder"),
            std::string::npos);
}

TEST_F(MrptLog, DamageIsNamedWithTheObjectAndEndsTheLog) {
  write_log(pose(1, 0), cloud(1, 7), pose(2, 0), cloud(2, 8));
  const auto size = fs::file_size(folder_ / "a.rawlog");
  for (const std::uintmax_t shorter : {size - 1, size - 20, size / 2}) {
    fs::resize_file(folder_ / "a.rawlog", shorter);
    options_.keep_going = false;
    EXPECT_NE(log_failure().find("the log is cut short or damaged"), std::string::npos) << shorter;
    options_.keep_going = true;
    if (shorter > size / 2) {
      EXPECT_GE(frames_of_log().size(), 1u);
      EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"broken log", 1}}));
    }
  }
  write("a.rawlog", "not a log at all");
  options_.keep_going = false;
  EXPECT_NE(log_failure().find("a.rawlog: object 0: the log is cut short or damaged"),
            std::string::npos);
}

TEST_F(MrptLog, AClassOfANewerMrptIsNamed) {
  {
    mrpt::io::CFileOutputStream file((folder_ / "a.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(file);
    archive << pose(1, 0) << cloud(1, 7);
  }
  std::string bytes = read("a.rawlog");
  const std::string known = "CSimplePointsMap", newer = "CPointsMapXYZIRT";
  bytes.replace(bytes.find(known), known.size(), newer);
  write("a.rawlog", bytes);
  EXPECT_NE(log_failure().find("a.rawlog: object 1: the class mrpt::maps::CPointsMapXYZIRT of an "
                               "object is unknown to MRPT 2."),
            std::string::npos)
      << log_failure();
}

/// Scans do not pile up until a pose comes at last.
TEST_F(MrptLog, NoMoreThan64ScansWaitForAPose) {
  {
    mrpt::io::CFileGZOutputStream file((folder_ / "a.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(file);
    for (int k = 0; k < 70; ++k) archive << cloud(0.1 * k, 7);
    archive << pose(6.5, 0) << pose(7, 0);
  }
  EXPECT_NE(log_failure().find("object 0: no pose at 0 s: the log has no CObservationRobotPose up "
                               "to object 64: allowed: "),
            std::string::npos)
      << log_failure();
  options_.keep_going = true;
  EXPECT_EQ(frames_of_log().size(), 6u);  // from 6.4 s on, a little before the first pose
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"no pose", 64}}));
}

TEST_F(MrptLog, MemoryDoesNotGrowWithTheLog) {
  {
    mrpt::io::CFileGZOutputStream file((folder_ / "a.rawlog").string());
    auto archive = mrpt::serialization::archiveFrom(file);
    for (int k = 0; k < 300; ++k) archive << pose(0.1 * k, k) << cloud(0.1 * k, 7);
  }
  const auto source = open_recording(folder_ / "a.rawlog", options_);
  std::vector<std::size_t> heap;
  heap.reserve(300);
  for (Frame frame; source->next(frame);) heap.push_back(mallinfo2().uordblks);
  ASSERT_EQ(heap.size(), 300u);
  EXPECT_LE(heap[298], heap[20] + 4096);
}

}  // namespace
}  // namespace datasets
