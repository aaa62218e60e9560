#pragma once
/// Points of Velodyne's packets (no paper section; manuals of VLP-16, HDL-32E and HDL-64E).
/// MRPT 2.5 takes but the first 16 of the 32 returns of a block: half of the points.
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <vector>

#include "ldm/types.h"

namespace datasets {

struct VelodynePoint {
  ldm::Point point;    ///< sensor frame [m]
  double azimuth = 0;  ///< when it was fired, clockwise from the front [deg]
};

/// Appends the points of a packet in the order in which they were measured, but for returns of 0.
/// Both returns of a dual packet are points, those of one block after those of the other.
/// @param calibration of 16, 32 or 64 lasers
/// @return false, and nothing is appended, if the packet is none of such a sensor
bool take_velodyne_points(const mrpt::obs::CObservationVelodyneScan::TVelodyneRawPacket& packet,
                          const mrpt::obs::VelodyneCalibration& calibration,
                          std::vector<VelodynePoint>& points);

}  // namespace datasets
