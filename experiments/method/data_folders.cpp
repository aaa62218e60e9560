#include "experiments/method/data_folders.h"

#include <algorithm>
#include <cstdlib>

#include "datasets/files/text.h"
#include "ldm/types.h"

namespace experiments {
namespace {

namespace fs = std::filesystem;

fs::path root_folder(const std::optional<std::string>& root) {
  if (root) return *root;
  if (const char* environment = std::getenv("LDM_DATA_DIR")) return environment;
  // Installed, the program lies in bin/ and its data in share/ldm/.
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path installed = program.parent_path().parent_path() / "share" / "ldm";
  return fs::is_directory(installed) ? installed : fs::path(LDM_SOURCE_DIR);
}

}  // namespace

std::vector<std::string> DataFolder::names() const {
  std::error_code error;
  std::vector<std::string> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error)) {
    if (entry.path().extension() == ".toml") result.push_back(entry.path().stem().string());
  }
  if (error) {
    throw ldm::InvalidInput(path.string() + ": cannot be read (" + error.message() +
                            "): allowed: a folder of " + kind + " files");
  }
  std::sort(result.begin(), result.end());
  return result;
}

fs::path DataFolder::file(std::string_view name) const {
  const fs::path file =
      name.ends_with(".toml") ? fs::path(name) : path / (std::string(name) + ".toml");
  if (fs::is_regular_file(file)) return file;
  const std::vector<std::string> known = names();
  throw ldm::InvalidInput("unknown " + kind + " " + std::string(name) +
                          ": allowed: a .toml file, " + datasets::joined(known) +
                          datasets::did_you_mean(name, known));
}

DataFolders::DataFolders(const std::optional<std::string>& root)
    : scenarios{"scenario", root_folder(root) / "datasets" / "scenarios"},
      corridors{"world", root_folder(root) / "datasets" / "corridors"},
      presets{"preset", root_folder(root) / "datasets" / "presets"},
      studies{"study", root_folder(root) / "experiments" / "studies"} {}

}  // namespace experiments
