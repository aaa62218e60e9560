#include <iostream>

#include "experiments/commands/commands.h"
#include "experiments/commands/listings.h"
#include "experiments/commands/shared_options.h"

namespace experiments {
namespace {

void add_methods(CommandLine& line) {
  const auto json = std::make_shared<bool>(false);
  line.add("methods", "list the methods", "ldm methods", [json] { list_methods(*json, std::cout); })
      .flag("--json", *json, "with what they read, for programs");
}

void add_scenarios(CommandLine& line) {
  line.add("scenarios", "list the scenarios", "ldm scenarios",
           [&line] { list_scenarios(line.folders(), std::cout); });
}

void add_studies(CommandLine& line) {
  const auto json = std::make_shared<bool>(false);
  line.add("studies", "list the studies with their number of trials", "ldm studies",
           [&line, json] { list_studies(line.folders(), *json, std::cout); })
      .flag("--json", *json, "with their methods, for programs");
}

void add_parameters(CommandLine& line) {
  struct Request {
    std::optional<std::string> of;
    bool json = false;
  };
  const auto request = std::make_shared<Request>();
  Command command = line.add(
      "parameters", "list the parameters of methods and recordings, or of a scenario",
      "ldm parameters circular_buffer",
      [&line, request] { list_parameters(request->of, line.folders(), request->json, std::cout); });
  command.option("OF", request->of,
                 "a method or scenario, with its values; or the word scenario: what any of them "
                 "may say");
  command.flag("--json", request->json, "for programs");
}

void add_trials_of_study(CommandLine& line) {
  struct Request {
    std::string study;
    StudyOptions options;
    bool json = false;
  };
  const auto request = std::make_shared<Request>();
  Command command = line.add(
      "trials", "list the trials of a study", "ldm trials table1 --seeds 2", [&line, request] {
        list_trials(request->study, request->options, line.folders(), request->json, std::cout);
      });
  add_study_options(command, request->study, request->options);
  command.flag("--json", request->json, "with what made them, for programs");
}

void add_info(CommandLine& line) {
  const auto request = std::make_shared<MethodOnInput>();
  Command command = line.add(
      "info", "tell what is in a recording, and what of it would be taken", "ldm info drive.bag",
      [&line, request] { list_recording(*request, line.folders(), std::cout); });
  command.option("FILE", request->input, "recording (docs/recordings.md)").required();
  command.option("--set", request->settings, "name=value of a parameter; may be repeated")
      .repeatable();
  add_recording_options(command, *request);
}

}  // namespace

void add_listings(CommandLine& line) {
  add_methods(line);
  add_scenarios(line);
  add_studies(line);
  add_parameters(line);
  add_trials_of_study(line);
  add_info(line);
}

}  // namespace experiments
