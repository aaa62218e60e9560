#pragma once
/// `ldm fly`: one flight, with its log (docs/avoidance.md).
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "experiments/method/data_folders.h"

namespace experiments {

struct FlyRequest {
  std::string arm;
  std::string world;
  std::uint64_t seed = 1;
  std::vector<std::string> settings;           ///< name=value
  std::filesystem::path output;                ///< folder, made if it is missing
  std::optional<std::filesystem::path> video;  ///< FILE.mp4
  std::string command;
};

/// Fly, write flight.csv, obstacles.csv, plans.csv and summary.json, and print how it ended. With a
/// film it takes about 0.3 s more for each scan.
/// @throws ldm::InvalidInput on a bad arm, world, setting or name of the film
void fly(const FlyRequest& request, const DataFolders& folders, std::ostream& out);

}  // namespace experiments
