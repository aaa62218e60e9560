#pragma once
/// A local map as a file of OctoMap, which octovis opens (no paper section).
#include <ostream>
#include <string>

#include "ldm/types.h"

namespace baselines {

/// Write the occupied and the free voxels; unknown ones are in no leaf. The
/// format (`.bt`) has one bit of occupancy a leaf, no probability.
/// @param comment a line for the file's header, or empty
/// @throws ldm::InvalidInput on a map beyond OctoMap's 32,768 voxels from the origin.
void write_bt(const ldm::LocalMap& map, const std::string& comment, std::ostream& out);

}  // namespace baselines
