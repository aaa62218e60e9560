#pragma once
/// The command line: subcommands, their options, and which of them was chosen (no paper section).
/// Behind it stands CLI11, read by command_line.cpp alone: to compile, it costs more than all
/// commands.
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/commands/completion.h"
#include "experiments/method/data_folders.h"

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace experiments {

/// An option or, without a dash, what stands in its place; each call says more of it.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option* option) : option_(option) {}

  CommandOption required(bool is = true);
  CommandOption repeatable();           ///< one value each time it is given
  CommandOption separated_by_commas();  ///< its values
  CommandOption shows_default();        ///< in the help: the value that it had when it was added
  CommandOption at_least_zero();
  CommandOption positive();
  CommandOption within(int least, int most);
  CommandOption unsigned_number();  ///< what every option bound to one is

 private:
  CLI::Option* option_;
};

/// A subcommand. What its options are bound to must live until its action has run.
class Command {
 public:
  explicit Command(CLI::App* app) : app_(app) {}

  /// @param names as in "-o,--output", or NAME of what stands without one
  /// @param value text, path, whole number, number; optional or, for several, a vector
  template <class Value>
  CommandOption option(const std::string& names, Value& value, const std::string& help);
  void flag(const std::string& name, bool& value, const std::string& help);

 private:
  CLI::App* app_;
};

class CommandLine {
 public:
  /// @param words the program's name first
  explicit CommandLine(std::vector<std::string> words);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// @param action what the subcommand does; what it throws becomes a line and an exit code
  Command add(const std::string& name, const std::string& help, const std::string& example,
              std::function<void()> action);

  /// Does what the words say. Exit codes: 0 good, 1 the run failed, 2 bad input.
  int execute();

  // For actions.

  /// A line on standard error, and exit code 1 in the end; the action goes on.
  void complain(std::string_view message);
  DataFolders folders() const { return DataFolders(data_dir_); }
  const std::optional<std::string>& data_dir() const { return data_dir_; }
  const std::vector<std::string>& plugins() const { return plugins_; }
  /// The words as a line, which repeats this run.
  std::string text() const;

 private:
  int parse_and_act();
  std::string reason(const CLI::ParseError& error) const;
  std::vector<CommandWords> commands() const;

  std::vector<std::string> words_;
  std::unique_ptr<CLI::App> app_;
  std::function<void()> action_;
  std::optional<std::string> data_dir_;
  std::vector<std::string> plugins_;
  bool complained_ = false;
};

}  // namespace experiments
