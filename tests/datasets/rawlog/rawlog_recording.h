#pragma once
/// A small recorded log for the tests of its writer and reader, and ways to damage it.
#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "datasets/rawlog/rawlog.h"
#include "datasets/scenario/lidar_caster.h"

namespace datasets {

namespace fs = std::filesystem;

inline LidarModel small_lidar() {
  LidarModel lidar;
  lidar.elevations = {-0.29, -0.1, 0.1, 0.29};
  lidar.azimuths = 64;
  lidar.rate = 12.5;
  return lidar;
}

/// Frames drawn at random, with what a RawlogWriter needs of them.
struct Recording {
  LidarModel lidar = small_lidar();
  ldm::Pose T_uav_sensor = {
      Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix(),
      {0.1, 0, -0.05}};
  std::vector<Frame> frames;
  std::vector<QuaternionPose> poses;
  std::vector<RangeImage> images;
};

class RandomNumbers {
 public:
  double operator()() { return uniform_(generator_); }
  Eigen::Vector3d vector() { return {(*this)(), (*this)(), (*this)()}; }

 private:
  std::mt19937_64 generator_{7};
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

inline ObjectState random_object(std::int32_t id, RandomNumbers& random) {
  ObjectState object;
  object.id = id;
  object.dynamic = id % 2 == 1;
  object.position = 5 * random.vector();
  object.velocity = random.vector();
  object.acceleration = random.vector();
  object.size = random.vector().cwiseAbs();
  for (const auto shape : {Solid::Shape::kBox, Solid::Shape::kCylinder, Solid::Shape::kSphere}) {
    const Eigen::AngleAxisd turn(random(), random.vector().normalized());
    object.solids.push_back({shape,
                             {turn.toRotationMatrix(), object.position + random.vector()},
                             random.vector().cwiseAbs()});
  }
  return object;
}

inline Recording record(std::int64_t frames) {
  Recording recording;
  RandomNumbers random;
  LidarCaster caster(recording.lidar);
  for (std::int64_t k = 0; k < frames; ++k) {
    Frame frame;
    frame.index = k;
    frame.scan.time = static_cast<double>(k) / recording.lidar.rate;
    const Eigen::AngleAxisd turn(random(), random.vector().normalized());
    const QuaternionPose pose = to_quaternion_pose({turn.toRotationMatrix(), random.vector()});
    frame.scan.T_world_uav = to_pose(pose);
    frame.scan.T_world_sensor = composed(frame.scan.T_world_uav, recording.T_uav_sensor);
    frame.truth.emplace();
    // The number of objects changes; frame 2 has none, and so no hits.
    for (std::int32_t id = 0; id < (k == 2 ? 0 : 3 + k % 2); ++id) {
      frame.truth->objects.push_back(random_object(10 * id + 1, random));
    }
    RangeImage image;
    caster.cast(frame.scan.T_world_sensor, frame.truth->objects, static_cast<std::uint64_t>(k),
                image, frame.truth->noise_free_hits);
    project(recording.lidar, image, frame.scan);
    recording.frames.push_back(frame);
    recording.poses.push_back(pose);
    recording.images.push_back(image);
  }
  return recording;
}

/// Writes the recording as flight.rawlog in a folder of its own.
class Rawlog : public testing::Test {
 protected:
  static constexpr std::int64_t kFrames = 5;

  void SetUp() override {
    fs::create_directories(folder_);
    write();
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write() {
    RawlogWriter writer(rawlog(), recording_.lidar, recording_.T_uav_sensor);
    for (std::size_t k = 0; k < recording_.frames.size(); ++k) {
      const Frame& frame = recording_.frames[k];
      writer.write(frame.scan.time, recording_.poses[k], recording_.images[k], *frame.truth);
    }
    writer.close();
  }

  fs::path file(const std::string& name) const { return folder_ / name; }
  fs::path rawlog() const { return file("flight.rawlog"); }

  std::string content(const std::string& name) const {
    std::ifstream stream(file(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void replace(const std::string& name, const std::string& text) const {
    std::ofstream(file(name), std::ios::binary | std::ios::trunc) << text;
  }
  void replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = content(name);
    ASSERT_NE(text.find(from), std::string::npos) << from;
    replace(name, text.replace(text.find(from), from.size(), to));
  }
  void remove_last_line(const std::string& name) const {
    const std::string text = content(name);
    replace(name, text.substr(0, text.rfind('\n', text.size() - 2) + 1));
  }

  /// What reading the whole log fails with, or "none".
  std::string failure() const {
    try {
      RawlogReader reader(rawlog());
      Frame frame;
      while (reader.next(frame)) {
      }
    } catch (const ldm::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "none";
  }
  void expect_failure(const std::string& name, const std::string& reason) const {
    const std::string text = failure();
    EXPECT_NE(text.find(file(name).string() + ":"), std::string::npos) << text;
    EXPECT_NE(text.find(reason), std::string::npos) << text;
  }

  fs::path folder_ = fs::temp_directory_path() / ("ldm_rawlog_test_" + std::to_string(getpid()));
  Recording recording_ = record(kFrames);
};

}  // namespace datasets
