#include "datasets/files/toml_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "datasets/files/text.h"
#include "datasets/files/toml_node.h"
#include "ldm/types.h"

namespace datasets {
namespace {

std::string shown(double bound) {
  return decimal(bound);
}
std::string shown(std::int64_t bound) {
  return std::to_string(bound);
}

template <class T>
std::string bounded(std::string_view what, Allowed<T> allowed) {
  const bool from = allowed.min != Allowed<T>{}.min;
  const bool to = allowed.max != Allowed<T>{}.max;
  std::string text(what);
  if (from && to) return text + " in [" + shown(allowed.min) + ", " + shown(allowed.max) + "]";
  if (from) return text + ", at least " + shown(allowed.min);
  if (to) return text + ", at most " + shown(allowed.max);
  return text;
}

template <class T>
bool contains(Allowed<T> allowed, T value) {
  return value >= allowed.min && value <= allowed.max;
}

double checked_number(const TomlNode& node, Numbers allowed) {
  if (!node.is_number() || !std::isfinite(node.number) || !contains(allowed, node.number)) {
    node.reject(within("a number", allowed));
  }
  return node.number;
}

const std::string& checked_text(const TomlNode& node) {
  if (node.type != TomlNode::Type::kText) node.reject("text");
  return node.text;
}

/// Depth first, so that the values come in the order of the file.
void collect_leaves(const TomlNode& table, const std::string& prefix,
                    std::vector<TomlTable::Leaf>& leaves) {
  for (const auto& child : table.children) {
    table.asked.insert(child->key);
    const std::string name = prefix + child->key;
    if (child->is_table()) {
      collect_leaves(*child, name + '.', leaves);
    } else if (child->has_table()) {
      child->reject("a value, not a list of tables");
    } else {
      leaves.push_back({name, child->flat(), child->place, child->has_text()});
    }
  }
}

void reject_unasked(const TomlNode& node) {
  for (const auto& child : node.children) {
    if (node.is_table() && !node.asked.contains(child->key)) {
      throw ldm::InvalidInput(
          child->place + ": " + child->path + " = " + child->shown() +
          ": unknown key: allowed: " + joined(node.asked) +
          did_you_mean(child->key, std::vector<std::string>(node.asked.begin(), node.asked.end())));
    }
    reject_unasked(*child);
  }
}

}  // namespace

std::string within(std::string_view what, Numbers allowed) {
  return bounded(what, allowed);
}
std::string within(std::string_view what, Integers allowed) {
  return bounded(what, allowed);
}

std::string one_of(std::span<const std::string_view> words) {
  return "one of " + joined(words);
}

TomlTable::TomlTable(std::shared_ptr<const TomlNode> node) : node_(std::move(node)) {}

TomlTable TomlTable::open(const std::filesystem::path& file) {
  return TomlTable(read_toml(file));
}

const TomlNode* TomlTable::find(std::string_view key) const {
  node_->asked.emplace(key);
  for (const auto& child : node_->children) {
    if (child->key == key) return child.get();
  }
  return nullptr;
}

const TomlNode& TomlTable::require(std::string_view key, std::string_view allowed) const {
  if (const TomlNode* node = find(key)) return *node;
  throw ldm::InvalidInput(place() + ": " + node_->path + (node_->path.empty() ? "" : ".") +
                          std::string(key) + " is missing: allowed: " + std::string(allowed));
}

const TomlNode& TomlTable::require_list(std::string_view key, Integers length,
                                        std::string_view of) const {
  const std::string wanted = "list of " + std::string(of) + within("; length: an integer", length);
  const TomlNode& node = require(key, wanted);
  const auto size = static_cast<std::int64_t>(node.children.size());
  if (!node.is_list() || !contains(length, size)) node.reject(wanted);
  return node;
}

bool TomlTable::has(std::string_view key) const {
  return find(key) != nullptr;
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> result;
  for (const auto& child : node_->children) result.push_back(child->key);
  return result;
}

bool TomlTable::is_table(std::string_view key) const {
  const TomlNode* node = find(key);
  return node != nullptr && node->is_table();
}

double TomlTable::number(std::string_view key, Numbers allowed,
                         std::optional<double> fallback) const {
  if (fallback && !has(key)) return *fallback;
  return checked_number(require(key, within("a number", allowed)), allowed);
}

std::int64_t TomlTable::integer(std::string_view key, Integers allowed,
                                std::optional<std::int64_t> fallback) const {
  if (fallback && !has(key)) return *fallback;
  const std::string wanted = within("an integer", allowed);
  const TomlNode& node = require(key, wanted);
  if (node.type != TomlNode::Type::kInteger || !contains(allowed, node.integer)) {
    node.reject(wanted);
  }
  return node.integer;
}

bool TomlTable::boolean(std::string_view key, std::optional<bool> fallback) const {
  if (fallback && !has(key)) return *fallback;
  const TomlNode& node = require(key, "true or false");
  if (node.type != TomlNode::Type::kBoolean) node.reject("true or false");
  return node.integer != 0;
}

std::string TomlTable::text(std::string_view key, std::optional<std::string> fallback) const {
  if (fallback && !has(key)) return *fallback;
  return checked_text(require(key, "text"));
}

std::size_t TomlTable::choice(std::string_view key, std::span<const std::string_view> words,
                              std::optional<std::size_t> fallback) const {
  if (fallback && !has(key)) return *fallback;
  const std::string wanted = one_of(words);
  const TomlNode& node = require(key, wanted);
  const auto word = std::find(words.begin(), words.end(), node.text);
  if (node.type != TomlNode::Type::kText || word == words.end()) node.reject(wanted);
  return static_cast<std::size_t>(word - words.begin());
}

std::vector<double> TomlTable::numbers(std::string_view key, Numbers allowed,
                                       Integers length) const {
  std::vector<double> result;
  for (const auto& child : require_list(key, length, within("numbers", allowed)).children) {
    result.push_back(checked_number(*child, allowed));
  }
  return result;
}

std::vector<std::string> TomlTable::texts(std::string_view key, Integers length) const {
  std::vector<std::string> result;
  for (const auto& child : require_list(key, length, "texts").children) {
    result.push_back(checked_text(*child));
  }
  return result;
}

std::string TomlTable::value_text(std::string_view key) const {
  const TomlNode& node = require(key, "a value");
  if (node.has_table()) node.reject("a value, not a table");
  return node.flat();
}

std::vector<std::string> TomlTable::value_texts(std::string_view key) const {
  const TomlNode& node = require(key, "a value or a list of values");
  if (node.has_table()) node.reject("a value or a list of values, not a table");
  if (!node.is_list()) return {node.text};
  std::vector<std::string> result;
  for (const auto& child : node.children) result.push_back(child->flat());
  return result;
}

TomlTable TomlTable::table(std::string_view key) const {
  const TomlNode& node = require(key, "a table");
  if (!node.is_table()) node.reject("a table");
  return TomlTable(std::shared_ptr<const TomlNode>(node_, &node));
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) const {
  const TomlNode* node = find(key);
  if (node == nullptr) return {};
  if (!node->is_list()) node->reject("a list of tables");
  std::vector<TomlTable> result;
  for (const auto& child : node->children) {
    if (!child->is_table()) child->reject("a table");
    result.push_back(TomlTable(std::shared_ptr<const TomlNode>(node_, child.get())));
  }
  return result;
}

std::vector<TomlTable::Leaf> TomlTable::leaves() const {
  std::vector<Leaf> result;
  collect_leaves(*node_, "", result);
  return result;
}

std::string TomlTable::place(std::string_view key) const {
  for (const auto& child : node_->children) {
    if (child->key == key) return child->place;
  }
  return node_->place;
}

void TomlTable::reject(std::string_view key, std::string_view allowed) const {
  require(key, allowed).reject(allowed);
}

void TomlTable::reject_unknown_keys() const {
  reject_unasked(*node_);
}

}  // namespace datasets
