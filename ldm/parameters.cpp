#include "ldm/parameters.h"

#include <charconv>
#include <sstream>
#include <type_traits>

namespace ldm {
namespace {

template <class T>
concept Enumeration = std::is_enum_v<T>;

std::string to_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;  // shortest exact form
  return {buffer, end};
}

template <class Names>
std::string joined(const Names& names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

std::string range(const ParameterInfo& info) {
  return to_text(info.min) + " to " + to_text(info.max) +
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

/// Turns values into text.
struct Getter {
  std::string operator()(double value) const { return to_text(value); }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(std::uint64_t value) const { return std::to_string(value); }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(const Eigen::Vector3i& v) const {
    return std::to_string(v.x()) + "," + std::to_string(v.y()) + "," + std::to_string(v.z());
  }
};

/// Turns text into values; refuses what is no value or out of range.
struct Setter {
  const ParameterInfo& info;
  std::string_view text;

  template <class T>
  void number(T& value, const char* kind) const {
    T parsed{};
    if (!parse(text, parsed) || !(static_cast<double>(parsed) >= info.min) ||
        !(static_cast<double>(parsed) <= info.max)) {
      refuse(info, text, std::string(kind) + " from " + range(info));
    }
    value = parsed;
  }
  void operator()(double& value) const { number(value, "a number"); }
  void operator()(std::int64_t& value) const { number(value, "a whole number"); }
  void operator()(std::uint64_t& value) const { number(value, "a whole number"); }
  void operator()(bool& value) const {
    if (text != "true" && text != "false") refuse(info, text, "true, false");
    value = text == "true";
  }
  void operator()(Eigen::Vector3i& value) const {
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
};

/// Applies `known` to the parameter called `name`; false if there is none.
template <class P, class F>
bool with_parameter(P& parameters, std::string_view name, F&& known) {
  bool found = false;
  visit_parameters(parameters, [&](const ParameterInfo& info, auto& value, auto&... names) {
    if (info.name != name) return;
    found = true;
    known(info, value, names...);
  });
  return found;
}

[[noreturn]] void refuse_name(std::string_view name) {
  throw InvalidInput("unknown parameter " + std::string(name) +
                     ": allowed: a name that `ldm parameters` lists");
}

}  // namespace

std::string get_parameter(const Parameters& parameters, std::string_view name) {
  std::string text;
  const auto read = [&](const ParameterInfo&, const auto& value, const auto&... names) {
    if constexpr (sizeof...(names) > 0) {
      text = std::string((names[static_cast<std::size_t>(value)], ...));
    } else {
      text = Getter{}(value);
    }
  };
  if (!with_parameter(parameters, name, read)) refuse_name(name);
  return text;
}

void set_parameter(Parameters& parameters, std::string_view name, std::string_view text) {
  const auto write = [&](const ParameterInfo& info, auto& value, const auto&... names) {
    if constexpr (sizeof...(names) > 0) {
      const auto choose = [&](const auto& words) {
        for (std::size_t i = 0; i < std::size(words); ++i) {
          if (words[i] != text) continue;
          value = static_cast<std::remove_reference_t<decltype(value)>>(i);
          return;
        }
        refuse(info, text, joined(words));
      };
      (choose(names), ...);
    } else {
      Setter{info, text}(value);
    }
  };
  if (!with_parameter(parameters, name, write)) refuse_name(name);
}

const Parameters& checked(const Parameters& parameters) {
  Parameters scratch;
  visit_parameters(parameters, [&](const ParameterInfo& info, const auto&, const auto&...) {
    set_parameter(scratch, info.name, get_parameter(parameters, info.name));
  });
  return parameters;
}

}  // namespace ldm
