#pragma once
/// A folder that a test fills with scans, poses and times, and what reading it gives.
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "datasets/recording/recording.h"

namespace datasets {

namespace fs = std::filesystem;

/// KITTI's bytes of points with intensity 0.5.
inline std::string kitti_bytes(const std::vector<ldm::Point>& points) {
  std::string bytes;
  for (const ldm::Point& p : points) {
    const float numbers[4] = {p.x(), p.y(), p.z(), 0.5F};
    bytes.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  }
  return bytes;
}

class RecordingFolder : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, const std::string& content) const {
    const fs::path file = folder_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary | std::ios::trunc) << content;
    return file;
  }
  std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  void append(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary | std::ios::app) << content;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Scan k is one point at (10 + k, 1, 2), taken at 0.1 k s from (k, 0, 0) without a turn.
  void write_drive(int frames) const {
    std::string times, poses;
    for (int k = 0; k < frames; ++k) {
      char name[32];
      std::snprintf(name, sizeof name, "velodyne/%06d.bin", k);
      write(name, kitti_bytes({{10.0F + static_cast<float>(k), 1, 2}}));
      times += std::to_string(0.1 * k) + "\n";
      poses += "1 0 0 " + std::to_string(k) + " 0 1 0 0 0 0 1 0\n";
    }
    write("times.txt", times);
    write("poses.txt", poses);
  }

  /// Every frame that the recording gives.
  std::vector<Frame> frames() {
    std::vector<Frame> all;
    const auto source = open_recording(folder_, options_);
    for (Frame frame; source->next(frame);) all.push_back(frame);
    counts_ = source->counts();
    return all;
  }
  /// What opening or reading fails with, on one line; "none" if it does not.
  std::string failure() {
    try {
      frames();
    } catch (const ldm::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "none";
  }
  /// It fails with that line about the file, and with --keep-going counts frames under `reason`
  /// and gives the others.
  void expect_broken(const std::string& file, const std::string& message, std::size_t others,
                     const std::string& reason, std::int64_t count = 1) {
    options_.keep_going = false;
    const std::string text = failure();
    EXPECT_EQ(text.rfind(path(file) + ":", 0), 0u) << text;
    EXPECT_NE(text.find(message), std::string::npos) << text;
    options_.keep_going = true;
    EXPECT_EQ(frames().size(), others);
    EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{reason, count}}));
  }

  fs::path folder_ = fs::temp_directory_path() / ("ldm_recording_test_" + std::to_string(getpid()));
  RecordingOptions options_;
  InputCounts counts_;
};

}  // namespace datasets
