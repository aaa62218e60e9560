#include "datasets/recording/formats/pcap/pcap_reader.h"

#include <exception>
#include <utility>

#include "datasets/files/text.h"
#include "datasets/recording/formats/pcap/pcap_contents.h"
#include "datasets/recording/rays/scan_rays.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/deskew.h"
#include "datasets/recording/scans/given_trajectory.h"
#include "datasets/recording/scans/scan_names.h"
#include "datasets/recording/scans/scan_trajectory.h"
#include "datasets/recording/scans/sensor_mount.h"
#include "datasets/recording/scans/waiting_scan_reader.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

/// The scans of a capture file, without poses.
class PcapScans {
 public:
  explicit PcapScans(const fs::path& file) : plan_(plan_of_pcap(file)), datagrams_(file) {}

  /// False at the end.
  /// @throws BrokenFrame where the file is damaged: it then ends.
  bool next(PacketScan& scan) {
    for (Datagram datagram; !ended_ && datagrams_.next(datagram);) {
      if (!plan_.scans->is_packet(datagram)) continue;
      if (datagram.source != plan_.source || datagram.port != plan_.port) {
        ++others_[datagram.source + " to port " + std::to_string(datagram.port) + " (packets)"];
      } else if (plan_.scans->take(datagram, scan)) {
        return true;
      }
    }
    ended_ = true;
    return plan_.scans->finish(scan);
  }
  const std::string& place() const { return datagrams_.place(); }
  const InputCounts::ByReason& others() const { return others_; }

 private:
  PcapPlan plan_;
  UdpDatagrams datagrams_;
  bool ended_ = false;
  InputCounts::ByReason others_;
};

/// A scan whose poses may not have been read yet.
struct WaitingTurn {
  PacketScan scan;
  std::string place, failure;
  double end = 0;  ///< when its last point was measured [s]
};

class PcapReader : public WaitingScanReader<WaitingTurn> {
 public:
  PcapReader(const fs::path& file, const RecordingOptions& options)
      : scans_(file),
        of_vehicle_(options.input.poses_of == PosesOf::kVehicle),
        deskew_(options.input.deskew && options.poses),
        longest_gap_(options.input.pose_gap),
        T_uav_sensor_(mount_of(options.input.sensor)),
        rays_(options.input.no_returns != NoReturns::kLog) {
    if (options.poses) trajectory_.emplace(options);
  }

  InputCounts counts() const override {
    InputCounts counts;
    counts.other_sensors = scans_.others();
    rays_.count(counts.other);
    if (clock_set_ > 0) counts.other["turns in which the sensor's clock was set"] = clock_set_;
    return counts;
  }

 private:
  bool covers(const WaitingTurn& waiting) const override {
    return !trajectory_ || trajectory_->covers(waiting.end);
  }

  void read_on() override {
    WaitingTurn waiting;
    try {
      if (!scans_.next(waiting.scan)) return end();
    } catch (const BrokenFrame&) {
      return end(std::current_exception());
    }
    waiting.place = scans_.place();
    waiting.end = end_of(waiting.scan.time, waiting.scan.delays);
    if (!deskew_) waiting.scan.delays.clear();
    try {
      if (trajectory_) trajectory_->take_scan(waiting.scan.time);
    } catch (const BrokenFrame& error) {
      waiting.failure = error.what();
    }
    wait(std::move(waiting));
  }

  void take(WaitingTurn& waiting, ldm::Scan& scan) override {
    if (!waiting.failure.empty()) throw BrokenFrame("bad pose", waiting.failure);
    const double time = waiting.scan.time;
    scan.time = time;
    set_poses_at(time, scan);
    scan.points = std::move(waiting.scan.points);
    clock_set_ += waiting.scan.clock_set;
    TimedRays rays = rays_.of(scan.points, waiting.scan.delays, waiting.scan.lost);
    ldm::Scan moment;
    const auto sensor_at = [&](double delay) -> std::optional<ldm::Pose> {
      set_poses_at(time + delay, moment);
      return moment.T_world_sensor;
    };
    deskew(waiting.scan.delays, scan.T_world_sensor, sensor_at, scan.points, rays);
    scan.no_returns = std::move(rays.rays);
  }

  /// At rest it is the vehicle that stands at the origin.
  void set_poses_at(double time, ldm::Scan& scan) {
    std::optional<ldm::Pose> pose = ldm::Pose();
    if (trajectory_) pose = trajectory_->at(time, longest_gap_);
    if (!pose) {
      throw BrokenFrame("no pose",
                        place() + ": no pose at " + decimal(time) + " s: the file of --poses has " +
                            trajectory_->around(time) +
                            ": allowed: a gap of input.pose_gap_s = " + decimal(longest_gap_));
    }
    const bool vehicle = of_vehicle_ || !trajectory_;
    set_poses(*pose, vehicle ? PosesOf::kVehicle : PosesOf::kSensor, T_uav_sensor_, scan);
  }

  PcapScans scans_;
  std::optional<ScanTrajectory> trajectory_;  // none: at rest
  bool of_vehicle_;                           // it, not the sensor, has the poses
  bool deskew_;
  double longest_gap_;  // [s]
  ldm::Pose T_uav_sensor_;
  ScanRays rays_;
  std::int64_t clock_set_ = 0;
};

std::int64_t count_scans(const fs::path& file) {
  PcapScans scans(file);
  std::int64_t count = 0;
  try {
    for (PacketScan scan; scans.next(scan);) ++count;
  } catch (const BrokenFrame&) {  // which is told when its turn comes
  }
  return count;
}

}  // namespace

bool is_pcap(const fs::path& file) {
  return is_scan_name(file, ".pcap") || is_scan_name(file, ".pcapng");
}

std::unique_ptr<ScanReader> open_pcap(const fs::path& file, const RecordingOptions& options) {
  RecordingOptions resolved = options;
  if (options.times) {
    throw ldm::InvalidInput("--times " + options.times->string() +
                            ": allowed: with a folder of scans; packets have their own");
  }
  if (options.input.poses_of == PosesOf::kCamera) {
    throw ldm::InvalidInput("input.poses_of = camera: allowed: in a KITTI folder with a calib.txt");
  }
  if (options.input.poses == PoseSource::kStill) {
    resolved.poses.reset();
  } else if (!options.poses || options.input.poses == PoseSource::kOdometry) {
    throw ldm::InvalidInput(file.string() +
                            ": has no poses: allowed: --poses FILE (docs/recordings.md says where "
                            "from), or --set input.poses=still for a sensor at rest");
  } else {
    resolved.poses = trajectory_in(*options.poses);
    // A line too few or too many would give each scan behind it the pose of another.
    if (counts_scans(*resolved.poses, 0)) {
      check_pose_count(resolved, count_scans(file), file.string());
    }
  }
  return std::make_unique<PcapReader>(file, resolved);
}

}  // namespace datasets
