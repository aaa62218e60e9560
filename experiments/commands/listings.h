#pragma once
/// What there is, as text tables: methods, scenarios, parameters, studies, trials (no paper
/// section).
#include <optional>
#include <ostream>
#include <string>

#include "experiments/method/data_folders.h"
#include "experiments/method/method_on_input.h"
#include "experiments/study/study.h"
#include "experiments/study/study_json.h"

namespace experiments {

/// A study of either kind.
/// @throws ldm::InvalidInput if it is unknown or bad.
StudyOutline outline_of(const std::string& study, const StudyOptions& options,
                        const DataFolders& folders);

/// Each throws ldm::InvalidInput on an unknown name or a broken file.
void list_methods(bool json, std::ostream& out);
void list_scenarios(const DataFolders& folders, std::ostream& out);
/// See listed_parameters.
void list_parameters(const std::optional<std::string>& of, const DataFolders& folders, bool json,
                     std::ostream& out);
/// Name, number of trials, title; or JSON: see study_json.h.
void list_studies(const DataFolders& folders, bool json, std::ostream& out);
/// The id of every trial, one a line; or JSON: see study_json.h.
void list_trials(const std::string& study, const StudyOptions& options, const DataFolders& folders,
                 bool json, std::ostream& out);

/// What is in a recording, which is read to its end.
/// @throws ldm::InvalidInput if it is none.
void list_recording(const MethodOnInput& request, const DataFolders& folders, std::ostream& out);

}  // namespace experiments
