#include "ldm/parameters.h"

#include <algorithm>
#include <charconv>

#include "ldm/parameter_text.h"

namespace ldm {
namespace {

template <class Names>
std::string joined(const Names& names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

std::string range(const ParameterInfo& info) {
  return text_of(info.min) + " to " + text_of(info.max) +
         (info.unit.empty() ? "" : " " + std::string(info.unit));
}

[[noreturn]] void refuse(const ParameterInfo& info, std::string_view text,
                         const std::string& allowed) {
  throw InvalidInput(std::string(info.name) + " = " + std::string(text) + ": allowed: " + allowed);
}

/// The whole of `text` as a number of type T.
template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

template <class T>
void set_number(const ParameterInfo& info, std::string_view text, const char* kind, T& value) {
  T parsed{};
  if (!parse(text, parsed) || !(static_cast<double>(parsed) >= info.min) ||
      !(static_cast<double>(parsed) <= info.max)) {
    refuse(info, text, std::string(kind) + " from " + range(info));
  }
  value = parsed;
}

}  // namespace

std::string text_of(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}
std::string text_of(std::int64_t value) {
  return std::to_string(value);
}
std::string text_of(std::uint64_t value) {
  return std::to_string(value);
}
std::string text_of(bool value) {
  return value ? "true" : "false";
}
std::string text_of(const Eigen::Vector3i& v) {
  return std::to_string(v.x()) + "," + std::to_string(v.y()) + "," + std::to_string(v.z());
}

void set_from_text(const ParameterInfo& info, std::string_view text, double& value) {
  set_number(info, text, "a number", value);
}
void set_from_text(const ParameterInfo& info, std::string_view text, std::int64_t& value) {
  set_number(info, text, "a whole number", value);
}
void set_from_text(const ParameterInfo& info, std::string_view text, std::uint64_t& value) {
  set_number(info, text, "a whole number", value);
}
void set_from_text(const ParameterInfo& info, std::string_view text, bool& value) {
  if (text != "true" && text != "false") refuse(info, text, "true, false");
  value = text == "true";
}
void set_from_text(const ParameterInfo& info, std::string_view text, Eigen::Vector3i& value) {
  const std::string allowed =
      "one or three whole numbers from " + range(info) + ", separated by commas";
  Eigen::Vector3i parsed;
  int count = 0;
  std::string_view rest = text;
  bool more = true;
  while (more && count < 3) {
    const std::size_t comma = rest.find(',');
    more = comma != std::string_view::npos;
    std::int32_t number = 0;
    if (!parse(rest.substr(0, comma), number) || number < info.min || number > info.max) {
      refuse(info, text, allowed);
    }
    parsed[count++] = number;
    rest = more ? rest.substr(comma + 1) : std::string_view();
  }
  if (count == 2 || more) refuse(info, text, allowed);
  value = count == 1 ? Eigen::Vector3i::Constant(parsed[0]) : parsed;
}

std::size_t choice_from_text(const ParameterInfo& info, std::string_view text,
                             std::span<const std::string_view> words) {
  const auto word = std::find(words.begin(), words.end(), text);
  if (word == words.end()) refuse(info, text, joined(words));
  return static_cast<std::size_t>(word - words.begin());
}

void refuse_parameter_name(std::string_view name) {
  throw InvalidInput("unknown parameter " + std::string(name) +
                     ": allowed: a name that `ldm parameters` lists");
}

std::string get_parameter(const Parameters& parameters, std::string_view name) {
  return parameter_text(parameters, name);
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
  set_parameter_text(parameters, name, text);
}

const Parameters& checked(const Parameters& parameters) {
  Parameters scratch;
  visit_parameters(parameters, [&](const ParameterInfo& info, const auto&, const auto&...) {
    set_parameter(scratch, info.name, get_parameter(parameters, info.name));
  });
  return parameters;
}

}  // namespace ldm
