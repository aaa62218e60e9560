#include "experiments/runs/label_score.h"

#include <algorithm>
#include <vector>

#include "experiments/runs/point_labels.h"

namespace experiments {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> label_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".label") files.push_back(entry.path());
  }
  if (files.empty()) {
    throw ldm::InvalidInput(folder.string() + ": no labels: allowed: a folder of *.label files");
  }
  std::sort(files.begin(), files.end());
  return files;
}

void add(bool run, bool reference, PointCounts& counts) {
  if (run && reference) {
    ++counts.both_moving;
  } else if (run) {
    ++counts.run_only;
  } else if (reference) {
    ++counts.reference_only;
  } else {
    ++counts.both_static;
  }
}

}  // namespace

std::optional<double> PointCounts::moving_iou() const {
  const std::int64_t either = both_moving + run_only + reference_only;
  if (either == 0) return {};
  return static_cast<double>(both_moving) / static_cast<double>(either);
}

LabelScore score_labels(const fs::path& run, const fs::path& reference) {
  constexpr PointLabel kClass = 0xFFFF, kOutlier = 1;
  LabelScore score;
  for (const fs::path& file : label_files(run / kLabels)) {
    const fs::path other = reference / file.filename();
    if (!fs::exists(other)) continue;
    const std::vector<PointLabel> ours = read_labels(file), theirs = read_labels(other);
    if (ours.size() != theirs.size()) {
      throw ldm::InvalidInput(other.string() + ": " + std::to_string(theirs.size()) +
                              " points: allowed: " + std::to_string(ours.size()) + ", as in " +
                              file.string());
    }
    ++score.frames;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      if ((theirs[i] & kClass) <= kOutlier) continue;  // unlabelled, or no surface at all
      const bool moves = is_moving(ours[i]), should = is_moving(theirs[i]);
      add(moves, should, score.all);
      if (ours[i] != kUnlabelled) add(moves, should, score.in_map);
    }
  }
  if (score.frames == 0) {
    throw ldm::InvalidInput(reference.string() +
                            ": no frame of the run: allowed: files named as in " +
                            (run / kLabels).string());
  }
  return score;
}

}  // namespace experiments
