#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>

#include <cmath>
#include <string>

#include "datasets/files/gz_archive.h"
#include "datasets/rawlog/rawlog.h"
#include "datasets/rawlog/rawlog_labels.h"
#include "datasets/rawlog/rawlog_sidecars.h"

namespace datasets {

namespace fs = std::filesystem;

class RawlogReader::Log {
 public:
  explicit Log(const fs::path& rawlog)
      : files_(rawlog),
        archive_(files_.rawlog),
        description_(read_description(files_.description)),
        beams_(description_.lidar),
        sidecars_(files_, description_.frames) {
    image_.channels = static_cast<std::int32_t>(description_.lidar.elevations.size());
    image_.azimuths = description_.lidar.azimuths;
  }

  const LogDescription& description() const { return description_; }

  bool next(Frame& frame) {
    if (next_ == description_.frames) return false;
    if (!frame.truth) frame.truth.emplace();
    const FrameRow row = sidecars_.read(frame.truth->objects);
    frame.index = next_;
    frame.scan.time = row.time;
    frame.scan.T_world_uav = to_pose(row.T_world_uav);
    frame.scan.T_world_sensor = composed(frame.scan.T_world_uav, description_.T_uav_sensor);
    read_observations(row, *frame.truth);
    beams_.project(image_, frame.scan);
    if (next_ + 1 == description_.frames) check_end();
    ++next_;
    return true;
  }

 private:
  void read_observations(const FrameRow& row, Truth& truth) {
    const auto scan = read<mrpt::obs::CObservationRotatingScan>(kLidarLabel);
    take_scan(row, *scan);
    read<mrpt::obs::CObservationRobotPose>(kUavLabel);
    const auto cloud = read<mrpt::obs::CObservationPointCloud>(kHitsLabel);
    if (!cloud->pointcloud) reject("no points in the observation `noise_free_hits`");
    take_hits(*cloud->pointcloud, truth.noise_free_hits);
    for (const ObjectState& object : truth.objects) {
      read<mrpt::obs::CObservationRobotPose>(object_label(object.id));
    }
  }

  /// The next observation, which must be of that class and label.
  template <class Observation>
  std::shared_ptr<Observation> read(const std::string& label) {
    const auto object = archive_.read_object();
    if (!object) reject("the log is cut short or damaged");
    auto observation = std::dynamic_pointer_cast<Observation>(object);
    if (!observation || observation->sensorLabel != label) {
      reject("another observation than the expected one of `" + label + "`");
    }
    return observation;
  }

  void take_scan(const FrameRow& row, const mrpt::obs::CObservationRotatingScan& scan) {
    constexpr double kClockTick = 1e-6;  // MRPT's clock counts 100 ns
    if (std::abs(mrpt::Clock::toDouble(scan.timestamp) - row.time) > kClockTick) {
      reject("its time is not that of " + files_.frames.string());
    }
    if (scan.rangeImage.rows() != image_.channels || scan.rangeImage.cols() != image_.azimuths) {
      reject("its image is not as large as " + files_.description.string() + " says");
    }
    const std::uint16_t* ranges = &scan.rangeImage(0, 0);
    image_.ranges.assign(ranges, ranges + scan.rangeImage.size());
  }

  static void take_hits(const mrpt::maps::CPointsMap& map, std::vector<ldm::Point>& hits) {
    hits.clear();
    for (std::size_t i = 0; i < map.size(); ++i) {
      hits.emplace_back(map.getPointsBufferRef_x()[i], map.getPointsBufferRef_y()[i],
                        map.getPointsBufferRef_z()[i]);
    }
  }

  void check_end() {
    sidecars_.check_end();
    if (archive_.place() != GzArchive::Place::kGoodEnd) {
      reject("the log goes on after its last frame or is damaged");
    }
  }

  [[noreturn]] void reject(const std::string& message) const {
    throw ldm::InvalidInput(files_.rawlog.string() + ": frame " + std::to_string(next_) + ": " +
                            message);
  }

  LogFiles files_;
  GzArchive archive_;
  LogDescription description_;
  BeamTable beams_;
  SidecarReader sidecars_;
  RangeImage image_;
  std::int64_t next_ = 0;
};

RawlogReader::RawlogReader(const fs::path& rawlog) : log_(std::make_unique<Log>(rawlog)) {}
RawlogReader::~RawlogReader() = default;

const LidarModel& RawlogReader::lidar() const {
  return log_->description().lidar;
}
const ldm::Pose& RawlogReader::T_uav_sensor() const {
  return log_->description().T_uav_sensor;
}
bool RawlogReader::next(Frame& frame) {
  return log_->next(frame);
}
std::optional<std::int64_t> RawlogReader::size() const {
  return log_->description().frames;
}

}  // namespace datasets
