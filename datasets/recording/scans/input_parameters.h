#pragma once
/// What a recording needs before a mapper can use it, as a table of parameters: where the sensor
/// sits, what to leave out of its scans (paper Sec. 4.2: ground returns are ignored).
///
/// The table has the form of `ldm::Parameters`; the names go on in the same files and options.
#include <string>
#include <string_view>

#include "ldm/parameters.h"

namespace datasets {

/// Where the poses of a recording come from.
enum class PoseSource {
  kLog,       ///< the trajectory file, a bag's TF or poses, an MRPT log's CObservationRobotPose
  kOdometry,  ///< a bag's nav_msgs/Odometry rather than its TF, an MRPT log's CObservationOdometry
  kStill,     ///< nowhere: the vehicle stands still at the world's origin
};
inline constexpr std::string_view kPoseSourceNames[] = {"log", "odometry", "still"};

/// Whose poses a trajectory file holds.
enum class PosesOf {
  kAuto,  ///< the camera's in a KITTI folder with a calib.txt, else the sensor's
  kSensor,
  kVehicle,
  kCamera,  ///< that of calib.txt
};
inline constexpr std::string_view kPosesOfNames[] = {"auto", "sensor", "vehicle", "camera"};

/// How many floats each point of a .bin file has.
enum class BinColumns {
  kAuto,  ///< found by the files' sizes and the look of the fifth number
  kFour,  ///< KITTI: x, y, z, intensity
  kFive,  ///< nuScenes: and the ring
};
inline constexpr std::string_view kBinColumnsNames[] = {"auto", "4", "5"};

enum class GroundRemoval {
  kNone,
  kPlane,  ///< one plane a frame, fitted to the lowest points around the sensor
  kGrid,   ///< heights that spread from that plane over a grid of cells, and so follow hills
};
inline constexpr std::string_view kGroundRemovalNames[] = {"none", "plane", "grid"};

/// What becomes of a ray that ends on the ground.
enum class GroundRays {
  kFree,  ///< it stays as a ray without a return: what it crossed is free
  kDrop,
};
inline constexpr std::string_view kGroundRaysNames[] = {"free", "drop"};

/// Where the rays come from that met nothing, of which most recordings say nothing.
enum class NoReturns {
  kPattern,  ///< found in the sensor's pattern where that is certain (see MissingRays)
  kLog,      ///< the recording alone
  kGaps,     ///< as kPattern; where none is certain, gaps between the points (see GapRays)
};
inline constexpr std::string_view kNoReturnsNames[] = {"pattern", "log", "gaps"};

/// What a 0 in the range image of an MRPT rotating scan says.
enum class ZeroRanges { kNothing, kNoReturn };
inline constexpr std::string_view kZeroRangesNames[] = {"nothing", "no_return"};

struct SensorMountParameters {
  bool from_log = true;
  double x = 0, y = 0, z = 0;           // [m]
  double roll = 0, pitch = 0, yaw = 0;  // [deg]
};

/// A box around the vehicle, in its frame; it is empty while an edge has no length.
struct BodyParameters {
  double x_min = 0, x_max = 0, y_min = 0, y_max = 0, z_min = 0, z_max = 0;  // [m]
};

struct GroundParameters {
  GroundRemoval removal = GroundRemoval::kNone;
  double margin = 0.25;   // [m]
  double max_slope = 15;  // [deg]
  double radius = 20;     // [m]
  double cell = 1;        // [m]
  GroundRays rays = GroundRays::kFree;
};

struct RotatingScanParameters {
  double elevation_first = 0, elevation_last = 0;  // [deg]
  ZeroRanges zeros = ZeroRanges::kNothing;
};

struct InputParameters {
  PoseSource poses = PoseSource::kLog;
  PosesOf poses_of = PosesOf::kAuto;
  BinColumns bin_columns = BinColumns::kAuto;
  double pose_gap = 1;  // [s]
  bool deskew = true;
  SensorMountParameters sensor;
  BodyParameters body;
  double min_range = 0.5, max_range = 1000;  // [m]
  NoReturns no_returns = NoReturns::kPattern;
  GroundParameters ground;
  RotatingScanParameters rotating;
};

/// As `ldm::visit_parameters`.
template <class P, class Visitor>
void visit_parameters(
    P& p, Visitor&& visit) requires std::is_same_v<std::remove_const_t<P>, InputParameters> {
  using Info = ldm::ParameterInfo;
  constexpr std::string_view kSource = "-";
  visit(Info{"input.poses", "", "", 0, 2, kSource,
             "poses: of the log; its odometry rather than others (MRPT, bags); none: the vehicle "
             "stands still"},
        p.poses, kPoseSourceNames);
  visit(Info{"input.poses_of", "", "", 0, 3, kSource,
             "whose poses a trajectory file holds; auto: the camera's of a calib.txt, or the "
             "sensor's"},
        p.poses_of, kPosesOfNames);
  visit(Info{"input.bin_columns", "", "", 0, 2, kSource,
             "floats of each point in .bin files: x, y, z, intensity and, if 5, the ring"},
        p.bin_columns, kBinColumnsNames);
  visit(Info{"input.pose_gap_s", "", "s", 0.001, 3600, kSource,
             "longest gap between two poses that may be bridged for a scan between them"},
        p.pose_gap);
  visit(Info{"input.deskew", "", "", 0, 1, kSource,
             "points of a bag that say when they were measured are moved to their scan's time"},
        p.deskew);

  visit(Info{"input.sensor.from_log", "", "", 0, 1, kSource,
             "an MRPT log says where its sensor sits on the vehicle; false: the next six do"},
        p.sensor.from_log);
  constexpr double kFar = 100;
  visit(Info{"input.sensor.x_m", "", "m", -kFar, kFar, kSource, "sensor on the vehicle: forward"},
        p.sensor.x);
  visit(Info{"input.sensor.y_m", "", "m", -kFar, kFar, kSource, "left"}, p.sensor.y);
  visit(Info{"input.sensor.z_m", "", "m", -kFar, kFar, kSource, "up"}, p.sensor.z);
  visit(Info{"input.sensor.roll_deg", "", "deg", -180, 180, kSource,
             "turn about x, after pitch and yaw as R = Rz(yaw) Ry(pitch) Rx(roll)"},
        p.sensor.roll);
  visit(Info{"input.sensor.pitch_deg", "", "deg", -180, 180, kSource, "about y: nose down is +"},
        p.sensor.pitch);
  visit(Info{"input.sensor.yaw_deg", "", "deg", -180, 180, kSource, "about z: to the left is +"},
        p.sensor.yaw);

  visit(Info{"input.body.x_min_m", "", "m", -kFar, kFar, kSource,
             "box around the vehicle, in its frame, whose points are left out"},
        p.body.x_min);
  visit(Info{"input.body.x_max_m", "", "m", -kFar, kFar, kSource, "no box while min = max"},
        p.body.x_max);
  visit(Info{"input.body.y_min_m", "", "m", -kFar, kFar, kSource, ""}, p.body.y_min);
  visit(Info{"input.body.y_max_m", "", "m", -kFar, kFar, kSource, ""}, p.body.y_max);
  visit(Info{"input.body.z_min_m", "", "m", -kFar, kFar, kSource, ""}, p.body.z_min);
  visit(Info{"input.body.z_max_m", "", "m", -kFar, kFar, kSource, ""}, p.body.z_max);

  visit(Info{"input.min_range_m", "", "m", 0, 1000, kSource, "nearer points are left out"},
        p.min_range);
  visit(Info{"input.max_range_m", "", "m", 0.1, 100000, kSource, "farther points are left out"},
        p.max_range);

  visit(Info{"input.no_returns", "", "", 0, 2, kSource,
             "rays without a return: found by the sensor's pattern where that is certain, else by "
             "gaps between the points if so told, or those of the recording alone"},
        p.no_returns, kNoReturnsNames);

  visit(Info{"input.ground.removal", "", "", 0, 2, "Sec. 4.2.1, way assumed",
             "how the ground is found, whose points are left out"},
        p.ground.removal, kGroundRemovalNames);
  visit(Info{"input.ground.margin_m", "", "m", 0.01, 5, kSource,
             "points up to this height above the ground are ground"},
        p.ground.margin);
  visit(Info{"input.ground.max_slope_deg", "", "deg", 0, 45, kSource, "steepest ground"},
        p.ground.max_slope);
  visit(Info{"input.ground.radius_m", "", "m", 2, 200, kSource,
             "the plane is fitted to what lies within this distance of the sensor"},
        p.ground.radius);
  visit(Info{"input.ground.cell_m", "", "m", 0.2, 10, kSource,
             "edge of the cells whose lowest points stand for the ground"},
        p.ground.cell);
  visit(Info{"input.ground.rays", "", "", 0, 1, kSource,
             "rays that end on the ground mark free space (if sensor_model.no_returns = free)"},
        p.ground.rays, kGroundRaysNames);

  visit(Info{"input.rotating.elevation_first_deg", "", "deg", -90, 90, kSource,
             "of an MRPT rotating scan of no known model: elevation of its first row"},
        p.rotating.elevation_first);
  visit(Info{"input.rotating.elevation_last_deg", "", "deg", -90, 90, kSource,
             "of its last row; those between are spread evenly"},
        p.rotating.elevation_last);
  visit(Info{"input.rotating.zeros", "", "", 0, 1, kSource,
             "a range of 0 says nothing, or that the ray met nothing"},
        p.rotating.zeros, kZeroRangesNames);
}

/// True for the names of this table and misspelt ones: they begin with `input.`.
bool is_input_parameter(std::string_view name);

/// As `ldm::get_parameter` and `ldm::set_parameter`.
std::string get_parameter(const InputParameters& parameters, std::string_view name);
void set_parameter(InputParameters& parameters, std::string_view name, std::string_view text);

/// What no single value shows. @throws ldm::InvalidInput naming both values if a lower bound of
/// range or box lies above its upper one.
void check(const InputParameters& parameters);

}  // namespace datasets
