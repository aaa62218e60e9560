#pragma once
/// `ldm fly`: one flight, with its log (docs/avoidance.md).
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "experiments/method/data_folders.h"

namespace experiments {

struct FlyRequest {
  std::string arm;
  std::string world;
  std::uint64_t seed = 1;
  std::vector<std::string> settings;  ///< name=value
  std::filesystem::path output;       ///< folder, made if it is missing
  std::string command;
};

/// Fly, write flight.csv, obstacles.csv, plans.csv and summary.json, and print how it ended.
/// @throws ldm::InvalidInput on a bad arm, world or setting
void fly(const FlyRequest& request, const DataFolders& folders, std::ostream& out);

}  // namespace experiments
