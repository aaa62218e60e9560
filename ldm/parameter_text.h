#pragma once
/// Parameters as text: what every table with a `visit_parameters` shares (no paper section).
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "ldm/parameters.h"

namespace ldm {

std::string text_of(double value);  ///< the shortest form that reads back to the same bits
std::string text_of(std::int64_t value);
std::string text_of(std::uint64_t value);
std::string text_of(bool value);
std::string text_of(const Eigen::Vector3i& value);

/// Each sets `value` from all of `text`.
/// @throws InvalidInput naming the parameter, the text and the allowed range; nothing is changed.
void set_from_text(const ParameterInfo& info, std::string_view text, double& value);
void set_from_text(const ParameterInfo& info, std::string_view text, std::int64_t& value);
void set_from_text(const ParameterInfo& info, std::string_view text, std::uint64_t& value);
void set_from_text(const ParameterInfo& info, std::string_view text, bool& value);
void set_from_text(const ParameterInfo& info, std::string_view text, Eigen::Vector3i& value);

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
    if constexpr (sizeof...(words) > 0) {
      text = std::string((words[static_cast<std::size_t>(value)], ...));
    } else {
      text = text_of(value);
    }
  });
  return text;
}

/// `set_parameter` of any table.
template <class P>
void set_parameter_text(P& p, std::string_view name, std::string_view text) {
  with_parameter(p, name, [&](const ParameterInfo& info, auto& value, const auto&... words) {
    if constexpr (sizeof...(words) > 0) {
      using Value = std::remove_reference_t<decltype(value)>;
      value = static_cast<Value>((choice_from_text(info, text, words), ...));
    } else {
      set_from_text(info, text, value);
    }
  });
}

}  // namespace ldm
