#pragma once
/// Parameters as text: what every table with a `visit_parameters` shares (no paper section).
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "ldm/parameters.h"

namespace ldm {

/// A parameter's value and its text. T is double, std::int64_t, std::uint64_t, bool or
/// Eigen::Vector3i.
template <class T>
struct ParameterValue {
  /// The shortest text that reads back to the same bits.
  static std::string text(const T& value);
  /// Sets `value` from all of `text`.
  /// @throws InvalidInput naming the parameter, the text and the allowed range; nothing is changed.
  static void set(const ParameterInfo& info, std::string_view text, T& value);
  /// @throws InvalidInput as above, unless `value` is in its range.
  static void check(const ParameterInfo& info, const T& value);
};

/// Position of `text` among the words of an enumeration.
/// @throws InvalidInput as above.
std::size_t choice_from_text(const ParameterInfo& info, std::string_view text,
                             std::span<const std::string_view> words);

[[noreturn]] void refuse_parameter_name(std::string_view name);

/// Calls `known(info, value[, words])` for the parameter of that name in the table of `p`.
/// @throws InvalidInput if there is none.
template <class P, class F>
void with_parameter(P& p, std::string_view name, F&& known) {
  bool found = false;
  visit_parameters(p, [&](const ParameterInfo& info, auto& value, const auto&... words) {
    if (info.name != name) return;
    found = true;
    known(info, value, words...);
  });
  if (!found) refuse_parameter_name(name);
}

/// `get_parameter` of any table.
template <class P>
std::string parameter_text(const P& p, std::string_view name) {
  std::string text;
  with_parameter(p, name, [&](const ParameterInfo&, const auto& value, const auto&... words) {
    using Value = std::remove_cvref_t<decltype(value)>;
    if constexpr (sizeof...(words) > 0) {
      text = std::string((words[static_cast<std::size_t>(value)], ...));
    } else {
      text = ParameterValue<Value>::text(value);
    }
  });
  return text;
}

/// `set_parameter` of any table.
template <class P>
void set_parameter_text(P& p, std::string_view name, std::string_view text) {
  with_parameter(p, name, [&](const ParameterInfo& info, auto& value, const auto&... words) {
    using Value = std::remove_reference_t<decltype(value)>;
    if constexpr (sizeof...(words) > 0) {
      value = static_cast<Value>((choice_from_text(info, text, words), ...));
    } else {
      ParameterValue<Value>::set(info, text, value);
    }
  });
}

}  // namespace ldm
