#include "experiments/commands/listings_json.h"

#include <nlohmann/json.hpp>

#include "experiments/method/plugins.h"

namespace experiments {
namespace {

using Json = nlohmann::ordered_json;

/// One object a line.
std::string lines(const Json& array) {
  std::string text;
  for (const Json& element : array) text += (text.empty() ? "[" : ",\n ") + element.dump();
  return text + "]\n";
}

}  // namespace

std::string methods_json() {
  Json array = Json::array();
  for (const Method& method : methods()) {
    Json overrides = Json::object();
    for (const auto& [name, value] : method.overrides) overrides[std::string(name)] = value;
    const std::optional<PluginFile> plugin = plugin_of(method);
    array.push_back({{"name", method.name},
                     {"help", method.help},
                     {"finds_clusters", method.finds_clusters},
                     {"parameters", method.parameters},
                     {"overrides", std::move(overrides)},
                     {"plugin", plugin ? Json(plugin->name) : Json(nullptr)}});
  }
  return lines(array);
}

std::string parameters_json(const std::vector<ListedParameter>& parameters) {
  Json array = Json::array();
  for (const ListedParameter& p : parameters) {
    const bool is_number = p.words.empty();
    array.push_back({{"name", p.name},
                     {"symbol", p.symbol},
                     {"value", p.value.empty() ? Json(nullptr) : Json(p.value)},
                     {"unit", p.unit},
                     {"min", is_number ? Json(p.min) : Json(nullptr)},
                     {"max", is_number ? Json(p.max) : Json(nullptr)},
                     {"words", p.words},
                     {"source", p.source},
                     {"help", p.help}});
  }
  return lines(array);
}

}  // namespace experiments
