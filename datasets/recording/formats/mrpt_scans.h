#pragma once
/// Scans of foreign MRPT logs as points (no paper section).
#include <string>
#include <vector>

#include "datasets/recording/scans/input_parameters.h"
#include "ldm/types.h"

namespace mrpt::obs {
class CObservation;
}

namespace datasets {

/// True for CObservationVelodyneScan, CObservationPointCloud and CObservationRotatingScan.
bool is_scan(const mrpt::obs::CObservation& observation);

/// T_uav_sensor as the observation has it.
ldm::Pose mount_in(const mrpt::obs::CObservation& observation);

/// Fills `scan.points` and `scan.no_returns`; requires is_scan. What MRPT computes from Velodyne's
/// packets is taken as it is; a rotating scan has only ranges and azimuths, its elevations are
/// those of the model it names, VLP-16 or HDL-32E, or input.rotating.*.
/// @return an empty text, or why the observation cannot be used
std::string take_scan(mrpt::obs::CObservation& observation,
                      const RotatingScanParameters& parameters, ldm::Scan& scan);

}  // namespace datasets
