#include "datasets/recording/recording.h"

#include <algorithm>

#include "datasets/files/text.h"
#include "datasets/rawlog/rawlog.h"
#include "datasets/rawlog/rawlog_sidecars.h"
#include "datasets/recording/filter/scan_filter.h"
#include "datasets/recording/formats/bin_folder_reader.h"
#include "datasets/recording/formats/bin_scans.h"
#include "datasets/recording/formats/kitti_raw_reader.h"
#include "datasets/recording/formats/kitti_reader.h"
#include "datasets/recording/formats/mrpt_log_reader.h"
#include "datasets/recording/formats/pcap/pcap_reader.h"
#include "datasets/recording/formats/pcd_reader.h"
#include "datasets/recording/formats/ros/bag_file.h"
#include "datasets/recording/formats/ros/bag_reader.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/scan_names.h"
#include "ldm/scan_check.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

bool has_scans(const fs::path& folder, std::string_view ending) {
  std::error_code error;
  const fs::directory_iterator entries(folder, error);
  return !error && std::any_of(begin(entries), end(entries), [&](const fs::directory_entry& entry) {
    return is_scan_name(entry.path(), ending);
  });
}

void refuse_bag_options(const RecordingOptions& options) {
  const std::pair<const char*, std::optional<std::string>> given[] = {
      {"--points", options.points},
      {"--poses-topic", options.poses_topic},
      {"--sensor-frame", options.sensor_frame}};
  for (const auto& [option, value] : given) {
    if (value)
      throw ldm::InvalidInput(std::string(option) + " " + *value + ": allowed: with a bag");
  }
}

std::unique_ptr<ScanReader> open_reader(const fs::path& path, RecordingFormat format,
                                        const RecordingOptions& options) {
  if (format == RecordingFormat::kBag) return open_bag_recording(path, options);
  refuse_bag_options(options);
  switch (format) {
    case RecordingFormat::kKitti:
      return open_kitti(path, options);
    case RecordingFormat::kKittiRaw:
      return open_kitti_raw(path, options);
    case RecordingFormat::kBin:
      return open_bin_folder(path, options);
    case RecordingFormat::kPcap:
      return open_pcap(path, options);
    case RecordingFormat::kPcd:
      return open_pcd_folder(path, options);
    default:
      return open_mrpt_log(path, options);
  }
}

}  // namespace

std::optional<RecordingFormat> recognised_format(const fs::path& path) {
  if (fs::is_directory(path)) {
    if (fs::is_directory(path / "velodyne")) return RecordingFormat::kKitti;
    if (is_kitti_raw(path)) return RecordingFormat::kKittiRaw;
    if (has_scans(path, kPcdEnding)) return RecordingFormat::kPcd;
    if (has_scans(path, kBinEnding)) return RecordingFormat::kBin;
  }
  if (is_bag(path)) return RecordingFormat::kBag;
  if (is_pcap(path)) return RecordingFormat::kPcap;
  if (path.extension() != ".rawlog") return {};
  return fs::exists(LogFiles(path).description) ? RecordingFormat::kLdmRawlog
                                                : RecordingFormat::kMrptRawlog;
}

RecordingFormat format_of(const fs::path& path, const RecordingOptions& options) {
  if (!fs::exists(path)) throw ldm::InvalidInput(path.string() + ": cannot be read: no such file");
  if (options.format) return *options.format;
  if (const auto format = recognised_format(path)) return *format;
  throw ldm::InvalidInput(
      path.string() +
      ": no recording: allowed: a KITTI folder with velodyne/ or "
      "velodyne_points/, a folder of *.pcd or *.bin files, a .rawlog file, a bag "
      "(.bag, .mcap, .db3), or packets of a LiDAR (.pcap, .pcapng)");
}

std::unique_ptr<FrameSource> open_recording(const fs::path& path, const RecordingOptions& options) {
  const RecordingFormat format = format_of(path, options);
  if (format == RecordingFormat::kLdmRawlog) {
    auto log = std::make_unique<RawlogReader>(path);
    if (!options.keep_going) return log;
    return std::make_unique<UndamagedFrames>(std::move(log));
  }
  RaysToFind rays = RaysToFind::kAll;
  if (format == RecordingFormat::kBag) rays = RaysToFind::kOfGaps;
  if (format == RecordingFormat::kPcap) rays = RaysToFind::kNone;
  return std::make_unique<ScanFilter>(
      std::make_unique<OrderedFrames>(open_reader(path, format, options), options), options.input,
      rays);
}

bool UndamagedFrames::next(Frame& frame) {
  if (ended_) return false;
  try {
    ended_ = !source_->next(frame);
  } catch (const ldm::InvalidInput&) {
    ended_ = true;
    counts_.frames_skipped["damaged, or behind damage"] =
        source_->size().value_or(read_ + 1) - read_;
  }
  if (!ended_) ++read_;
  return !ended_;
}

OrderedFrames::OrderedFrames(std::unique_ptr<ScanReader> reader, const RecordingOptions& options)
    : reader_(std::move(reader)),
      keep_going_(options.keep_going),
      origin_step_(options.origin_step) {}

bool OrderedFrames::next(Frame& frame) {
  for (;;) {
    bool usable = false;
    try {
      if (!take_one(frame, usable)) return false;
      if (usable) return true;
      ++counts_.frames_skipped["time of the frame before"];
    } catch (const BrokenFrame& broken) {
      if (!keep_going_) throw;
      ++counts_.frames_skipped[broken.reason];
    }
  }
}

/// @return false at the end
/// @param usable false for a repeated frame
bool OrderedFrames::take_one(Frame& frame, bool& usable) {
  if (!reader_->next(frame)) return false;
  const double time = frame.scan.time;
  usable = !last_time_ || time != *last_time_;
  if (last_time_ && time < *last_time_) {
    throw BrokenFrame("time goes backwards", reader_->place() + ": time " + decimal(time) +
                                                 " s: allowed: more than " + decimal(*last_time_) +
                                                 " s, that of the scan before");
  }
  ldm::Scan without_points;  // the filter looks at the points, of which some may be non-finite
  without_points.time = time;
  without_points.T_world_uav = frame.scan.T_world_uav;
  without_points.T_world_sensor = frame.scan.T_world_sensor;
  try {
    ldm::check_scan(without_points, last_time_);
  } catch (const ldm::InvalidInput& error) {
    throw BrokenFrame("bad pose", reader_->place() + ": " + error.what());
  }
  last_time_ = time;
  if (usable) set_origin(frame);
  return true;
}

void OrderedFrames::set_origin(Frame& frame) {
  ldm::Scan& scan = frame.scan;
  if (!origin_) {
    const Eigen::Array3d first = scan.T_world_uav.translation;
    origin_ = (first.abs() < kNear).select(0, (first / origin_step_).round() * origin_step_);
  }
  frame.origin = *origin_;
  scan.T_world_uav.translation -= frame.origin;
  scan.T_world_sensor.translation -= frame.origin;
}

InputCounts OrderedFrames::counts() const {
  InputCounts counts = reader_->counts();
  for (const auto& [reason, count] : counts_.frames_skipped) {
    counts.frames_skipped[reason] += count;
  }
  return counts;
}

}  // namespace datasets
