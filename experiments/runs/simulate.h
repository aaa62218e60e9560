#pragma once
/// `ldm simulate`: a scenario as a recorded log (no paper section).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "experiments/method/data_folders.h"

namespace experiments {

struct SimulateRequest {
  std::string scenario;  ///< name, or its .toml file
  std::uint64_t seed = 1;
  std::vector<std::string> settings;   ///< scenario.NAME=VALUE
  std::optional<std::int64_t> frames;  ///< default: the scenario's
  std::filesystem::path output;        ///< FILE.rawlog
};

/// @throws ldm::InvalidInput on a bad request.
void simulate(const SimulateRequest& request, const DataFolders& folders);

}  // namespace experiments
