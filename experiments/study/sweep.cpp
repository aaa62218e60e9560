#include "experiments/study/sweep.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "datasets/files/text.h"
#include "ldm/types.h"

namespace experiments {
namespace {

using datasets::TomlTable;

constexpr std::int64_t kMaxPoints = 10000;

bool is_whole(const std::string& number) {
  return number.find_first_not_of("-0123456789") == std::string::npos;
}

/// {from, to, steps, scale} as a list of values.
std::vector<std::string> range_values(const TomlTable& range) {
  static constexpr std::string_view kScales[] = {"linear", "log"};
  const bool log = range.choice("scale", kScales, 0) == 1;
  const double from = range.number("from", {.min = log ? 1e-12 : -1e12, .max = 1e12});
  const double to = range.number("to", {.min = log ? 1e-12 : -1e12, .max = 1e12});
  const std::int64_t steps = range.integer("steps", {.min = 2, .max = kMaxPoints});
  const bool whole = is_whole(range.value_text("from")) && is_whole(range.value_text("to"));

  std::vector<std::string> values;
  for (std::int64_t i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(steps - 1);
    const double value = log ? from * std::pow(to / from, share) : from + share * (to - from);
    if (whole) {
      values.push_back(std::to_string(std::llround(value)));
    } else {
      char text[32];
      std::snprintf(text, sizeof text, "%.6g", value);  // readable on the axis of a figure
      values.emplace_back(text);
    }
  }
  return values;
}

/// The points of one axis alone.
std::vector<Setting> read_axis(const TomlTable& axes, const std::string& name) {
  std::vector<std::string> values;
  if (axes.is_table(name)) {
    const TomlTable range = axes.table(name);
    if (!range.has("from")) {
      throw ldm::InvalidInput(axes.place(name) + ": " + name +
                              ": allowed: a full name in quotes, as in \"particles.count\", with a "
                              "list or {from, to, steps, scale}");
    }
    values = range_values(range);
  } else {
    values = axes.value_texts(name);
  }
  if (values.empty()) axes.reject(name, "at least one value");
  std::vector<Setting> axis;
  for (const std::string& value : values) {
    if (std::count(values.begin(), values.end(), value) > 1) {
      throw ldm::InvalidInput(axes.place(name) + ": " + name + ": the value " + value +
                              " comes twice: allowed: each value once");
    }
    axis.push_back({name, value, axes.place(name)});
  }
  return axis;
}

std::vector<Point> cross(const std::vector<std::vector<Setting>>& axes) {
  std::vector<Point> points(1);
  for (const auto& axis : axes) {
    std::vector<Point> longer;
    longer.reserve(points.size() * axis.size());
    for (const Point& point : points) {
      for (const Setting& setting : axis) {
        longer.push_back(point);
        longer.back().push_back(setting);
      }
    }
    points = std::move(longer);
  }
  return points;
}

std::vector<Point> paired(const std::vector<std::vector<Setting>>& axes) {
  std::vector<Point> points(axes.front().size());
  for (const auto& axis : axes) {
    if (axis.size() != points.size()) {
      throw ldm::InvalidInput(axis.front().place + ": " + axis.front().name + " has " +
                              std::to_string(axis.size()) + " values: allowed: " +
                              std::to_string(points.size()) + ", as many as the first paired axis");
    }
    for (std::size_t i = 0; i < axis.size(); ++i) points[i].push_back(axis[i]);
  }
  return points;
}

}  // namespace

std::vector<Point> read_points(const TomlTable& sweep) {
  static constexpr std::string_view kCombinations[] = {"cross", "paired"};
  const bool pair = sweep.choice("combine", kCombinations, 0) == 1;
  const TomlTable table = sweep.table("axes");
  std::vector<std::vector<Setting>> axes;
  double count = 1;
  for (const std::string& name : table.keys()) {
    axes.push_back(read_axis(table, name));
    count *= pair ? 1.0 : static_cast<double>(axes.back().size());
  }
  if (axes.empty() || count > static_cast<double>(kMaxPoints)) {
    throw ldm::InvalidInput(sweep.place("axes") +
                            ": sweep.axes: allowed: at least one axis and at most " +
                            std::to_string(kMaxPoints) + " points in all");
  }
  return pair ? paired(axes) : cross(axes);
}

std::string describe(const Point& point) {
  std::vector<std::string> words;
  for (const Setting& setting : point) words.push_back(setting.name + "=" + setting.value);
  return datasets::joined(words, " ");
}

}  // namespace experiments
