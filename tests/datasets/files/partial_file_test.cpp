#include "datasets/files/partial_file.h"

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"

namespace datasets {
namespace {

std::size_t files_in(const std::filesystem::path& folder) {
  const std::filesystem::directory_iterator begin(folder), end;
  return static_cast<std::size_t>(std::distance(begin, end));
}

TEST(PartialFile, HasItsNameOnlyOnceCommitted) {
  const tests::TemporaryFolder folder;
  PartialFile file(folder.path() / "a.txt");
  file.stream() << "whole";
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.txt"));
  file.commit();
  EXPECT_EQ(folder.read("a.txt"), "whole");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(PartialFile, WithoutCommitLeavesTheOldFileAndNothingElse) {
  const tests::TemporaryFolder folder;
  folder.write("a.txt", "old");
  { PartialFile(folder.path() / "a.txt").stream() << "new"; }
  EXPECT_EQ(folder.read("a.txt"), "old");
  EXPECT_EQ(files_in(folder.path()), 1u);
}

TEST(PartialFile, RefusesAMissingFolderAndAFolderAsName) {
  const tests::TemporaryFolder folder;
  EXPECT_NE(tests::message_of([&] {
              PartialFile(folder.path() / "none" / "a.txt");
            }).find("a.txt: cannot be written (No such file or directory)"),
            std::string::npos);
  EXPECT_NE(tests::message_of([&] { PartialFile{folder.path()}; }).find("is a folder"),
            std::string::npos);
}

}  // namespace
}  // namespace datasets
