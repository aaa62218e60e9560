#include "datasets/files/toml_limits.h"

#include <gtest/gtest.h>

#include "datasets/files/toml_reader.h"
#include "ldm/types.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

std::string repeated(std::string_view text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// What is said of a text; empty if it is within the limits.
std::string said_of(const std::string& text) {
  try {
    check_toml_limits(text, "a.toml");
  } catch (const ldm::InvalidInput& error) {
    return error.what();
  }
  return "";
}

TEST(TomlLimits, BoundTheDepthOfKeysAndValues) {
  const std::string parts = repeated("a.", 49999) + "a";
  const std::string of_keys = ": more than 32 parts of a key: allowed: at most 32";
  const std::string of_brackets = ": more than 32 brackets: allowed: at most 32";
  EXPECT_EQ(said_of("[" + parts + "]\n"), "a.toml:1" + of_keys);
  EXPECT_EQ(said_of("x = 1\n" + parts + " = 1\n"), "a.toml:2" + of_keys);
  EXPECT_EQ(said_of("x = 1 # it\n\ny = {" + repeated("\"a\" . ", 40) + "b = 1}\n"),
            "a.toml:3" + of_keys);
  EXPECT_EQ(said_of("x = " + repeated("[", 33)), "a.toml:1" + of_brackets);
  EXPECT_EQ(said_of("x = '''\n'''\ny = " + repeated("{a=", 100)), "a.toml:3" + of_brackets);
  EXPECT_EQ(said_of("[" + repeated("a.", 31) + "a]\n"), "");
}

TEST(TomlLimits, SayNothingOfStringsCommentsAndLongLists) {
  const std::string dots(100, '.'), open(100, '[');
  EXPECT_EQ(said_of("# " + dots + open + "\nx = 1\n"), "");
  EXPECT_EQ(said_of("x = \"" + dots + "\\\"" + open + "\"\n"), "");
  EXPECT_EQ(said_of("x = \"\"\"\n" + dots + "\n\"" + open + "\\\n\"\"\"\n"), "");
  EXPECT_EQ(said_of("x = '" + dots + "\\'\ny = 2\n"), "");
  EXPECT_EQ(said_of("x = [" + repeated("1.5, ", 1000) + "2.0]\n"), "");
  EXPECT_EQ(said_of("x = [" + repeated("[1.5], ", 1000) + "]\n"), "");
  EXPECT_EQ(said_of("x = \"no end"), "");
}

TEST(TomlLimits, BoundTheLength) {
  EXPECT_EQ(said_of(std::string(kMostTomlBytes + 1, '\n')),
            "a.toml: 16777217 bytes: allowed: at most 16777216");
}

TEST(TomlLimits, HoldForEveryFile) {
  const tests::TextFile file("deep.toml", "[" + repeated("a.", 49999) + "a]\n");
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { TomlTable::open(file.path()); }),
            file.name() + ":1: more than 32 parts of a key: allowed: at most 32");
}

}  // namespace
}  // namespace datasets
