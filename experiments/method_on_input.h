#pragma once
/// What the commands `run` and `render` have in common: a method with its parameters, and the
/// frames it is given (no paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/frame.h"
#include "experiments/data_folders.h"
#include "experiments/methods.h"

namespace experiments {

struct MethodOnInput {
  std::string method;
  std::string input;                            ///< scenario (name or .toml) or .rawlog file
  std::optional<std::filesystem::path> config;  ///< parameter file
  std::vector<std::string> settings;            ///< name=value, stronger than the file
  std::optional<std::uint64_t> seed;            ///< of the scenario's world (default 1)

  bool is_log() const { return input.ends_with(".rawlog"); }
};

/// The method's defaults, file and settings applied. Threads: all cores, unless set.
/// @throws ldm::InvalidInput on a bad file or setting.
ldm::Parameters parameters_of(const MethodOnInput& request, const Method& method);

/// @param frames of a scenario: stop after so many
/// @throws ldm::InvalidInput if there is no such scenario or log, or on a log with a seed.
std::unique_ptr<datasets::FrameSource> open_input(const MethodOnInput& request,
                                                  const DataFolders& folders,
                                                  std::optional<std::int64_t> frames = {});

}  // namespace experiments
