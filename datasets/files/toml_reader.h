#pragma once
/// Configuration files: typed, checked reading of TOML; errors carry file and line (no paper
/// section).
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

struct TomlNode;

/// Closed interval of allowed values.
template <class T>
struct Allowed {
  T min = std::numeric_limits<T>::lowest();
  T max = std::numeric_limits<T>::max();
};
using Numbers = Allowed<double>;
using Integers = Allowed<std::int64_t>;

/// For messages: `what in [min, max]`, or with the one bound there is.
std::string within(std::string_view what, Numbers allowed);
std::string within(std::string_view what, Integers allowed);
/// For messages: `one of this, that`.
std::string one_of(std::span<const std::string_view> words);

/// A table of a TOML file. Copies are cheap and share the file and the record of keys read.
///
/// Every reader throws `ldm::InvalidInput` with the one line
/// `file:line: section.key = value: allowed: ...` where the value has another type or lies out of
/// range, and, if no `fallback` is given, where the key is missing.
class TomlTable {
 public:
  /// @throws ldm::InvalidInput if the file cannot be read or is no TOML.
  static TomlTable open(const std::filesystem::path& file);

  bool has(std::string_view key) const;
  /// Keys in the order of the file.
  std::vector<std::string> keys() const;
  bool is_table(std::string_view key) const;

  /// Finite number; an integer is one too.
  double number(std::string_view key, Numbers allowed = {},
                std::optional<double> fallback = {}) const;
  std::int64_t integer(std::string_view key, Integers allowed = {},
                       std::optional<std::int64_t> fallback = {}) const;
  bool boolean(std::string_view key, std::optional<bool> fallback = {}) const;
  std::string text(std::string_view key, std::optional<std::string> fallback = {}) const;
  /// Position of the value in `words`.
  std::size_t choice(std::string_view key, std::span<const std::string_view> words,
                     std::optional<std::size_t> fallback = {}) const;
  /// Number of elements within `length`.
  std::vector<double> numbers(std::string_view key, Numbers allowed = {},
                              Integers length = {}) const;
  std::vector<std::string> texts(std::string_view key, Integers length = {}) const;

  /// The value as text, whatever its type: a number (shortest form that reads back to the same
  /// bits), `true`, a word, or `32,32,32` for a list. Tables are refused.
  std::string value_text(std::string_view key) const;
  /// The elements of a list, each as `value_text` would give it; one element for a plain value.
  std::vector<std::string> value_texts(std::string_view key) const;

  /// A nested table; it must exist (ask `has` first where it may be left out).
  TomlTable table(std::string_view key) const;
  /// The tables of `[[key]]`, in order; empty if there is none.
  std::vector<TomlTable> tables(std::string_view key) const;

  /// A key and its value, with tables flattened: `section.key`.
  struct Leaf {
    std::string name;   ///< relative to this table
    std::string value;  ///< as `value_text` gives it
    std::string place;  ///< `file:line`
    bool is_text;       ///< a text in quotes, or a list with one
  };
  /// Every value below this table in the order of the file; all count as read.
  /// @throws ldm::InvalidInput on an array of tables.
  std::vector<Leaf> leaves() const;

  /// `file:line` of a key, or of the table's beginning if there is no such key.
  std::string place(std::string_view key = {}) const;
  /// For a value that the caller finds wrong: throws the line above with `allowed` at its end.
  [[noreturn]] void reject(std::string_view key, std::string_view allowed) const;
  /// @throws ldm::InvalidInput naming the first key in this table and those below that no reader
  /// asked for, and the keys that were asked for beside it.
  void reject_unknown_keys() const;

 private:
  explicit TomlTable(std::shared_ptr<const TomlNode> node);

  /// The value of that key, which counts as asked for; null if it is missing.
  const TomlNode* find(std::string_view key) const;
  /// The same; throws with `allowed` if it is missing.
  const TomlNode& require(std::string_view key, std::string_view allowed) const;
  const TomlNode& require_list(std::string_view key, Integers length, std::string_view of) const;

  std::shared_ptr<const TomlNode> node_;  ///< shares the ownership of the whole file
};

}  // namespace datasets
