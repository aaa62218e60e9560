/// The studies that docs/studies.md shows can be run as they are.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "experiments/study/study.h"
#include "tests/source_folder.h"
#include "tests/temporary_folder.h"

namespace experiments {
namespace {

/// The contents of the blocks ```toml ... ``` in a text.
std::vector<std::string> toml_blocks(const std::string& text) {
  static const std::string kBegin = "```toml\n";
  std::vector<std::string> blocks;
  for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
    at += kBegin.size();
    blocks.push_back(text.substr(at, text.find("```", at) - at));
  }
  return blocks;
}

TEST(DocumentedStudies, AreGood) {
  std::ostringstream text;
  text << std::ifstream(tests::source_folder() / "docs/studies.md").rdbuf();
  const std::vector<std::string> shown = toml_blocks(text.str());
  ASSERT_EQ(shown.size(), 2u);

  const DataFolders shipped{tests::source_folder().string()};
  const tests::TemporaryFolder folder;
  const Study sweep = read_study(folder.write("sweep.toml", shown[0]), shipped.scenarios);
  EXPECT_EQ(sweep.points.size(), 3u * 4u * 2u);
  const Study ablation = read_study(folder.write("ablation.toml", shown[1]), shipped.scenarios);
  EXPECT_EQ(ablation.entrants.back().name, "no_survival");
}

}  // namespace
}  // namespace experiments
