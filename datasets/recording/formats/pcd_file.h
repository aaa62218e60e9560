#pragma once
/// Point clouds in the PCD format of the Point Cloud Library, version 0.7 (no paper section).
///
/// Nothing of a file is taken on trust. PCL takes a line with too few or too many values for a
/// point at 0, and what is no number for 0, and reads as many bytes as the header says, wherever
/// the file ends: here each is an error.
#include <string>
#include <string_view>
#include <vector>

#include "ldm/types.h"

namespace datasets {

/// The fields x, y and z of every point, in any of the three encodings (ascii, binary,
/// binary_compressed); appends to `points` [m]. Other fields are left out, and so is VIEWPOINT.
/// Points may be non-finite: PCL marks rays without a return so.
/// @param content the whole file
/// @param name for messages
/// @throws BrokenFrame naming the line or byte at which the file is none, or is not as long as its
///   header says.
void parse_pcd(std::string_view content, const std::string& name, std::vector<ldm::Point>& points);

}  // namespace datasets
