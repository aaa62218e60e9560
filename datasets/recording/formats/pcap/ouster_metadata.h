#pragma once
/// What the JSON file beside a recording of an Ouster sensor says of it (no paper section).
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace datasets {

struct OusterMetadata {
  std::string product;             ///< `OS-1-128`
  std::string profile = "LEGACY";  ///< of its packets
  std::size_t rows = 0;            ///< pixels of a column
  std::size_t columns = 0;         ///< of a turn
  std::size_t columns_per_packet = 16;
  std::optional<std::uint16_t> port;        ///< that packets with points go to
  std::vector<double> altitudes, azimuths;  ///< of the beams, by row [deg]
  /// From where the beams begin to the middle of the turn, forward and up. [m]
  double beam_x = 0, beam_z = 0;
  Eigen::Isometry3d T_sensor_lidar = Eigen::Isometry3d::Identity();
};

/// Metadata of any firmware from 2.0 on: in the form of its time, or in that with sections.
/// @throws ldm::InvalidInput if it cannot be read, or what points need is missing or none.
OusterMetadata read_ouster_metadata(const std::filesystem::path& file);

/// True if the file may be such metadata: JSON with beams.
bool is_ouster_metadata(const std::filesystem::path& file);

}  // namespace datasets
