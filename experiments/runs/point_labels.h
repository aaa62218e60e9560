#pragma once
/// Which points move, as SemanticKITTI's files of labels (Behley et al., ICCV 2019; no paper
/// section; docs/scores.md).
#include <cstdint>
#include <filesystem>
#include <vector>

#include "datasets/frame.h"

namespace experiments {

/// Its low 16 bits are a class, its high ones the object's number, modulo 2^16.
using PointLabel = std::uint32_t;
inline constexpr PointLabel kUnlabelled = 0;
inline constexpr PointLabel kStaticPoint = 9;
inline constexpr PointLabel kMovingPoint = 251;
/// Moving, or one of the classes of SemanticKITTI that say what moves: 251 to 259.
bool is_moving(PointLabel label);

/// What a map says of each point of the scan as it was recorded: moving in a voxel of a dynamic
/// cluster, unlabelled out of the map, else static; also what was left out, as ground or as part of
/// the vehicle.
std::vector<PointLabel> labels_of(const datasets::Frame& frame, const ldm::LocalMap& map);

/// What is true of each point of a simulated scan: moving on an object that at this time moves.
/// Requires a truth.
std::vector<PointLabel> true_labels(const datasets::Frame& frame);

/// The folders of a run that hold them.
inline constexpr char kLabels[] = "labels";
inline constexpr char kTrueLabels[] = "true_labels";
/// FOLDER/000012.label, little-endian, one label for each point.
std::filesystem::path label_file(const std::filesystem::path& folder, std::int64_t frame);
void write_labels(const std::vector<PointLabel>& labels, const std::filesystem::path& file);
/// @throws ldm::InvalidInput naming the file if it cannot be read or holds a part of a label.
std::vector<PointLabel> read_labels(const std::filesystem::path& file);

}  // namespace experiments
