#include "experiments/commands/completion.h"

#include <algorithm>
#include <iterator>
#include <optional>

#include "datasets/recording/scans/recording_options.h"
#include "experiments/avoidance/flight_settings.h"
#include "experiments/commands/listings.h"
#include "experiments/method/methods.h"
#include "experiments/method/parameter_list.h"

namespace experiments {
namespace {

using Words = std::vector<std::string>;

bool holds(const Words& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

void append(const Words& more, Words& words) {
  words.insert(words.end(), more.begin(), more.end());
}

Words method_names() {
  Words names;
  for (const Method& method : methods()) names.emplace_back(method.name);
  return names;
}

Words arm_names() {
  Words names;
  for (const Control& control : controls()) names.emplace_back(control.name);
  append(method_names(), names);
  return names;
}

/// The command line so far.
struct Typed {
  const CommandWords* command = nullptr;
  std::optional<std::string> option;  ///< whose value is wanted
  Words values;                       ///< of the positionals before
};

Typed read(const CommandWords& program, const std::vector<CommandWords>& commands,
           const Words& words) {
  Typed typed;
  for (auto word = words.begin(); word + 1 != words.end(); ++word) {
    const bool takes_value =
        holds(program.options, *word) || (typed.command && holds(typed.command->options, *word));
    if (takes_value) {
      if (word + 2 == words.end()) typed.option = *word;
      if (word + 2 != words.end()) ++word;
    } else if (word->starts_with('-')) {
      continue;
    } else if (typed.command == nullptr) {
      const auto named = [&](const CommandWords& command) { return command.name == *word; };
      const auto command = std::find_if(commands.begin(), commands.end(), named);
      if (command != commands.end()) typed.command = &*command;
    } else {
      typed.values.push_back(*word);
    }
  }
  return typed;
}

/// NAME= of what may be set of a flight: its own, and what the arm's map reads.
Words flight_values(const Typed& typed, const DataFolders& folders) {
  const bool has_arm = !typed.values.empty() && holds(arm_names(), typed.values.front());
  FlightSettings settings = flight_settings(has_arm ? typed.values.front() : "ldm");
  Words names;
  visit_flight_settings(settings, [&](std::string_view name, double, double, double) {
    names.push_back(std::string(name) + '=');
  });
  for (const ListedParameter& p : listed_parameters(std::nullopt, folders)) {
    if (uses(settings, p.name)) names.push_back(p.name + '=');
  }
  return names;
}

/// NAME= of what may be set.
Words settings(const Typed& typed, const DataFolders& folders) {
  Words names;
  const Words known = method_names();
  const bool has_method = !typed.values.empty() && holds(known, typed.values.front());
  if (typed.command->name == "fly") {
    names = flight_values(typed, folders);
  } else if (typed.command->name != "simulate") {
    const auto method = has_method ? std::optional(typed.values.front()) : std::nullopt;
    for (const ListedParameter& p : listed_parameters(method, folders))
      names.push_back(p.name + '=');
  }
  const Words scenarios = folders.scenarios.names();
  const bool has_scenario = !typed.values.empty() && holds(scenarios, typed.values.back());
  const std::string scenario = has_scenario ? typed.values.back() : "scenario";
  for (const ListedParameter& p : listed_parameters(scenario, folders)) {
    names.push_back("scenario." + p.name + '=');
  }
  return names;
}

Words values_of_option(const Typed& typed, const DataFolders& folders) {
  const std::string& option = *typed.option;
  if (option == "--set" && typed.command != nullptr) return settings(typed, folders);
  if (option == "-c" || option == "--config") return folders.presets.names();
  if (option == "--method") return method_names();
  if (option == "--save-as") return {"ply", "bt", "ply,bt"};
  if (option == "--format") {
    const auto& formats = datasets::kRecordingFormatNames;
    return {std::begin(formats), std::end(formats)};
  }
  return {};
}

Words trial_ids(const std::string& study, const DataFolders& folders) {
  Words ids;
  for (const StudyOutline::Trial& trial : outline_of(study, {}, folders).trials) {
    ids.push_back(trial.id);
  }
  return ids;
}

Words values_of_positional(const Typed& typed, const DataFolders& folders) {
  const std::size_t place = typed.values.size();
  if (place >= typed.command->positionals.size()) return {};
  const std::string& name = typed.command->positionals[place];
  if (name == "METHOD") return method_names();
  if (name == "ARM") return arm_names();
  if (name == "WORLD") return folders.corridors.names();
  if (name == "INPUT" || name == "SCENARIO") return folders.scenarios.names();
  if (name == "STUDY") return folders.studies.names();
  if (name == "ID") return trial_ids(typed.values.front(), folders);
  if (name == "OF") {
    Words names = method_names();
    names.emplace_back("scenario");
    append(folders.scenarios.names(), names);
    return names;
  }
  return {};
}

}  // namespace

std::vector<std::string> completions(const CommandWords& program,
                                     const std::vector<CommandWords>& commands,
                                     const std::vector<std::string>& words,
                                     const DataFolders& folders) {
  if (words.empty()) return {};
  const std::string& begun = words.back();
  const Typed typed = read(program, commands, words);
  Words all;
  if (typed.option) {
    all = values_of_option(typed, folders);
  } else if (begun.starts_with('-')) {
    for (const CommandWords* from : {&program, typed.command}) {
      if (from == nullptr) continue;
      append(from->flags, all);
      append(from->options, all);
    }
  } else if (typed.command == nullptr) {
    for (const CommandWords& command : commands) all.push_back(command.name);
  } else {
    all = values_of_positional(typed, folders);
  }
  std::erase_if(all, [&](const std::string& word) { return !word.starts_with(begun); });
  return all;
}

}  // namespace experiments
