#pragma once
/// The tables of nuScenes, which hold the poses of its scans (Caesar et al., CVPR 2020; no paper
/// section).
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ldm/types.h"

namespace datasets {

struct NuscenesPoses {
  std::vector<std::optional<ldm::Pose>> T_world_vehicle;  ///< of each scan; none if no table has it
  ldm::Pose T_vehicle_sensor;
};

/// The folder of the tables that belong to a folder of scans: v1.0-NAME in it, or beside `samples`
/// and `sweeps` around it; none if it has no tables.
/// @throws ldm::InvalidInput if there are several.
std::optional<std::filesystem::path> nuscenes_tables(const std::filesystem::path& scans);

/// Reads sample_data.json, ego_pose.json and calibrated_sensor.json row by row; memory grows with
/// the scans, not with the tables.
/// @param names of the scans' files
/// @throws ldm::InvalidInput if a table cannot be read, is no table, or its poses are none; if no
///   row is of these scans; if their sensor sits in several places.
NuscenesPoses read_nuscenes_poses(const std::filesystem::path& tables,
                                  const std::vector<std::string>& names);

}  // namespace datasets
