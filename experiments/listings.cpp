#include "experiments/listings.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "datasets/files/text.h"
#include "datasets/recording/scans/input_parameters.h"
#include "experiments/avoidance/flight_study.h"
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

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

/// The allowed values of a parameter in words.
struct RangeText {
  const ldm::ParameterInfo& info;

  template <class T>
  std::string operator()(const T&) const {
    return number(info.min).append("..").append(number(info.max));
  }
  std::string operator()(bool) const { return "true|false"; }
  template <class E, class Names>
  std::string operator()(const E&, const Names& names) const {
    return datasets::joined(names, "|");
  }
};

/// Of a study of either kind.
StudyOutline outline_of(const std::string& name, const StudyOptions& options,
                        const DataFolders& folders) {
  const std::filesystem::path file = folders.studies.file(name);
  return is_flight_study(file) ? outline(read_flight_study(file, folders.corridors, options))
                               : outline(read_study(file, folders.scenarios, options));
}

}  // namespace

void list_methods(std::ostream& out) {
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

void list_parameters(const std::optional<std::string>& name, std::ostream& out) {
  const Method* const method = name ? &find_method(*name) : nullptr;
  const ldm::Parameters parameters = method ? default_parameters(*method) : ldm::Parameters{};
  std::vector<Row> rows = {{"name", "symbol", "value", "unit", "range", "source", "meaning"}};
  const auto add = [&](const auto& table, const ldm::ParameterInfo& info, const auto&... value) {
    const auto cell = [](std::string_view text) { return text.empty() ? "-" : std::string(text); };
    rows.push_back({cell(info.name), cell(info.symbol), get_parameter(table, info.name),
                    cell(info.unit), RangeText{info}(value...), cell(info.source),
                    cell(info.help)});
  };
  visit_parameters(parameters, [&](const ldm::ParameterInfo& info, const auto&... value) {
    if (method == nullptr || uses(*method, info.name)) add(parameters, info, value...);
  });
  const datasets::InputParameters input;
  visit_parameters(input, [&](const ldm::ParameterInfo& info, const auto&... value) {
    add(input, info, value...);
  });
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

}  // namespace experiments
