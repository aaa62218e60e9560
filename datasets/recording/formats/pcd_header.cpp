#include "datasets/recording/formats/pcd_header.h"

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "datasets/files/text.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {
namespace {

constexpr std::size_t kMaxFields = 256;
constexpr std::size_t kMaxCount = 4096;       // numbers of one field: a histogram has 308
constexpr std::size_t kMaxPoints = 1U << 27;  // ten times what any sweep has

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line) {
  Words words;
  while (true) {
    const std::string_view word = next_word(line);
    if (word.empty()) return words;
    words.push_back(word);
  }
}

std::string lower_case(std::string_view word) {
  std::string lower(word);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Reads the entries, then puts them together.
class HeaderReader {
 public:
  HeaderReader(std::string_view content, const std::string& name)
      : content_(content), name_(name) {}

  PcdHeader read() {
    while (!entries_.contains("DATA")) take_line();
    take_fields();
    take_points();
    const Words& data = entry("DATA", 1).words;
    const auto encoding = std::find(kEncodings.begin(), kEncodings.end(), lower_case(data.front()));
    if (encoding == kEncodings.end()) {
      reject("DATA", "allowed: ascii, binary, binary_compressed");
    }
    header_.encoding = static_cast<PcdHeader::Encoding>(encoding - kEncodings.begin());
    header_.data_begin = at_;
    header_.lines = line_;
    return header_;
  }

 private:
  struct Entry {
    std::int64_t line = 0;
    Words words;
  };
  static constexpr std::array<std::string_view, 3> kEncodings = {"ascii", "binary",
                                                                 "binary_compressed"};

  void take_line() {
    const std::size_t end = content_.find('\n', at_);
    ++line_;
    if (end == std::string_view::npos) {
      throw BrokenFrame("broken scan", place(line_) +
                                           ": the file ends in its header: allowed: "
                                           "a PCD file, whose header ends with DATA");
    }
    Words words = words_of(content_.substr(at_, end - at_));
    at_ = end + 1;
    if (words.empty() || words.front().starts_with('#')) return;
    constexpr std::array<std::string_view, 10> kKeys = {"VERSION", "FIELDS", "COLUMNS", "SIZE",
                                                        "TYPE",    "COUNT",  "WIDTH",   "HEIGHT",
                                                        "POINTS",  "DATA"};
    std::string_view key = words.front();
    if (key == "VIEWPOINT") return;
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) {
      throw BrokenFrame("broken scan", place(line_) + ": allowed: an entry of a PCD header");
    }
    if (key == "COLUMNS") key = "FIELDS";  // before version 0.6
    words.erase(words.begin());
    entries_[std::string(key)] = {line_, std::move(words)};
  }

  void take_fields() {
    const Words& names = entry("FIELDS").words;
    if (names.size() > kMaxFields) reject("FIELDS", "allowed: at most 256 fields");
    const Words sizes = entry("SIZE", names.size()).words;
    const Words types = entry("TYPE", names.size()).words;
    const Words counts =
        entries_.contains("COUNT") ? entry("COUNT", names.size()).words : Words(names.size(), "1");
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t size = number("SIZE", sizes[i], 8);
      const bool power = size == 1 || size == 2 || size == 4 || size == 8;
      if (!power) reject("SIZE", "allowed: 1, 2, 4 or 8");
      if (types[i] != "I" && types[i] != "U" && types[i] != "F") {
        reject("TYPE", "allowed: I, U or F");
      }
      if (types[i] == "F" && size < 4) reject("SIZE", "allowed for type F: 4 or 8");
      const std::size_t count = number("COUNT", counts[i], kMaxCount);
      take_field(names[i], types[i].front(), size, count);
    }
    for (const PcdHeader::Field& field : header_.xyz) {
      if (field.size == 0) reject("FIELDS", "allowed: x, y and z among them, each with COUNT 1");
    }
  }

  void take_field(std::string_view name, char type, std::size_t size, std::size_t count) {
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (lower_case(name) != kNames[axis] || count != 1) continue;
      PcdHeader::Field& field = header_.xyz[axis];
      if (name != kNames[axis] && field.size != 0) continue;  // X, but there is an x
      field = {type, size, header_.point_size, header_.columns};
    }
    header_.point_size += size * count;
    header_.columns += count;
  }

  void take_points() {
    const bool sized = entries_.contains("WIDTH") || entries_.contains("HEIGHT");
    if (!sized && entries_.contains("POINTS")) {  // before version 0.6
      header_.points = count("POINTS");
      return;
    }
    header_.points = count("WIDTH") * (entries_.contains("HEIGHT") ? count("HEIGHT") : 1);
    if (!entries_.contains("POINTS")) return check_points("WIDTH");
    const std::size_t points = count("POINTS");
    if (points != header_.points) {
      reject("POINTS", "allowed: " + std::to_string(header_.points) + " as WIDTH and HEIGHT say");
    }
    check_points("POINTS");
  }

  std::size_t count(const std::string& key) {
    return number(key, entry(key, 1).words.front(), kMaxPoints);
  }

  void check_points(const std::string& key) {
    if (header_.points > kMaxPoints) {
      reject(key, "allowed: at most " + std::to_string(kMaxPoints) + " points");
    }
  }

  /// @param words how many it must have; 0: at least one
  const Entry& entry(const std::string& key, std::size_t words = 0) {
    const auto found = entries_.find(key);
    if (found == entries_.end()) {
      throw BrokenFrame("broken scan", name_ + ": its header has no " + key);
    }
    const std::size_t has = found->second.words.size();
    if (words == 0 ? has == 0 : has != words) {
      reject(key, std::to_string(has) +
                      " values: allowed: " + (words == 0 ? "at least 1" : std::to_string(words)));
    }
    return found->second;
  }

  std::size_t number(const std::string& key, std::string_view word, std::size_t max) {
    std::size_t value = 0;
    if (!parse_number(word, value) || value > max) {
      reject(key, "allowed: whole numbers up to " + std::to_string(max));
    }
    return value;
  }

  std::string place(std::int64_t line) const { return name_ + ":" + std::to_string(line); }

  [[noreturn]] void reject(const std::string& key, const std::string& message) const {
    throw BrokenFrame("broken scan", place(entries_.at(key).line) + ": " + key + ": " + message);
  }

  std::string_view content_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::int64_t line_ = 0;
  std::map<std::string, Entry> entries_;
  PcdHeader header_;
};

}  // namespace

PcdHeader parse_pcd_header(std::string_view content, const std::string& name) {
  return HeaderReader(content, name).read();
}

}  // namespace datasets
