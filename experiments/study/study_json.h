#pragma once
/// Studies and their trials as JSON, for whoever runs them (no paper section; docs/studies.md).
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "experiments/study/study.h"

namespace experiments {

/// What it takes to run a study, of whatever kind.
struct StudyOutline : StudyBase {
  struct Trial {
    std::string id, scenario, method;
    std::int64_t replicate = 1;
  };
  /// Name of each method or variant, and the method of the table behind it.
  std::vector<std::pair<std::string, std::string>> methods;
  std::vector<Trial> trials;
};
StudyOutline outline(const Study& study);

/// What there is: `study`, `title`, `trials` (their number), `frames`, `methods` of each.
std::string studies_json(const std::vector<StudyOutline>& studies);

/// What it takes to run one: `study`, `file`, `frames`, `methods` (name of each method or variant
/// -> method of the table), `files` (path -> hash, as in the records), and `trials`: `id`,
/// `scenario`, `method`, `replicate` of each.
std::string trials_json(const StudyOutline& study);

}  // namespace experiments
