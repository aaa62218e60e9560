#pragma once
/// How a recording is to be read (no paper section).
#include <filesystem>
#include <optional>
#include <string_view>

#include "datasets/recording/scans/input_parameters.h"

namespace datasets {

enum class RecordingFormat { kLdmRawlog, kMrptRawlog, kKitti, kPcd };
inline constexpr std::string_view kRecordingFormatNames[] = {"ldm-rawlog", "mrpt-rawlog", "kitti",
                                                             "pcd"};

struct RecordingOptions {
  std::optional<RecordingFormat> format;       ///< absent: recognised
  std::optional<std::filesystem::path> poses;  ///< trajectory, if not FOLDER/poses.txt
  std::optional<std::filesystem::path> times;  ///< if not FOLDER/times.txt
  bool keep_going = false;                     ///< skip and count broken frames
  InputParameters input;
};

}  // namespace datasets
