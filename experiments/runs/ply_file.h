#pragma once
/// Voxels as a PLY file, which MeshLab, CloudCompare and PCL open (no paper section).
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "experiments/pictures/picture.h"

namespace experiments {

struct PlyVertex {
  ldm::Point position;  ///< [m]
  Colour colour;
  float occupancy = 0;     ///< P(Occ)
  std::int32_t track = 0;  ///< of the voxel's cluster; 0 in none
};

/// Little-endian binary PLY with the properties x, y, z, red, green, blue, occupancy, track.
/// @param comment a line for the file's header, or empty
void write_ply(const std::vector<PlyVertex>& vertices, const std::string& comment,
               std::ostream& out);

struct PlyFile {
  /// Of a comment `origin_m x y z`, else 0: the positions are relative to it. [m]
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::vector<PlyVertex> vertices;
};

/// @throws ldm::InvalidInput if the file cannot be read, or is none of `write_ply`.
PlyFile read_ply(const std::filesystem::path& file);

}  // namespace experiments
