/// TOML files: typed values, order of the file, and one clear line for each way to be wrong.
#include "datasets/files/toml_reader.h"

#include <gtest/gtest.h>

#include "ldm/types.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

constexpr std::string_view kText = R"(title = "two words"
count = 3
share = 0.25
enabled = true
[zebra]
words = ["b", "a"]
"particles.count" = [1000, 2000]
sizes = [[32, 32, 32], [64, 64, 16]]
[apple]
kind = "round"
limits = [0.5, 2]
[apple.core]
seeds = 7
[[row]]
x = 1
[[row]]
x = 2
)";

class TomlReaderTest : public testing::Test {
 protected:
  /// The message of the error that `action` meets, without the name of the file.
  template <class Action>
  std::string error(Action&& action) {
    const std::string message = tests::message_of<ldm::InvalidInput>(action);
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_EQ(message.rfind(file_.name(), 0), 0u) << message;
    return message.substr(std::min(message.size(), file_.name().size()));
  }

  tests::TextFile file_{"toml_reader.toml", kText};
  TomlTable table_ = TomlTable::open(file_.path());
};

TEST_F(TomlReaderTest, ReadsValuesOfEveryType) {
  EXPECT_EQ(table_.text("title"), "two words");
  EXPECT_EQ(table_.integer("count"), 3);
  EXPECT_EQ(table_.number("count"), 3.0);
  EXPECT_EQ(table_.number("share", {0, 1}), 0.25);
  EXPECT_TRUE(table_.boolean("enabled"));
  EXPECT_EQ(table_.table("zebra").texts("words"), (std::vector<std::string>{"b", "a"}));
  EXPECT_EQ(table_.table("apple").numbers("limits"), (std::vector<double>{0.5, 2}));
  constexpr std::string_view kKinds[] = {"flat", "round"};
  EXPECT_EQ(table_.table("apple").choice("kind", kKinds), 1u);
  ASSERT_EQ(table_.tables("row").size(), 2u);
  EXPECT_EQ(table_.tables("row")[1].integer("x"), 2);
  EXPECT_TRUE(table_.tables("column").empty());
}

TEST_F(TomlReaderTest, FallbackStandsForAMissingKeyAlone) {
  EXPECT_EQ(table_.number("mass", {0, 1}, 0.5), 0.5);
  EXPECT_EQ(table_.integer("number", {}, 4), 4);
  EXPECT_EQ(table_.text("name", "none"), "none");
  EXPECT_FALSE(table_.boolean("flag", false));
  EXPECT_THROW(table_.number("count", {0, 1}, 0.5), ldm::InvalidInput);
}

TEST_F(TomlReaderTest, KeepsTheOrderOfTheFile) {
  EXPECT_EQ(table_.keys(), (std::vector<std::string>{"title", "count", "share", "enabled", "zebra",
                                                     "apple", "row"}));
}

TEST_F(TomlReaderTest, GivesAnyValueAsText) {
  EXPECT_EQ(table_.value_text("share"), "0.25");
  EXPECT_EQ(table_.value_text("enabled"), "true");
  EXPECT_TRUE(table_.is_table("zebra"));
  EXPECT_FALSE(table_.is_table("share"));
  const TomlTable zebra = table_.table("zebra");
  EXPECT_EQ(zebra.value_texts("particles.count"), (std::vector<std::string>{"1000", "2000"}));
  EXPECT_EQ(zebra.value_texts("sizes"), (std::vector<std::string>{"32,32,32", "64,64,16"}));
  EXPECT_EQ(table_.value_texts("count"), (std::vector<std::string>{"3"}));
}

TEST_F(TomlReaderTest, FlattensTables) {
  const auto leaves = table_.table("apple").leaves();
  ASSERT_EQ(leaves.size(), 3u);
  EXPECT_EQ(leaves[0].name, "kind");
  EXPECT_TRUE(leaves[0].is_text);
  EXPECT_EQ(leaves[1].value, "0.5,2");
  EXPECT_FALSE(leaves[1].is_text);
  EXPECT_EQ(leaves[2].name, "core.seeds");
  EXPECT_EQ(leaves[2].place, file_.name() + ":13");
  EXPECT_EQ(error([&] { table_.leaves(); }),
            ":14: row = [{...}, {...}]: allowed: a value, not a list of tables");
}

