#include "datasets/recording/formats/mrpt_scans.h"

#include <mrpt/obs/CObservationPointCloud.h>
#include <mrpt/obs/CObservationRotatingScan.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <cmath>
#include <exception>
#include <numbers>

#include "datasets/files/toml_node.h"
#include "datasets/recording/formats/velodyne_packet.h"

namespace datasets {
namespace {

using mrpt::obs::CObservationPointCloud;
using mrpt::obs::CObservationRotatingScan;
using mrpt::obs::CObservationVelodyneScan;

template <class Cloud>
void take_points(const Cloud& x, const Cloud& y, const Cloud& z, ldm::Scan& scan) {
  scan.points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) scan.points.emplace_back(x[i], y[i], z[i]);
}

std::string take(CObservationVelodyneScan& velodyne, ldm::Scan& scan) {
  if (velodyne.scan_packets.empty()) {
    const auto& cloud = velodyne.point_cloud;
    take_points(cloud.x, cloud.y, cloud.z, scan);
    return {};
  }
  std::vector<VelodynePoint> points;
  bool known = false;
  for (const auto& packet : velodyne.scan_packets) {
    known |= take_velodyne_points(packet, velodyne.calibration, points);
  }
  if (!known) return "its packets are none of a sensor that is known";
  if (points.empty()) return "its packets hold no points";
  for (const VelodynePoint& p : points) {
    const double range = p.point.cast<double>().norm();
    if (range >= velodyne.minRange && range <= velodyne.maxRange) scan.points.push_back(p.point);
  }
  return {};
}

std::string take(const CObservationPointCloud& observation, ldm::Scan& scan) {
  try {
    observation.load();  // where the points lie in a file beside the log
  } catch (const std::exception&) {
    return "its points in " + observation.getExternalStorageFile() + " cannot be read";
  }
  if (!observation.pointcloud) return "it has no points";
  const auto& cloud = *observation.pointcloud;
  take_points(cloud.getPointsBufferRef_x(), cloud.getPointsBufferRef_y(),
              cloud.getPointsBufferRef_z(), scan);
  return {};
}

/// Angles of a range image [rad].
struct RotatingBeams {
  std::vector<double> elevations;  ///< by row
  double azimuth_begin = 0, azimuth_step = 0;
  double azimuth(int column) const { return azimuth_begin + azimuth_step * column; }
};

int last_used_column(const CObservationRotatingScan& scan) {
  for (int column = scan.columnCount - 1; column > 0; --column) {
    for (int row = 0; row < scan.rowCount; ++row) {
      if (scan.rangeImage(row, column) != 0) return column;
    }
  }
  return 0;
}

/// Elevation of a row [deg], by the order in which Velodyne numbers its lasers.
double velodyne_elevation(const std::string& model, int row) {
  if (model == "VLP-16") return row % 2 == 0 ? -15 + row : row;
  return (row % 2 == 0 ? -30.0 - 2.0 / 3.0 : -9.0 - 1.0 / 3.0) +
         (row - row % 2) * 2.0 / 3.0;  // HDL-32E
}

RotatingBeams beams_of(const CObservationRotatingScan& scan, const RotatingScanParameters& p) {
  constexpr double kDegree = std::numbers::pi / 180;
  const std::string& model = scan.lidarModel;
  const bool velodyne =
      (model == "VLP-16" && scan.rowCount == 16) || (model == "HDL-32E" && scan.rowCount == 32);
  RotatingBeams beams;
  const int rows = scan.rowCount;
  for (int row = 0; row < rows; ++row) {
    const double share = rows > 1 ? static_cast<double>(row) / (rows - 1) : 0;
    const double spread = p.elevation_first + share * (p.elevation_last - p.elevation_first);
    beams.elevations.push_back(kDegree * (velodyne ? velodyne_elevation(model, row) : spread));
  }
  // MRPT's conversion from Velodyne packets, which alone writes these models' names, puts firing
  // after firing into the first columns of an image that is far too wide, and keeps Velodyne's
  // sense of rotation, clockwise.
  const int last = std::max(velodyne ? last_used_column(scan) : scan.columnCount - 1, 1);
  const double sense = velodyne ? -1 : 1;
  beams.azimuth_begin = sense * scan.startAzimuth;
  beams.azimuth_step = sense * scan.azimuthSpan / last;
  return beams;
}

std::string take(const CObservationRotatingScan& rotating, const RotatingScanParameters& p,
                 ldm::Scan& scan) {
  if (rotating.rangeImage.rows() != rotating.rowCount ||
      rotating.rangeImage.cols() != rotating.columnCount) {
    return "its range image is not as large as it says";
  }
  const RotatingBeams beams = beams_of(rotating, p);
  if (rotating.rowCount > 1 && beams.elevations.front() == beams.elevations.back()) {
    return "its elevations are unknown (model " + rotating.lidarModel +
           "): allowed: input.rotating.elevation_first_deg and elevation_last_deg";
  }
  for (int row = 0; row < rotating.rowCount; ++row) {
    const double elevation = beams.elevations[static_cast<std::size_t>(row)];
    for (int column = 0; column < rotating.columnCount; ++column) {
      const double azimuth = beams.azimuth(column);
      const std::uint16_t range = rotating.rangeImage(row, column);
      if (range == 0 && p.zeros == ZeroRanges::kNothing) continue;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      if (range == 0) {
        scan.no_returns.push_back(ray.cast<float>());
      } else {
        scan.points.push_back((range * rotating.rangeResolution * ray).cast<float>());
      }
    }
  }
  return {};
}

}  // namespace

bool is_scan(const mrpt::obs::CObservation& observation) {
  return dynamic_cast<const CObservationVelodyneScan*>(&observation) != nullptr ||
         dynamic_cast<const CObservationPointCloud*>(&observation) != nullptr ||
         dynamic_cast<const CObservationRotatingScan*>(&observation) != nullptr;
}

ldm::Pose mount_in(const mrpt::obs::CObservation& observation) {
  mrpt::poses::CPose3D pose;
  observation.getSensorPose(pose);
  ldm::Pose mount;
  mount.translation << pose.x(), pose.y(), pose.z();
  mount.rotation = pose.getRotationMatrix().asEigen();
  return mount;
}

std::string take_scan(mrpt::obs::CObservation& observation,
                      const RotatingScanParameters& parameters, ldm::Scan& scan) {
  scan.points.clear();
  scan.no_returns.clear();
  if (auto* velodyne = dynamic_cast<CObservationVelodyneScan*>(&observation)) {
    return take(*velodyne, scan);
  }
  if (const auto* cloud = dynamic_cast<const CObservationPointCloud*>(&observation)) {
    return take(*cloud, scan);
  }
  return take(dynamic_cast<const CObservationRotatingScan&>(observation), parameters, scan);
}

}  // namespace datasets
