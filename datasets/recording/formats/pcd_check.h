#pragma once
/// Whether the points of a PCD file are those that its header announces (no paper section).
///
/// PCL does not ask: a line with too few or too many values is a point at 0, what is no number is
/// 0, and as many bytes are read as the header says, wherever the file ends.
#include <string>
#include <string_view>

#include "datasets/recording/formats/pcd_header.h"
#include "datasets/recording/scans/broken_frame.h"

namespace datasets {

/// The lines of an ascii file without those of blanks alone, which PCL counts as points.
/// @param body what follows the header
/// @throws BrokenFrame `name:line: ...` unless each point has a line, of as many values as the
///   header says, and its x, y and z are numbers.
std::string checked_lines(std::string_view body, const PcdHeader& header, const std::string& name);

/// Passes the points of a binary or binary_compressed file if they have the length that the header
/// says, and a compressed one could yield it. Whether it does shows when they are decompressed.
/// @throws BrokenFrame `name: byte n: ...`
void check_bytes(std::string_view body, const PcdHeader& header, const std::string& name);

/// What to throw if it does not.
BrokenFrame damaged_points(const PcdHeader& header, const std::string& name);

}  // namespace datasets
