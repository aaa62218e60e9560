/// What fuzzers once tried, or once found, reads or is refused.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/fuzz/targets.h"
#include "tests/source_folder.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;

TEST(FuzzCorpus, EveryInputReadsOrIsRefused) {
  for (const auto& [name, target] : kTargets) {
    const fs::path corpus = tests::source_folder() / "tests/fuzz/corpus" / name;
    int inputs = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(corpus)) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
      EXPECT_NO_THROW(target(bytes)) << entry.path();
      ++inputs;
    }
    EXPECT_GT(inputs, 0) << corpus;
  }
}

}  // namespace
}  // namespace fuzz
