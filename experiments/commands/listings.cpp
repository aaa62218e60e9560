#include "experiments/commands/listings.h"

#include <algorithm>
#include <vector>

#include "datasets/recording/recording_info.h"
#include "datasets/scenario/scenario.h"
#include "experiments/avoidance/flight_study.h"
#include "experiments/commands/listings_json.h"
#include "experiments/method/methods.h"
#include "experiments/study/study_json.h"

namespace experiments {
namespace {

using Row = std::vector<std::string>;

/// Columns as wide as their widest cell; the last one is left ragged.
void print(const std::vector<Row>& rows, std::ostream& out) {
  std::vector<std::size_t> width(rows.empty() ? 0 : rows.front().size());
  for (const Row& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  }
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(width[i] - row[i].size() + 2, ' ');
    }
    out << line << '\n';
  }
}

}  // namespace

StudyOutline outline_of(const std::string& name, const StudyOptions& options,
                        const DataFolders& folders) {
  const std::filesystem::path file = folders.studies.file(name);
  return is_flight_study(file) ? outline(read_flight_study(file, folders.corridors, options))
                               : outline(read_study(file, folders.scenarios, options));
}

void list_methods(bool json, std::ostream& out) {
  if (json) {
    out << methods_json();
    return;
  }
  std::vector<Row> rows;
  for (const Method& method : methods()) {
    rows.push_back({std::string(method.name), std::string(method.help)});
  }
  print(rows, out);
}

void list_scenarios(const DataFolders& folders, std::ostream& out) {
  std::vector<Row> rows;
  for (const std::string& name : folders.scenarios.names()) {
    rows.push_back({name, datasets::read_scenario(folders.scenarios.file(name)).title});
  }
  print(rows, out);
}

void list_parameters(const std::optional<std::string>& of, const DataFolders& folders, bool json,
                     std::ostream& out) {
  const std::vector<ListedParameter> parameters = listed_parameters(of, folders);
  if (json) {
    out << parameters_json(parameters);
    return;
  }
  std::vector<Row> rows = {{"name", "symbol", "value", "unit", "range", "source", "meaning"}};
  for (const ListedParameter& p : parameters) {
    Row& row = rows.emplace_back();
    for (const std::string& cell :
         {p.name, p.symbol, p.value, p.unit, p.range(), p.source, p.help}) {
      row.push_back(cell.empty() ? "-" : cell);
    }
  }
  print(rows, out);
}

void list_studies(const DataFolders& folders, bool json, std::ostream& out) {
  std::vector<StudyOutline> studies;
  std::vector<Row> rows;
  for (const std::string& name : folders.studies.names()) {
    studies.push_back(outline_of(name, {}, folders));
    const StudyOutline& study = studies.back();
    rows.push_back({name, std::to_string(study.trials.size()), study.title});
  }
  if (json) {
    out << studies_json(studies);
  } else {
    print(rows, out);
  }
}

void list_trials(const std::string& name, const StudyOptions& options, const DataFolders& folders,
                 bool json, std::ostream& out) {
  const StudyOutline study = outline_of(name, options, folders);
  if (json) {
    out << trials_json(study);
    return;
  }
  for (const StudyOutline::Trial& trial : study.trials) out << trial.id << '\n';
}

void list_recording(const MethodOnInput& request, const DataFolders& folders, std::ostream& out) {
  datasets::describe_recording(request.input, recording_options_of(request, folders), out);
}

}  // namespace experiments
