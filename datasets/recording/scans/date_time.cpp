#include "datasets/recording/scans/date_time.h"

#include <chrono>

#include "datasets/files/text.h"

namespace datasets {
namespace {

/// Takes two or four digits, and what must stand behind them.
std::optional<int> take_number(std::string_view& text, std::size_t digits,
                               std::string_view behind) {
  int number = 0;
  if (text.size() < digits || !parse_number(text.substr(0, digits), number) || number < 0)
    return {};
  text.remove_prefix(digits);
  if (behind.empty()) return number;
  if (text.empty() || behind.find(text.front()) == std::string_view::npos) return {};
  text.remove_prefix(1);
  return number;
}

}  // namespace

std::optional<double> seconds_of_date_time(std::string_view text) {
  const auto year = take_number(text, 4, "-"), month = take_number(text, 2, "-"),
             day = take_number(text, 2, " T"), hour = take_number(text, 2, ":"),
             minute = take_number(text, 2, ":");
  if (text.ends_with('Z')) text.remove_suffix(1);
  double second = 0;
  const bool is_second = !text.empty() &&
                         text.find_first_not_of("0123456789.") == std::string_view::npos &&
                         parse_number(text, second);
  if (!year || !month || !day || !hour || !minute || !is_second) return {};
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok() || *hour > 23 || *minute > 59 || second >= 61) return {};
  const auto days = std::chrono::sys_days(date).time_since_epoch().count();
  return static_cast<double>(((days * 24 + *hour) * 60 + *minute) * 60) + second;
}

}  // namespace datasets
