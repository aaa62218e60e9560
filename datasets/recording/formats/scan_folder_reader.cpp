#include "datasets/recording/formats/scan_folder_reader.h"

#include <algorithm>

#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/sensor_mount.h"

namespace datasets {

ScanFolderReader::ScanFolderReader(ScanFolder folder, const InputParameters& parameters,
                                   bool complete)
    : folder_(std::move(folder)),
      T_uav_sensor_(mount_of(parameters.sensor)),
      timeline_(folder_.timeline, parameters),
      frames_(folder_.scans) {
  if (complete) {
    timeline_.check_length(frames_);
  } else {
    frames_ = std::max(frames_, timeline_.longest());
  }
}

bool ScanFolderReader::next(Frame& frame) {
  if (next_ == frames_) return false;
  frame.index = next_++;
  frame.truth.reset();
  timeline_.advance();
  if (frame.index >= folder_.scans) {
    throw BrokenFrame("missing scan", timeline_.place() + ": there is no scan number " +
                                          std::to_string(frame.index) +
                                          ": allowed: " + std::to_string(folder_.scans) + " lines");
  }
  const StampedPose stamped = timeline_.read();
  frame.scan.time = stamped.time;
  // T_world_camera as seen from the sensor: the world's axes are then the first sensor's as well.
  const ldm::Pose pose =
      composed(composed(folder_.T_sensor_camera, stamped.pose), inverse(folder_.T_sensor_camera));
  set_poses(pose, folder_.poses_of, T_uav_sensor_, frame.scan);
  frame.scan.points.clear();
  frame.scan.no_returns.clear();
  folder_.load(folder_.file_of(frame.index), frame.scan.points);
  return true;
}

TimelineFiles timeline_files(const std::filesystem::path& folder, const RecordingOptions& options) {
  TimelineFiles files{options.poses, options.times};
  const std::filesystem::path times = folder / "times.txt", poses = folder / "poses.txt";
  if (!files.times && std::filesystem::exists(times)) files.times = times;
  if (files.trajectory || options.input.poses == PoseSource::kStill) return files;
  if (!std::filesystem::exists(poses)) {
    throw ldm::InvalidInput(poses.string() +
                            ": is missing: allowed: a trajectory there, --poses FILE, or --set "
                            "input.poses=still for a sensor at rest");
  }
  files.trajectory = poses;
  return files;
}

void read_scan_file(const std::filesystem::path& file, std::string& content) {
  constexpr std::uintmax_t kLargest = std::uintmax_t{2} << 30;
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (error) {
    throw BrokenFrame("missing scan", file.string() + ": cannot be read (" + error.message() + ")");
  }
  if (size > kLargest) {
    throw BrokenFrame("broken scan", file.string() + ": " + std::to_string(size) +
                                         " bytes: allowed: at most 2 GB");
  }
  content.resize(size);
  const std::unique_ptr<std::istream> stream = open_file(file);
  stream->read(content.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream->gcount()) != size) {
    throw BrokenFrame("broken scan", file.string() + ": cannot be read to its end");
  }
}

}  // namespace datasets
