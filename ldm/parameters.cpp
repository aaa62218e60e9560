#include "ldm/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "ldm/machine/parallel.h"
#include "ldm/parameter_text.h"

namespace ldm {
namespace {

template <class Names>
std::string joined(const Names& names) {
  std::string all;
  for (const std::string_view name : names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

[[noreturn]] void refuse(const ParameterInfo& info, std::string_view text,
                         const std::string& allowed) {
  throw InvalidInput(std::string(info.name) + " = " + std::string(text) + ": allowed: " + allowed);
}

template <class T>
std::string number_text(T value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

/// What a value of type T may be, in words.
template <class T>
std::string allowed(const ParameterInfo& info) {
  const std::string range = number_text(info.min) + " to " + number_text(info.max) +
                            (info.unit.empty() ? "" : " " + std::string(info.unit));
  if constexpr (std::is_same_v<T, bool>) return "true, false";
  if constexpr (std::is_same_v<T, double>) return "a number from " + range;
  if constexpr (std::is_integral_v<T>) return "a whole number from " + range;
  return "one or three whole numbers from " + range + ", separated by commas";
}

template <class T>
bool in_range(const ParameterInfo& info, const T& value) {
  if constexpr (std::is_same_v<T, Eigen::Vector3i>) {
    return in_range(info, value.minCoeff()) && in_range(info, value.maxCoeff());
  } else {  // nothing that is not a number is within a bound
    return static_cast<double>(value) >= info.min && static_cast<double>(value) <= info.max;
  }
}

/// The whole of `text` as a number.
template <class T>
bool parse(std::string_view text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}
bool parse(std::string_view text, bool& value) {
  value = text == "true";
  return value || text == "false";
}
/// One number for all axes, or three.
bool parse(std::string_view text, Eigen::Vector3i& value) {
  int count = 0;
  for (bool more = true; more; ++count) {
    const std::size_t comma = text.find(',');
    more = comma != std::string_view::npos;
    if (count == 3 || !parse(text.substr(0, comma), value[count])) return false;
    if (more) text.remove_prefix(comma + 1);
  }
  if (count == 1) value.setConstant(value[0]);
  return count != 2;
}

}  // namespace

template <class T>
std::string ParameterValue<T>::text(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_same_v<T, Eigen::Vector3i>) {
    return number_text(value.x()) + "," + number_text(value.y()) + "," + number_text(value.z());
  } else {
    return number_text(value);
  }
}

template <class T>
void ParameterValue<T>::set(const ParameterInfo& info, std::string_view text, T& value) {
  T parsed{};
  if (!parse(text, parsed) || !in_range(info, parsed)) refuse(info, text, allowed<T>(info));
  value = parsed;
}

template <class T>
void ParameterValue<T>::check(const ParameterInfo& info, const T& value) {
  if (!in_range(info, value)) refuse(info, text(value), allowed<T>(info));
}

template struct ParameterValue<double>;
template struct ParameterValue<std::int64_t>;
template struct ParameterValue<std::uint64_t>;
template struct ParameterValue<bool>;
template struct ParameterValue<Eigen::Vector3i>;

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

std::int64_t threads_that_pay(const Parameters& parameters) {
  constexpr double kEach = 1e6;
  const double size =
      parameters.map.voxels.cast<double>().prod() + static_cast<double>(parameters.particles.count);
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::ceil(size / kEach)), 1,
                                  Parallel::at_once());
}

const Parameters& checked(const Parameters& parameters) {
  visit_parameters(parameters,
                   [](const ParameterInfo& info, const auto& value, const auto&... words) {
                     using Value = std::remove_cvref_t<decltype(value)>;
                     if constexpr (sizeof...(words) > 0) {
                       const auto number = static_cast<std::int64_t>(value);
                       if (!in_range(info, number))
                         refuse(info, number_text(number), (joined(words), ...));
                     } else {
                       ParameterValue<Value>::check(info, value);
                     }
                   });
  return parameters;
}

}  // namespace ldm