TEST_F(TomlReaderTest, NamesWrongTypes) {
  EXPECT_EQ(error([&] { table_.number("title"); }), ":1: title = \"two words\": allowed: a number");
  EXPECT_EQ(error([&] { table_.integer("share"); }), ":3: share = 0.25: allowed: an integer");
  EXPECT_EQ(error([&] { table_.boolean("count"); }), ":2: count = 3: allowed: true or false");
  EXPECT_EQ(error([&] { table_.text("count"); }), ":2: count = 3: allowed: text");
  EXPECT_EQ(error([&] { table_.table("count"); }), ":2: count = 3: allowed: a table");
  EXPECT_EQ(error([&] { table_.tables("count"); }), ":2: count = 3: allowed: a list of tables");
  EXPECT_EQ(error([&] { table_.value_text("zebra"); }),
            ":5: zebra = {...}: allowed: a value, not a table");
  EXPECT_EQ(error([&] { table_.table("zebra").numbers("words"); }),
            ":6: zebra.words[1] = \"b\": allowed: a number");
  EXPECT_EQ(error([&] { table_.table("apple").texts("limits"); }),
            ":11: apple.limits[1] = 0.5: allowed: text");
}

TEST_F(TomlReaderTest, NamesValuesOutOfRange) {
  EXPECT_EQ(error([&] {
              table_.number("share", {0.5, 1});
            }),
            ":3: share = 0.25: allowed: a number in [0.5, 1]");
  EXPECT_EQ(error([&] { table_.integer("count", {.min = 4}); }),
            ":2: count = 3: allowed: an integer, at least 4");
  EXPECT_EQ(error([&] { table_.integer("count", {.max = 2}); }),
            ":2: count = 3: allowed: an integer, at most 2");
  const TomlTable apple = table_.table("apple");
  EXPECT_EQ(error([&] {
              apple.numbers("limits", {0, 1});
            }),
            ":11: apple.limits[2] = 2: allowed: a number in [0, 1]");
  EXPECT_EQ(error([&] {
              apple.numbers("limits", {}, {3, 3});
            }),
            ":11: apple.limits = [0.5, 2]: allowed: list of numbers; length: an integer in [3, 3]");
  constexpr std::string_view kKinds[] = {"flat", "square"};
  EXPECT_EQ(error([&] { apple.choice("kind", kKinds); }),
            ":10: apple.kind = \"round\": allowed: one of flat, square");
  EXPECT_EQ(error([&] { table_.reject("count", "an even number"); }),
            ":2: count = 3: allowed: an even number");
}

TEST_F(TomlReaderTest, NamesMissingKeys) {
  EXPECT_EQ(error([&] {
              table_.number("mass", {0, 1});
            }),
            ":1: mass is missing: allowed: a number in [0, 1]");
  EXPECT_EQ(error([&] { table_.table("apple").table("core").text("colour"); }),
            ":12: apple.core.colour is missing: allowed: text");
}

TEST_F(TomlReaderTest, NamesUnknownKeys) {
  for (const char* key : {"title", "count", "share", "enabled", "row", "zebra"}) table_.has(key);
  EXPECT_EQ(error([&] { table_.reject_unknown_keys(); }),
            ":6: zebra.words = [\"b\", \"a\"]: unknown key: allowed: ");
  table_.table("zebra").leaves();
  EXPECT_EQ(error([&] { table_.reject_unknown_keys(); }),
            ":9: apple = {...}: unknown key: allowed: count, enabled, row, share, title, zebra");
  table_.table("apple").leaves();
  for (const TomlTable& row : table_.tables("row")) row.integer("x");
  EXPECT_NO_THROW(table_.reject_unknown_keys());
}

TEST(TomlFileTest, NamesFilesThatCannotBeRead) {
  const std::string missing = "/nonexistent/file.toml";
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { TomlTable::open(missing); }),
            missing + ": cannot be read: allowed: a readable TOML file");
  const std::string folder = std::filesystem::temp_directory_path().string();
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] { TomlTable::open(folder); }),
            folder + ": cannot be read: allowed: a readable TOML file");
}

TEST(TomlFileTest, NamesThePlaceOfBrokenSyntax) {
  const tests::TextFile truncated("truncated.toml", "a = 1\nb = [1, 2");
  EXPECT_EQ(tests::message_of<ldm::InvalidInput>([&] {
              TomlTable::open(truncated.path());
            }).rfind(truncated.name() + ":2: not TOML: ", 0),
            0u);
  const tests::TextFile binary("binary.toml", "a = 1\n\xff\xfe\x01");
  EXPECT_THROW(TomlTable::open(binary.path()), ldm::InvalidInput);
  const tests::TextFile dated("dated.toml", "day = 2021-03-01");
  EXPECT_THROW(TomlTable::open(dated.path()), ldm::InvalidInput);
}

TEST(TomlFileTest, AnEmptyFileIsAnEmptyTable) {
  const tests::TextFile empty("empty.toml", "");
  EXPECT_TRUE(TomlTable::open(empty.path()).keys().empty());
}

TEST(TomlFileTest, RefusesNumbersThatAreNotFinite) {
  const tests::TextFile file("infinite.toml", "a = inf\nb = nan\n");
  const TomlTable table = TomlTable::open(file.path());
  EXPECT_THROW(table.number("a"), ldm::InvalidInput);
  EXPECT_THROW(table.number("b"), ldm::InvalidInput);
}

}  // namespace
}  // namespace datasets
