#pragma once
/// A flight as a film: the UAV, what it knows, what it plans, and where it has flown
/// (docs/avoidance.md).
#include <filesystem>
#include <string>
#include <vector>

#include "experiments/avoidance/flight.h"
#include "experiments/pictures/cluster_colours.h"
#include "experiments/pictures/picture.h"
#include "experiments/pictures/video_file.h"

namespace experiments {

/// A picture for each scan, at the rate of the LiDAR.
class FlightFilm {
 public:
  /// @param heading first line of every picture
  /// @throws ldm::InvalidInput unless the file ends in `.mp4`, can be written, and there is ffmpeg
  FlightFilm(const std::filesystem::path& file, std::string heading, const FlightTask& task);

  /// The next scan, and what is known after it.
  /// @throws std::runtime_error if nothing can be drawn, or ffmpeg has ended
  void add(const FlightMoment& moment, const ldm::LocalMap& map);

  /// Show the last picture for a second more, with how the flight ended, and complete the file.
  /// Requires at least one picture.
  /// @throws std::runtime_error if ffmpeg failed
  void finish(const std::string& ending);

 private:
  std::string heading_;
  double knot_step_, rate_;
  VideoFile video_;
  ClusterColours colours_;
  std::vector<Eigen::Vector3d> flown_;  ///< at each scan, world [m]
  Picture picture_;
};

}  // namespace experiments
