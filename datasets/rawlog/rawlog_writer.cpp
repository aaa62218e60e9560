#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <numbers>
#include <stdexcept>
#include <string>

#include "datasets/files/partial_file.h"
#include "datasets/rawlog/rawlog.h"
#include "datasets/rawlog/rawlog_labels.h"
#include "datasets/rawlog/rawlog_sidecars.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

mrpt::poses::CPose3D mrpt_pose(const QuaternionPose& p) {
  return {mrpt::math::CQuaternionDouble(p.w, p.x, p.y, p.z), p.translation.x(), p.translation.y(),
          p.translation.z()};
}

/// Writes MRPT's objects to a gz file. MRPT's own output stream does not tell of a full disk when
/// it is closed; hence zlib's functions.
class GzWriter final : public mrpt::serialization::CArchive {
 public:
  /// @param file outlives this
  explicit GzWriter(const PartialFile& file)
      : file_(file), gz_(gzopen(file.temporary_name().c_str(), "wb1"), gzclose) {
    file_.require(gz_ != nullptr);
  }

  void close() {
    if (gzclose(gz_.release()) != Z_OK) failed_ = true;
    check();
  }
  /// @throws std::runtime_error if something could not be written until now.
  void check() const { file_.require(!failed_); }
  std::string getArchiveDescription() const override { return "recorded log"; }

 private:
  std::size_t read(void*, std::size_t) override {
    throw std::logic_error("this archive is for writing");
  }
  std::size_t write(const void* buffer, std::size_t count) override {
    // An exception from here would reach the caller as several lines about MRPT's source files.
    if (gzfwrite(buffer, 1, count, gz_.get()) != count) failed_ = true;
    return count;
  }

  const PartialFile& file_;
  std::unique_ptr<gzFile_s, int (*)(gzFile)> gz_;
  bool failed_ = false;
};

}  // namespace

class RawlogWriter::Log {
 public:
  Log(const LogFiles& files, const LidarModel& lidar, const ldm::Pose& T_uav_sensor)
      : rawlog_name_(files.rawlog),
        rawlog_(files.rawlog),
        description_file_(files.description),
        frames_(files.frames),
        truth_(files.truth),
        solids_(files.solids),
        description_{0, lidar, T_uav_sensor},
        sidecars_(frames_.stream(), truth_.stream(), solids_.stream()),
        archive_(rawlog_) {
    prepare_scan();
  }

  void write(double time, const QuaternionPose& T_world_uav, const RangeImage& image,
             const Truth& truth) {
    sidecars_.write({description_.frames++, time, T_world_uav}, truth.objects);
    const auto timestamp = mrpt::Clock::fromDouble(time);
    write_scan(timestamp, image);
    write_pose(timestamp, kUavLabel, mrpt_pose(T_world_uav));
    write_hits(timestamp, truth.noise_free_hits);
    for (const ObjectState& object : truth.objects) {
      write_pose(timestamp, object_label(object.id), mrpt_pose({object.position}));
    }
    archive_.check();
  }

  void close() {
    archive_.close();
    write_description(description_, description_file_.stream());
    const auto files = {&description_file_, &frames_, &truth_, &solids_, &rawlog_};
    for (PartialFile* file : files) file->complete();
    // The log proper goes last: where it stands, the files beside it are its own.
    fs::remove(rawlog_name_);
    for (PartialFile* file : files) file->commit();
  }

 private:
  void prepare_scan() {
    const LidarModel& lidar = description_.lidar;
    scan_.sensorLabel = kLidarLabel;
    scan_.lidarModel = "simulated";
    scan_.rowCount = static_cast<std::uint16_t>(lidar.elevations.size());
    scan_.columnCount = static_cast<std::uint16_t>(lidar.azimuths);
    scan_.rangeImage.resize(scan_.rowCount, scan_.columnCount);
    scan_.intensityImage.setZero(scan_.rowCount, scan_.columnCount);
    scan_.rangeResolution = RangeImage::kQuantum;
    scan_.startAzimuth = -std::numbers::pi;
    scan_.azimuthSpan = 2 * std::numbers::pi;
    scan_.minRange = lidar.min_range;
    scan_.maxRange = lidar.max_range;
    scan_.sensorPose = mrpt_pose(to_quaternion_pose(description_.T_uav_sensor));
    scan_.has_satellite_timestamp = true;
  }

  void write_scan(mrpt::Clock::time_point timestamp, const RangeImage& image) {
    assert(image.channels == scan_.rowCount && image.azimuths == scan_.columnCount);
    scan_.timestamp = scan_.originalReceivedTimestamp = timestamp;
    std::copy(image.ranges.begin(), image.ranges.end(), &scan_.rangeImage(0, 0));
    archive_ << scan_;
  }

  void write_pose(mrpt::Clock::time_point timestamp, const std::string& label,
                  const mrpt::poses::CPose3D& pose) {
    mrpt::obs::CObservationRobotPose observation;
    observation.timestamp = timestamp;
    observation.sensorLabel = label;
    observation.pose.mean = pose;
    archive_ << observation;
  }

  void write_hits(mrpt::Clock::time_point timestamp, const std::vector<ldm::Point>& hits) {
    auto map = mrpt::maps::CSimplePointsMap::Create();
    map->reserve(hits.size());
    for (const ldm::Point& p : hits) map->insertPointFast(p.x(), p.y(), p.z());
    mrpt::obs::CObservationPointCloud observation;
    observation.timestamp = timestamp;
    observation.sensorLabel = kHitsLabel;
    observation.pointcloud = map;
    archive_ << observation;
  }

  fs::path rawlog_name_;
  PartialFile rawlog_, description_file_, frames_, truth_, solids_;
  LogDescription description_;
  SidecarWriter sidecars_;
  GzWriter archive_;
  mrpt::obs::CObservationRotatingScan scan_;
};

RawlogWriter::RawlogWriter(const fs::path& rawlog, const LidarModel& lidar,
                           const ldm::Pose& T_uav_sensor)
    : log_(std::make_unique<Log>(LogFiles(rawlog), lidar, T_uav_sensor)) {}
RawlogWriter::~RawlogWriter() = default;

void RawlogWriter::write(double time, const QuaternionPose& T_world_uav, const RangeImage& image,
                         const Truth& truth) {
  log_->write(time, T_world_uav, image, truth);
}

void RawlogWriter::close() {
  log_->close();
  log_.reset();
}

}  // namespace datasets
