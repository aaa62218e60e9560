#include "datasets/recording/formats/scan_folder_reader.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/given_trajectory.h"
#include "datasets/recording/scans/scan_names.h"
#include "datasets/recording/scans/sensor_mount.h"

namespace datasets {

ScanFolderReader::ScanFolderReader(ScanFolder folder, const RecordingOptions& options)
    : folder_(std::move(folder)),
      T_uav_sensor_(mount_of(options.input.sensor, folder_.T_uav_sensor, folder_.folder.string())),
      poses_of_(options.input.poses_of == PosesOf::kAuto ? folder_.poses_of
                                                         : options.input.poses_of),
      timeline_(folder_.timeline, options.input, options.time_unit) {
  // At rest it is the vehicle that stands at the origin, whatever poses would be.
  if (options.input.poses == PoseSource::kStill) poses_of_ = PosesOf::kVehicle;
  if (poses_of_ == PosesOf::kCamera && !folder_.T_sensor_camera) {
    throw ldm::InvalidInput("input.poses_of = camera: allowed: in a KITTI folder with a calib.txt");
  }
  const auto [file, lines] = timeline_.lines();
  auto scans = scan_of_each_line(folder_.names, lines);
  if (!scans) {
    throw ldm::InvalidInput(file.string() + ": " + std::to_string(lines) + " lines: allowed: " +
                            std::to_string(folder_.names.size()) + ", one for each scan of " +
                            folder_.folder.string() + ": nothing tells which belongs to which");
  }
  folder_.names = std::move(*scans);
}

bool ScanFolderReader::next(Frame& frame) {
  if (static_cast<std::size_t>(next_) == folder_.names.size()) return false;
  frame.index = next_++;
  frame.truth.reset();
  timeline_.advance();
  const std::string& name = folder_.names[static_cast<std::size_t>(frame.index)];
  if (name.empty()) {
    throw BrokenFrame("missing scan", timeline_.place() + ": its scan is missing in " +
                                          folder_.folder.string() +
                                          ": allowed: a scan for each line");
  }
  const std::size_t scan = scans_++;
  const StampedPose stamped = timeline_.read();
  frame.scan.time = stamped.time;
  ldm::Pose pose = stamped.pose;
  if (!folder_.poses.empty()) {
    const auto& known = folder_.poses[scan];
    if (!known) throw BrokenFrame("no pose", timeline_.place() + ": no pose in nuScenes' tables");
    pose = *known;
  }
  set_poses(sensor_or_vehicle(pose), poses_of_, T_uav_sensor_, frame.scan);
  frame.scan.points.clear();
  frame.scan.no_returns.clear();
  folder_.load(folder_.folder / name, frame.scan.points);
  return true;
}

ldm::Pose ScanFolderReader::sensor_or_vehicle(const ldm::Pose& pose) const {
  if (poses_of_ != PosesOf::kCamera) return pose;
  // T_world_camera as seen from the sensor: the world's axes are then the first sensor's as well.
  return composed(composed(*folder_.T_sensor_camera, pose), inverse(*folder_.T_sensor_camera));
}

TimelineFiles timeline_files(const std::filesystem::path& times, const std::filesystem::path& poses,
                             const RecordingOptions& options) {
  TimelineFiles files{options.poses, options.times, {}};
  if (!files.times && std::filesystem::exists(times)) files.times = times;
  if (options.input.poses == PoseSource::kStill) return files;
  if (!files.trajectory && !std::filesystem::exists(poses)) {
    throw ldm::InvalidInput(poses.string() +
                            ": is missing: allowed: a trajectory there, --poses FILE, or --set "
                            "input.poses=still for a sensor at rest");
  }
  files.trajectory = trajectory_in(files.trajectory.value_or(poses));
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
  std::ifstream stream(file, std::ios::binary);
  if (!stream) {
    throw BrokenFrame("unreadable scan",
                      file.string() + ": cannot be read (" + std::strerror(errno) + ")");
  }
  stream.read(content.data(), static_cast<std::streamsize>(size));
  if (static_cast<std::uintmax_t>(stream.gcount()) != size) {
    throw BrokenFrame("broken scan", file.string() + ": cannot be read to its end");
  }
}

}  // namespace datasets
