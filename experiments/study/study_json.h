#pragma once
/// Studies and their trials as JSON, for whoever runs them (no paper section; docs/studies.md).
#include <string>
#include <vector>

#include "experiments/study/study.h"

namespace experiments {

/// What there is: `study`, `title`, `trials` (their number), `frames`, `methods` of each.
std::string studies_json(const std::vector<Study>& studies);

/// What it takes to run one: `study`, `file`, `frames`, `methods` (name of each method or variant
/// -> method of the table), `files` (path -> hash, as in the records), and `trials`: `id`,
/// `scenario`, `method`, `replicate` of each.
std::string trials_json(const Study& study);

}  // namespace experiments
