#pragma once
/// Point clouds in the PCD format of the Point Cloud Library, version 0.7 (no paper section).
///
/// PCL's reader decodes them (pcd_decoder.h), behind a check of our own (pcd_check.h): alone, it
/// takes most damaged files for whole.
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
/// @throws std::runtime_error if the library that decodes cannot be loaded.
void parse_pcd(std::string_view content, const std::string& name, std::vector<ldm::Point>& points);

}  // namespace datasets
