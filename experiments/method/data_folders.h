#pragma once
/// Where scenarios and studies lie, and their files by name (no paper section).
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace experiments {

/// TOML files of one kind.
struct DataFolder {
  std::string kind;  ///< "scenario", "world", "study" or "preset", for messages
  std::filesystem::path path;

  /// Names without `.toml`, sorted.
  /// @throws ldm::InvalidInput if there is no such folder.
  std::vector<std::string> names() const;
  /// The file of a name; a text that ends in `.toml` is the file itself.
  /// @throws ldm::InvalidInput if it does not exist, listing the known names.
  std::filesystem::path file(std::string_view name) const;
};

struct DataFolders {
  /// @param root folder that holds `datasets/scenarios`, `datasets/corridors`, `datasets/presets`
  /// and `experiments/studies`; by default LDM_DATA_DIR of the environment, without that what was
  /// installed beside the program, and without that the source tree of the build.
  explicit DataFolders(const std::optional<std::string>& root);

  DataFolder scenarios;
  DataFolder corridors;  ///< worlds to fly through
  DataFolder presets;    ///< parameter files by name, as in `-c road`
  DataFolder studies;
};

}  // namespace experiments
