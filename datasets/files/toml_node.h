#pragma once
/// A TOML file in our own words: values with their place in the file (no paper section).
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

/// A value of the file; internal to TomlTable.
struct TomlNode {
  enum class Type { kTable, kList, kInteger, kNumber, kBoolean, kText };

  Type type = Type::kTable;
  std::string key;           ///< within the parent table
  std::string path;          ///< dotted, empty for the root
  std::string place;         ///< file:line
  std::string text;          ///< of a plain value: shortest decimal, `true`, or the text itself
  double number = 0;         ///< of a number or an integer
  std::int64_t integer = 0;  ///< of an integer; of a boolean 0 or 1
  std::vector<std::shared_ptr<const TomlNode>> children;  ///< of a table or list, in file order
  mutable std::set<std::string, std::less<>> asked;       ///< keys looked up in this table

  bool is_table() const { return type == Type::kTable; }
  bool is_list() const { return type == Type::kList; }
  bool is_number() const { return type == Type::kNumber || type == Type::kInteger; }
  /// It is a table or holds one at any depth.
  bool has_table() const;
  /// It is a text or a list with one.
  bool has_text() const;
  /// As it would stand in a file, for messages.
  std::string shown() const;
  /// `text`, or the elements of a list joined by commas.
  std::string flat() const;
  /// Throws ldm::InvalidInput: `file:line: path = value: allowed: ...`.
  [[noreturn]] void reject(std::string_view allowed) const;
};

/// @throws ldm::InvalidInput if the file cannot be read, is no TOML, holds a date or time, or is
/// longer or deeper than toml_limits.h allows.
std::shared_ptr<const TomlNode> read_toml(const std::filesystem::path& file);

}  // namespace datasets
