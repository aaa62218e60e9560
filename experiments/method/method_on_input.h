#pragma once
/// What the commands that run a method have in common: its parameters, and the frames it is given
/// (no paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "datasets/frame.h"
#include "datasets/recording/scans/recording_options.h"
#include "experiments/method/data_folders.h"
#include "experiments/method/methods.h"

namespace experiments {

struct MethodOnInput {
  std::string method;
  std::string input;                  ///< scenario (name or .toml), or recording (file or folder)
  std::optional<std::string> config;  ///< parameter file, or name of a preset
  std::vector<std::string> settings;  ///< name=value of parameters and `scenario.` values
  std::optional<std::uint64_t> seed;  ///< of the scenario's world (default 1)
  std::optional<std::string> format;  ///< one of datasets::kRecordingFormatNames
  std::optional<std::string> time_unit;  ///< one of datasets::kTimeUnitNames
  datasets::RecordingOptions recording;  ///< all but what follows from the above

  /// A recording or a log of our own, not a scenario: a name that ends in .rawlog, a folder that
  /// holds a recording, any other path but a .toml file's, and whatever comes with a format.
  bool is_log() const;
  std::uint64_t world_seed() const { return seed.value_or(1); }
};

/// The method's defaults, file or preset, and settings applied. Threads: as many as pay, unless
/// set. What a preset says of parameters that the method does not use is left out.
/// @throws ldm::InvalidInput on a bad file or setting.
ldm::Parameters parameters_of(const MethodOnInput& request, const Method& method,
                              const DataFolders& folders);

/// Those of a recording, in the same way; none for a scenario or a log of our own.
/// @throws ldm::InvalidInput on a bad file or setting, and on one where there is no recording.
std::optional<datasets::InputParameters> input_parameters_of(const MethodOnInput& request,
                                                             const DataFolders& folders);

/// Those of the scenario (`scenario.NAME`), the file's before the command line's.
Settings scenario_settings_of(const MethodOnInput& request, const DataFolders& folders);

/// How a recording is to be read, by the words of the request and its input parameters.
/// @throws ldm::InvalidInput on a word that is none, a bad file or setting.
datasets::RecordingOptions recording_options_of(const MethodOnInput& request,
                                                const DataFolders& folders);

/// @param frames of a scenario: stop after so many
/// @throws ldm::InvalidInput if there is no such scenario or log, or on an option that is none of
/// its kind: a log with a seed or `scenario.` values, a scenario with --keep-going.
std::unique_ptr<datasets::FrameSource> open_input(const MethodOnInput& request,
                                                  const DataFolders& folders,
                                                  std::optional<std::int64_t> frames = {});

}  // namespace experiments
