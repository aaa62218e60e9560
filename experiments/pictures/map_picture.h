#pragma once
/// What a picture shows of a local map (in the manner of Figures 12 and 13 of the paper).
#include <string>

#include "datasets/frame.h"
#include "experiments/pictures/picture.h"

namespace experiments {

/// Number of colours of clusters.
extern const std::size_t kClusterColours;
/// Requires colour < kClusterColours.
Colour cluster_colour(std::size_t colour);
/// Of occupied voxels in no cluster.
inline constexpr Colour kNoClusterColour{170, 170, 170};

/// @param colours of the clusters, each below kClusterColours; empty: the method finds no clusters,
///   and its occupied voxels are grey
/// @param heading first line
Picture picture_of(const datasets::Frame& frame, const ldm::LocalMap& map,
                   const std::vector<std::size_t>& colours, const std::string& heading);

}  // namespace experiments
