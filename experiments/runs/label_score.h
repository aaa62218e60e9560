#pragma once
/// Which points of a run move, against files of labels (no paper section; docs/scores.md).
#include <cstdint>
#include <filesystem>
#include <optional>

namespace experiments {

/// Points with a label in the reference, by what run and reference say.
struct PointCounts {
  std::int64_t both_moving = 0, run_only = 0, reference_only = 0, both_static = 0;

  std::int64_t points() const { return both_moving + run_only + reference_only + both_static; }
  /// Intersection over union of the points that move, as benchmarks of moving-object segmentation
  /// define it; none if neither has any.
  std::optional<double> moving_iou() const;
};

struct LabelScore {
  std::int64_t frames = 0;  ///< those that run and reference have
  PointCounts all;          ///< what the run does not label counts as static
  PointCounts in_map;       ///< of what it labels
};

/// @param run FOLDER of `ldm run --save-labels`
/// @param reference a folder of files with the same names, as SemanticKITTI's `labels`
/// @throws ldm::InvalidInput if the run has no labels, if no file is in both, or if one has another
/// number of points.
LabelScore score_labels(const std::filesystem::path& run, const std::filesystem::path& reference);

}  // namespace experiments
