#include "datasets/recording/formats/pcd_reader.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "datasets/recording/formats/pcd_file.h"
#include "datasets/recording/formats/scan_folder_reader.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

/// Takes the number at the beginning, without leading zeros; empty for 0 and where there is none.
std::string_view take_digits(std::string_view& text) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

bool begins_with_digit(std::string_view text) {
  return !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0;
}

std::vector<std::string> scan_names(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".pcd") names.push_back(entry.path().filename().string());
  }
  if (error) {
    throw ldm::InvalidInput(folder.string() + ": cannot be read (" + error.message() + ")");
  }
  if (names.empty()) throw ldm::InvalidInput(folder.string() + ": has no scans (*.pcd)");
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a, whole_b = b;
  while (!a.empty() && !b.empty()) {
    if (begins_with_digit(a) && begins_with_digit(b)) {
      const std::string_view x = take_digits(a), y = take_digits(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a.front() != b.front()) return a.front() < b.front();
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;  // 01 and 1
}

std::unique_ptr<ScanReader> open_pcd_folder(const fs::path& folder,
                                            const RecordingOptions& options) {
  ScanFolder scans;
  std::vector<std::string> names = scan_names(folder);
  scans.scans = static_cast<std::int64_t>(names.size());
  scans.file_of = [folder, names = std::move(names)](std::int64_t number) {
    return folder / names.at(static_cast<std::size_t>(number));
  };
  scans.load = [content = std::string()](const fs::path& file,
                                         std::vector<ldm::Point>& points) mutable {
    read_scan_file(file, content);
    parse_pcd(content, file.string(), points);
  };
  scans.timeline = timeline_files(folder, options);
  scans.poses_of = options.input.poses_of;
  return std::make_unique<ScanFolderReader>(std::move(scans), options.input, !options.keep_going);
}

}  // namespace datasets
