#include "experiments/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <type_traits>

#include "datasets/files/text.h"
#include "experiments/method/plugins.h"
#include "experiments/method/provenance.h"

namespace experiments {
namespace {

enum ExitCode { kGood = 0, kFailed = 1, kBadInput = 2 };

int say(std::string_view message, ExitCode code) {
  std::cerr << "ldm: " << datasets::single_line(message) << '\n';
  return code;
}

std::string version() {
  const Provenance p = provenance();
  return "ldm " + p.version + " (commit " + p.commit + (p.dirty ? ", changed" : "") + ", binary " +
         p.binary + ")";
}

bool is_number(const std::string& text, double& value) {
  return CLI::detail::lexical_cast(text, value) && std::isfinite(value);
}

CommandWords words_of(const CLI::App& app) {
  CommandWords words{.name = app.get_name(), .flags = {}, .options = {}, .positionals = {}};
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_snames().empty() && option->get_lnames().empty()) {
      words.positionals.push_back(option->get_single_name());
    }
    std::vector<std::string>& all =
        option->get_items_expected_max() > 0 ? words.options : words.flags;
    for (const std::string& name : option->get_snames()) all.push_back("-" + name);
    for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
  }
  return words;
}

}  // namespace

CommandOption CommandOption::required(bool is) {
  option_->required(is);
  return *this;
}
CommandOption CommandOption::repeatable() {
  option_->expected(1)->allow_extra_args(false)->multi_option_policy(
      CLI::MultiOptionPolicy::TakeAll);
  return *this;
}
CommandOption CommandOption::separated_by_commas() {
  option_->delimiter(',');
  return *this;
}
CommandOption CommandOption::shows_default() {
  option_->capture_default_str();
  return *this;
}
// CLI11's own checks of the sign name the largest double as their bound.
CommandOption CommandOption::at_least_zero() {
  option_->check([](const std::string& text) -> std::string {
    double value = 0;
    return is_number(text, value) && value >= 0 ? "" : text + ": allowed: a number from 0 on";
  });
  return *this;
}
CommandOption CommandOption::positive() {
  option_->check([](const std::string& text) -> std::string {
    double value = 0;
    return is_number(text, value) && value > 0 ? "" : text + ": allowed: a number above 0";
  });
  return *this;
}
CommandOption CommandOption::within(int least, int most) {
  option_->check(CLI::Range(least, most));
  return *this;
}

CommandOption CommandOption::unsigned_number() {
  option_->check([](const std::string& text) -> std::string {
    std::uint64_t value = 0;
    return datasets::parse_number(text, value) ? "" : text + ": allowed: a whole number from 0 on";
  });
  return *this;
}

template <class Value>
CommandOption Command::option(const std::string& names, Value& value, const std::string& help) {
  CommandOption added(app_->add_option(names, value, help));
  // CLI11 would take -1 for the largest number.
  constexpr bool kUnsigned =
      std::is_same_v<Value, std::uint64_t> || std::is_same_v<Value, std::optional<std::uint64_t>>;
  return kUnsigned ? added.unsigned_number() : added;
}
template CommandOption Command::option(const std::string&, std::string&, const std::string&);
template CommandOption Command::option(const std::string&, std::optional<std::string>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::vector<std::string>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::filesystem::path&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::optional<std::filesystem::path>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::int64_t&, const std::string&);
template CommandOption Command::option(const std::string&, std::optional<std::int64_t>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::vector<std::int64_t>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, std::uint64_t&, const std::string&);
template CommandOption Command::option(const std::string&, std::optional<std::uint64_t>&,
                                       const std::string&);
template CommandOption Command::option(const std::string&, double&, const std::string&);
template CommandOption Command::option(const std::string&, std::optional<double>&,
                                       const std::string&);

void Command::flag(const std::string& name, bool& value, const std::string& help) {
  app_->add_flag(name, value, help);
}

CommandLine::CommandLine(std::vector<std::string> words)
    : words_(std::move(words)),
      app_(std::make_unique<CLI::App>(
          "Local dynamic maps for UAVs: the method, its baselines and their study.", "ldm")) {
  app_->require_subcommand(1);
  app_->footer(
      "Names and options by Tab: experiments/shell/ldm.bash, which is installed for Bash.");
  app_->set_version_flag("--version", version);
  app_->fallthrough();  // the options of the program may also follow the subcommand
  app_->get_formatter()->column_width(34);
  Command program(app_.get());
  program.option("--data-dir", data_dir_, "folder with datasets/scenarios and experiments/studies");
  program.option("--plugin", plugins_, "shared object with more methods; may be repeated")
      .repeatable();
}

CommandLine::~CommandLine() = default;

Command CommandLine::add(const std::string& name, const std::string& help,
                         const std::string& example, std::function<void()> action) {
  CLI::App* command = app_->add_subcommand(name, help);
  command->footer("Example: " + example);
  command->callback([this, action = std::move(action)] { action_ = action; });
  return Command(command);
}

int CommandLine::execute() {
  try {
    return parse_and_act();
  } catch (const ldm::InvalidInput& error) {
    return say(error.what(), kBadInput);
  } catch (const std::exception& error) {
    return say(error.what(), kFailed);
  }
}

int CommandLine::parse_and_act() {
  if (words_.size() == 1) {
    std::cout << app_->help();
    return kGood;
  }
  if (words_[1] == "complete") {
    for (const std::string& word :
         completions(words_of(*app_), commands(), {words_.begin() + 2, words_.end()}, folders())) {
      std::cout << word << '\n';
    }
    return kGood;
  }
  try {
    app_->parse(std::vector<std::string>(words_.rbegin(), words_.rend() - 1));
  } catch (const CLI::Success& help) {
    return app_->exit(help);
  } catch (const CLI::ParseError& error) {
    return say(reason(error) + " (see ldm --help)", kBadInput);
  }
  for (const std::string& file : plugins_) load_plugin(file);
  action_();
  if (!std::cout.flush()) complain("standard output cannot be written");
  return complained_ ? kFailed : kGood;
}

/// CLI11 calls a misspelt subcommand a missing one, and has no idea what was meant.
std::string CommandLine::reason(const CLI::ParseError& error) const {
  const std::vector<std::string> unknown = app_->remaining(true);
  if (unknown.empty()) return error.what();
  const std::vector<CLI::App*> chosen = app_->get_subcommands();
  std::vector<std::string> known;
  if (chosen.empty()) {
    for (const CommandWords& command : commands()) known.push_back(command.name);
    return "unknown subcommand " + unknown.front() + ": allowed: " + datasets::joined(known) +
           datasets::did_you_mean(unknown.front(), known);
  }
  for (const CommandWords& words : {words_of(*app_), words_of(*chosen.front())}) {
    known.insert(known.end(), words.flags.begin(), words.flags.end());
    known.insert(known.end(), words.options.begin(), words.options.end());
  }
  // What follows an unknown option may stand before it in CLI11's list.
  const auto option = std::find_if(unknown.begin(), unknown.end(),
                                   [](const std::string& word) { return word.starts_with('-'); });
  if (option == unknown.end()) return error.what();
  return error.what() + datasets::did_you_mean(option->substr(0, option->find('=')), known);
}

std::vector<CommandWords> CommandLine::commands() const {
  std::vector<CommandWords> all;
  for (const CLI::App* command : app_->get_subcommands({})) all.push_back(words_of(*command));
  return all;
}

void CommandLine::complain(std::string_view message) {
  say(message, kFailed);
  complained_ = true;
}

std::string CommandLine::text() const {
  return datasets::command_line(words_);
}

}  // namespace experiments
