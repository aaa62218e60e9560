#include <mrpt/maps/CSimplePointsMap.h>
#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/serialization/CArchive.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <numbers>
#include <stdexcept>
#include <string>

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

/// A folder that is gone in the end: what shall stay must have been moved out of it.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const fs::path& path) : path_(path) {
    std::error_code error;
    fs::create_directory(path_, error);
    if (error) throw ldm::InvalidInput(path_.string() + ": cannot be created: " + error.message());
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // a stray temporary folder does no harm
    fs::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Writes MRPT's objects to a gz file. MRPT's own output stream does not tell of a full disk when
/// it is closed; hence zlib's functions.
class GzArchive final : public mrpt::serialization::CArchive {
 public:
  explicit GzArchive(const fs::path& file)
      : file_(file), gz_(gzopen(file.c_str(), "wb1"), gzclose) {
    if (!gz_) throw ldm::InvalidInput(file.string() + ": cannot be written");
  }

  void close() {
    if (gzclose(gz_.release()) != Z_OK) failed_ = true;
    check();
  }
  /// @throws std::runtime_error if something could not be written until now.
  void check() const {
    if (failed_) throw std::runtime_error(file_.string() + ": cannot be written: disk full?");
  }
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

  fs::path file_;
  std::unique_ptr<gzFile_s, int (*)(gzFile)> gz_;
  bool failed_ = false;
};

}  // namespace

class RawlogWriter::Log {
 public:
  Log(const fs::path& rawlog, const LidarModel& lidar, const ldm::Pose& T_uav_sensor)
      : final_(rawlog),
        // The process id keeps apart two runs that write the same log.
        folder_(rawlog.string() + "." + std::to_string(getpid()) + ".part"),
        temporary_(folder_.path() / rawlog.filename()),
        description_{0, lidar, T_uav_sensor},
        sidecars_(temporary_),
        archive_(temporary_.rawlog) {
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
    sidecars_.close();
    write_description(temporary_.description, description_);
    // The log proper goes last: where it stands, the files beside it are its own.
    fs::remove(final_.rawlog);
    const std::vector<fs::path> from = temporary_.sidecars(), to = final_.sidecars();
    for (std::size_t i = 0; i < from.size(); ++i) fs::rename(from[i], to[i]);
    fs::rename(temporary_.rawlog, final_.rawlog);
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

  LogFiles final_;
  TemporaryFolder folder_;
  LogFiles temporary_;
  LogDescription description_;
  SidecarWriter sidecars_;
  GzArchive archive_;
  mrpt::obs::CObservationRotatingScan scan_;
};

RawlogWriter::RawlogWriter(const fs::path& rawlog, const LidarModel& lidar,
                           const ldm::Pose& T_uav_sensor)
    : log_(std::make_unique<Log>(rawlog, lidar, T_uav_sensor)) {}
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
