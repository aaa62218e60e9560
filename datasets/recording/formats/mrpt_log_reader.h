#pragma once
/// Foreign logs in MRPT's rawlog format (no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// Scans are CObservationVelodyneScan, CObservationPointCloud or CObservationRotatingScan: those of
/// the class and label of the first one, others are counted. Poses are CObservationRobotPose, or
/// CObservationOdometry if input.poses = odometry: those of the first label, interpolated at the
/// time of each scan. Both may stand alone or in sensory frames. Memory holds the scans that wait
/// for their pose, 64 at most.
/// @throws ldm::InvalidInput if the log cannot be read, or it is told poses or times it has itself.
std::unique_ptr<ScanReader> open_mrpt_log(const std::filesystem::path& rawlog,
                                          const RecordingOptions& options);

}  // namespace datasets
