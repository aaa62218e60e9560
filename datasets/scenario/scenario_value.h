#pragma once
/// The values of a scenario as text: what each type holds, and what is allowed (no paper section).
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "datasets/files/text.h"
#include "datasets/files/toml_reader.h"
#include "datasets/random.h"
#include "datasets/scenario/scenario.h"

namespace datasets {

// A value as numbers, and back.

/// How many numbers a value has; of a timetable, one row.
template <class T>
inline constexpr std::size_t kSize = 1;
template <>
inline constexpr std::size_t kSize<Interval> = 2;
template <int N>
inline constexpr std::size_t kSize<Eigen::Matrix<double, N, 1>> = N;
template <int N>
inline constexpr std::size_t kSize<std::vector<Stop<N>>> = N + 1;

template <class T>
inline constexpr bool kIsTimetable = false;
template <int N>
inline constexpr bool kIsTimetable<std::vector<Stop<N>>> = true;

inline std::vector<double> numbers_of(double value) {
  return {value};
}
inline std::vector<double> numbers_of(std::int64_t value) {
  return {static_cast<double>(value)};
}
inline std::vector<double> numbers_of(const Interval& value) {
  return {value.min, value.max};
}
inline std::vector<double> numbers_of(const Eigen::Vector2d& value) {
  return {value.x(), value.y()};
}
inline std::vector<double> numbers_of(const Eigen::Vector3d& value) {
  return {value.x(), value.y(), value.z()};
}
template <int N>
std::vector<double> numbers_of(const std::vector<Stop<N>>& value) {
  std::vector<double> numbers;
  for (const Stop<N>& stop : value) {
    numbers.push_back(stop.time);
    for (const double along : stop.place) numbers.push_back(along);
  }
  return numbers;
}

inline void assign(const std::vector<double>& numbers, double& value) {
  value = numbers[0];
}
inline void assign(const std::vector<double>& numbers, std::int64_t& value) {
  value = static_cast<std::int64_t>(numbers[0]);
}
inline void assign(const std::vector<double>& numbers, Interval& value) {
  value = {numbers[0], numbers[1]};
}
template <int N>
void assign(const std::vector<double>& numbers, Eigen::Matrix<double, N, 1>& value) {
  value = Eigen::Map<const Eigen::Matrix<double, N, 1>>(numbers.data());
}
template <int N>
void assign(const std::vector<double>& numbers, std::vector<Stop<N>>& value) {
  value.clear();
  for (std::size_t i = 0; i < numbers.size(); i += N + 1) {
    const Eigen::Map<const Eigen::Matrix<double, N, 1>> place(numbers.data() + i + 1);
    value.push_back({numbers[i], place});
  }
}

/// Stops in the order of time, from 0 or later, at places within the range.
template <int N>
bool is_timetable(const std::vector<double>& numbers, double min, double max) {
  if (numbers.empty() || numbers.size() % (N + 1) != 0) return false;
  std::vector<Stop<N>> stops;
  assign(numbers, stops);
  const auto is_wrong = [](const Stop<N>& a, const Stop<N>& b) { return !(a.time < b.time); };
  if (!(stops.front().time >= 0 && std::isfinite(stops.back().time))) return false;
  if (std::adjacent_find(stops.begin(), stops.end(), is_wrong) != stops.end()) return false;
  return std::all_of(stops.begin(), stops.end(), [&](const Stop<N>& stop) {
    return (stop.place.array() >= min).all() && (stop.place.array() <= max).all();
  });
}

/// For messages: what a value of that type and range is.
template <class T>
std::string allowed_text(double min, double max) {
  if constexpr (std::is_same_v<T, double>) return within("a number", Numbers{min, max});
  if constexpr (std::is_same_v<T, std::int64_t>) {
    return within("an integer", Integers{std::llround(min), std::llround(max)});
  }
  if constexpr (std::is_same_v<T, Interval>) {
    return within("two numbers, the smaller first,", Numbers{min, max});
  }
  if constexpr (kIsTimetable<T>) {
    const std::string place = kSize<T> == 3 ? "[time, x, y]" : "[time, x, y, z]";
    return within("stops " + place + ", times ascending from 0 or later, places",
                  Numbers{min, max});
  }
  return within(std::to_string(kSize<T>) + " numbers", Numbers{min, max});
}

template <class T>
bool is_allowed(const std::vector<double>& numbers, double min, double max) {
  if constexpr (kIsTimetable<T>) return is_timetable<kSize<T> - 1>(numbers, min, max);
  if (numbers.size() != kSize<T>) return false;
  for (const double number : numbers) {
    if (!(number >= min && number <= max)) return false;
    if (std::is_same_v<T, std::int64_t> && number != std::floor(number)) return false;
  }
  return !std::is_same_v<T, Interval> || numbers.front() <= numbers.back();
}

template <class T>
std::string text_of(const T& value) {
  std::string text;
  for (const double number : numbers_of(value)) {
    if (!text.empty()) text += ',';
    text += decimal(number);
  }
  return text;
}

}  // namespace datasets
