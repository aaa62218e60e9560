#pragma once
/// The scans of a folder in their order, and which line of a text file belongs to which (no paper
/// section).
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

/// True if a stands before b: numbers in names count by their value.
/// @param fractions 22.25 stands before 22.3, as times with their last zeros cut off do; else a dot
///   parts numbers: 1.9 stands before 1.10.
bool natural_less(std::string_view a, std::string_view b, bool fractions = false);

/// True if numbers with a dot are fractions: of different lengths, and none ends with a zero.
bool have_fractions(const std::vector<std::string>& names);

/// True for a name that ends so, in small or capital letters, and is not hidden: other systems
/// leave files like ._0000.pcd beside the scans.
bool is_scan_name(const std::filesystem::path& file, std::string_view ending);

/// Names of the scans in a folder, in natural order.
/// @throws ldm::InvalidInput if the folder cannot be read or has none.
std::vector<std::string> scan_names(const std::filesystem::path& folder, std::string_view ending);

/// The scan of each line of a text file that has a line for each scan: of `lines` lines and as many
/// scans line k is that of scan k. With fewer scans, the numbers that are their names must tell
/// which are missing: those have an empty name.
/// @return none if nothing tells
std::optional<std::vector<std::string>> scan_of_each_line(const std::vector<std::string>& names,
                                                          std::int64_t lines);

}  // namespace datasets
