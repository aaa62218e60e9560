#pragma once
/// How a recording is to be read (no paper section).
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "datasets/recording/scans/input_parameters.h"
#include "datasets/recording/scans/time_unit.h"

namespace datasets {

enum class RecordingFormat { kLdmRawlog, kMrptRawlog, kKitti, kKittiRaw, kBin, kPcd, kBag, kPcap };
inline constexpr std::string_view kRecordingFormatNames[] = {
    "ldm-rawlog", "mrpt-rawlog", "kitti", "kitti-raw", "bin", "pcd", "bag", "pcap"};

struct RecordingOptions {
  std::optional<RecordingFormat> format;       ///< absent: recognised
  std::optional<std::filesystem::path> poses;  ///< as `trajectory_in` takes it
  std::optional<std::filesystem::path> times;  ///< if not FOLDER/times.txt
  std::optional<TimeUnit> time_unit;           ///< of those two files; absent: seconds, checked
  // Of a bag; absent: chosen where there is no choice.
  std::optional<std::string> points;        ///< topic of the scans
  std::optional<std::string> poses_topic;   ///< of TF, odometry or poses
  std::optional<std::string> sensor_frame;  ///< that the scans are in, whatever they say
  bool keep_going = false;                  ///< skip and count broken frames
  double origin_step = 1;                   ///< `Frame::origin` is a multiple of this [m]
  InputParameters input;
};

}  // namespace datasets
