#pragma once
/// Where the sources lie, for tests that read files of the repository.
#include <filesystem>

namespace tests {

/// The folder that holds `ldm/`, `datasets/`, `docs/`, ...
std::filesystem::path source_folder();

}  // namespace tests
