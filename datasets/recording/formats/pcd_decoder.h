#pragma once
/// The points of a PCD file, by the reader of the Point Cloud Library (no paper section).
#include <string_view>
#include <vector>

#include "datasets/recording/formats/pcd_header.h"
#include "ldm/types.h"

namespace datasets {

/// Appends x, y and z of every point to `points` [m]; false if they cannot be decompressed.
/// @param header of at least one point
/// @param body what follows the header, as pcd_check.h allows it: PCL looks at no length
///
/// The one function of the library that the first PCD file loads: PCL needs 46 libraries, VTK's
/// among them, and no other input shall wait for those.
using DecodePcd = bool(const PcdHeader& header, std::string_view body,
                       std::vector<ldm::Point>& points);
inline constexpr char kPcdLibrary[] = "ldm_pcd.so";
inline constexpr char kDecodePcd[] = "ldm_decode_pcd";

}  // namespace datasets
