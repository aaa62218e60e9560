#include "datasets/recording/formats/mrpt_log_reader.h"

#include <mrpt/obs/CActionCollection.h>
#include <mrpt/obs/CObservationOdometry.h>
#include <mrpt/obs/CObservationRobotPose.h>
#include <mrpt/obs/CSensoryFrame.h>

#include <exception>

#include "datasets/files/gz_archive.h"
#include "datasets/files/printable.h"
#include "datasets/files/text.h"
#include "datasets/quaternion_pose.h"
#include "datasets/recording/formats/mrpt_scans.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/sensor_mount.h"
#include "datasets/recording/scans/trajectory.h"
#include "datasets/recording/scans/waiting_scan_reader.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;
using mrpt::obs::CObservation;

ldm::Pose pose_of(const mrpt::poses::CPose3D& p) {
  return {p.getRotationMatrix().asEigen(), {p.x(), p.y(), p.z()}};
}

/// Class and label of an observation.
std::string kind_of(const CObservation& observation) {
  return std::string(observation.GetRuntimeClass()->className) + " `" +
         printable(observation.sensorLabel) + "`";
}

/// A scan whose pose may not have been read yet.
struct WaitingObservation {
  std::string place;
  double time = 0;  ///< [s]
  CObservation::Ptr observation;
};

class MrptLogReader : public WaitingScanReader<WaitingObservation> {
 public:
  MrptLogReader(const fs::path& rawlog, const InputParameters& parameters)
      : name_(rawlog.string()), archive_(rawlog), parameters_(parameters) {}

  InputCounts counts() const override {
    InputCounts counts;
    if (others_ > 0) counts.other["other observations in the log"] = others_;
    counts.other_sensors = other_sensors_;
    return counts;
  }

 private:
  bool covers(const WaitingObservation& waiting) const override {
    return parameters_.poses == PoseSource::kStill || track_.covers(waiting.time);
  }

  void read_on() override {
    switch (archive_.place()) {
      case GzArchive::Place::kMore:
        break;
      case GzArchive::Place::kBadEnd:
        return end_damaged();
      case GzArchive::Place::kGoodEnd:
        if (scan_kind_.empty()) reject_empty();
        return end();
    }
    const mrpt::serialization::CSerializable::Ptr object = archive_.read_object();
    if (!object) return end_damaged();
    if (const auto frame = std::dynamic_pointer_cast<mrpt::obs::CSensoryFrame>(object)) {
      for (const CObservation::Ptr& observation : *frame) take(observation);
    } else {
      take(std::dynamic_pointer_cast<CObservation>(object));
    }
    ++objects_;
  }

  /// An observation of no use is counted, and so is what is none: an action, a comment.
  void take(const CObservation::Ptr& observation) {
    if (!observation || !(take_scan(observation) || take_pose(*observation))) ++others_;
    if (observation && is_scan(*observation) && !is_of(scan_kind_, *observation)) {
      ++other_sensors_[kind_of(*observation)];
    }
  }

  bool take_scan(const CObservation::Ptr& observation) {
    if (!is_scan(*observation) || !is_of(scan_kind_, *observation)) return false;
    wait({place_now(), mrpt::Clock::toDouble(observation->timestamp), observation});
    return true;
  }

  /// Of two poses that go back in time the first stays.
  bool take_pose(const CObservation& observation) {
    const std::optional<StampedPose> pose = pose_in(observation);
    return pose && is_of(pose_kind_, observation) && track_.add(*pose);
  }

  /// True if `kind` is the observation's, or was none until now.
  static bool is_of(std::string& kind, const CObservation& observation) {
    if (kind.empty()) kind = kind_of(observation);
    return kind == kind_of(observation);
  }

  std::optional<StampedPose> pose_in(const CObservation& observation) const {
    const double time = mrpt::Clock::toDouble(observation.timestamp);
    if (const auto* o = dynamic_cast<const mrpt::obs::CObservationRobotPose*>(&observation);
        o != nullptr && parameters_.poses == PoseSource::kLog) {
      return StampedPose{time, pose_of(o->pose.mean)};
    }
    if (const auto* o = dynamic_cast<const mrpt::obs::CObservationOdometry*>(&observation);
        o != nullptr && parameters_.poses == PoseSource::kOdometry) {
      return StampedPose{time, pose_of(mrpt::poses::CPose3D(o->odometry))};
    }
    return {};
  }

  void take(WaitingObservation& waiting, ldm::Scan& scan) override {
    scan.time = waiting.time;
    const ldm::Pose T_world_uav = vehicle_at(waiting.time);
    const ldm::Pose mount = mount_of(parameters_.sensor, mount_in(*waiting.observation), place());
    set_poses(T_world_uav, PosesOf::kVehicle, mount, scan);
    const std::string failure =
        datasets::take_scan(*waiting.observation, parameters_.rotating, scan);
    if (!failure.empty()) throw BrokenFrame("broken scan", place() + ": " + failure);
  }

  ldm::Pose vehicle_at(double time) {
    if (parameters_.poses == PoseSource::kStill) return {};
    if (const auto pose = track_.at(time, parameters_.pose_gap)) return *pose;
    const std::string sought =
        parameters_.poses == PoseSource::kLog ? "CObservationRobotPose" : "CObservationOdometry";
    std::string message = place() + ": no pose at " + decimal(time) + " s: ";
    if (track_.empty()) {
      message += "the log has no " + sought +
                 (ended() ? "" : " up to object " + std::to_string(objects_)) +
                 ": allowed: --set input.poses=still for a sensor at rest, or " +
                 (parameters_.poses == PoseSource::kLog ? "odometry" : "log");
    } else {
      message += "the log has " + track_.around(time) +
                 ": allowed: a gap of input.pose_gap_s = " + decimal(parameters_.pose_gap);
    }
    throw BrokenFrame("no pose", message);
  }

  [[noreturn]] void reject_empty() const {
    throw ldm::InvalidInput(name_ +
                            ": has no scan: allowed: CObservationVelodyneScan, "
                            "CObservationPointCloud or CObservationRotatingScan");
  }

  void end_damaged() {
    const BrokenFrame damage("broken log", place_now() + ": " + archive_.failure());
    end(std::make_exception_ptr(damage));
  }

  std::string place_now() const { return name_ + ": object " + std::to_string(objects_); }

  std::string name_;
  GzArchive archive_;
  InputParameters parameters_;
  std::int64_t objects_ = 0;  // read so far
  std::int64_t others_ = 0;
  InputCounts::ByReason other_sensors_;
  std::string scan_kind_, pose_kind_;
  PoseTrack track_;
};

}  // namespace

std::unique_ptr<ScanReader> open_mrpt_log(const fs::path& rawlog, const RecordingOptions& options) {
  for (const auto& [option, file] :
       {std::pair{"--poses", options.poses}, std::pair{"--times", options.times}}) {
    if (!file) continue;
    throw ldm::InvalidInput(std::string(option) + " " + file->string() +
                            ": allowed: with a folder of scans; an MRPT log has its own");
  }
  if (options.time_unit) {
    throw ldm::InvalidInput(
        "--time-unit: allowed: with a folder of scans; an MRPT log has its own");
  }
  return std::make_unique<MrptLogReader>(rawlog, options.input);
}

}  // namespace datasets
