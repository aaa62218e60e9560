#include "datasets/files/toml_node.h"

#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <tuple>

#include "datasets/files/text.h"
#include "datasets/files/toml_limits.h"
#include "ldm/types.h"

namespace datasets {
namespace {

void take_value(const toml::node& source, TomlNode& node) {
  if (const auto* integer = source.as_integer()) {
    node.type = TomlNode::Type::kInteger;
    node.integer = integer->get();
    node.number = static_cast<double>(node.integer);
    node.text = std::to_string(node.integer);
  } else if (const auto* number = source.as_floating_point()) {
    node.type = TomlNode::Type::kNumber;
    node.number = number->get();
    node.text = decimal(node.number);
  } else if (const auto* boolean = source.as_boolean()) {
    node.type = TomlNode::Type::kBoolean;
    node.integer = boolean->get() ? 1 : 0;
    node.text = boolean->get() ? "true" : "false";
  } else if (const auto* text = source.as_string()) {
    node.type = TomlNode::Type::kText;
    node.text = text->get();
  } else {
    throw ldm::InvalidInput(
        node.place + ": " + node.path +
        " is a date or time: allowed: number, true or false, text, list, table");
  }
}

std::shared_ptr<const TomlNode> convert(const toml::node& source, std::string key, std::string path,
                                        const std::string& file);

/// The parser sorts tables by key; readers want the order of the file.
void take_table(const toml::table& table, const std::string& file, TomlNode& node) {
  using Entry = std::pair<std::string, const toml::node*>;
  std::vector<Entry> entries;
  for (const auto& [key, value] : table) entries.emplace_back(key.str(), &value);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const toml::source_position &at_a = a.second->source().begin, &at_b = b.second->source().begin;
    return std::tie(at_a.line, at_a.column) < std::tie(at_b.line, at_b.column);
  });
  for (const auto& [key, value] : entries) {
    const std::string path = node.path.empty() ? key : node.path + '.' + key;
    node.children.push_back(convert(*value, key, path, file));
  }
}

std::shared_ptr<const TomlNode> convert(const toml::node& source, std::string key, std::string path,
                                        const std::string& file) {
  auto node = std::make_shared<TomlNode>();
  node->key = std::move(key);
  node->path = std::move(path);
  node->place = file + ':' + std::to_string(source.source().begin.line);
  if (const toml::table* table = source.as_table()) {
    take_table(*table, file, *node);
  } else if (const toml::array* array = source.as_array()) {
    node->type = TomlNode::Type::kList;
    for (const toml::node& element : *array) {
      const std::string number = std::to_string(node->children.size() + 1);
      node->children.push_back(convert(element, "", node->path + '[' + number + ']', file));
    }
  } else {
    take_value(source, *node);
  }
  return node;
}

template <class Shown>
std::string joined(const TomlNode& list, std::string_view separator, Shown shown) {
  std::string text;
  for (const auto& child : list.children) {
    if (!text.empty()) text += separator;
    text += shown(*child);
  }
  return text;
}

}  // namespace

bool TomlNode::has_table() const {
  return is_table() || std::any_of(children.begin(), children.end(),
                                   [](const auto& child) { return child->has_table(); });
}

bool TomlNode::has_text() const {
  return type == Type::kText || std::any_of(children.begin(), children.end(),
                                            [](const auto& child) { return child->has_text(); });
}

std::string TomlNode::shown() const {
  if (is_table()) return "{...}";
  if (type == Type::kText) return '"' + text + '"';
  if (!is_list()) return text;
  return '[' + joined(*this, ", ", [](const TomlNode& child) { return child.shown(); }) + ']';
}

std::string TomlNode::flat() const {
  if (!is_list()) return text;
  return joined(*this, ",", [](const TomlNode& child) { return child.flat(); });
}

void TomlNode::reject(std::string_view allowed) const {
  throw ldm::InvalidInput(place + ": " + path + " = " + shown() +
                          ": allowed: " + std::string(allowed));
}

std::shared_ptr<const TomlNode> read_toml(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file) || !stream) {
    throw ldm::InvalidInput(name + ": cannot be read: allowed: a readable TOML file");
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  check_toml_limits(text, name);
  try {
    return convert(toml::parse(text, name), "", "", name);
  } catch (const toml::parse_error& error) {
    throw ldm::InvalidInput(name + ':' + std::to_string(error.source().begin.line) +
                            ": not TOML: " + std::string(error.description()));
  }
}

}  // namespace datasets
