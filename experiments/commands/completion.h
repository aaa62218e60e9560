#pragma once
/// What may come next on a command line: the words behind Bash's completion (no paper section).
#include <string>
#include <vector>

#include "experiments/method/data_folders.h"

namespace experiments {

/// The words of a subcommand, or of the program itself.
struct CommandWords {
  std::string name;
  std::vector<std::string> flags;        ///< options that stand alone, as `--paused`
  std::vector<std::string> options;      ///< options that a value follows
  std::vector<std::string> positionals;  ///< what to give without an option: METHOD, INPUT, ...
};

/// @param program its options, and those that follow any subcommand
/// @param words what was typed after the program's name; the last one is to be completed
/// @return all that it may become; empty where a file is wanted, or nothing is known
std::vector<std::string> completions(const CommandWords& program,
                                     const std::vector<CommandWords>& commands,
                                     const std::vector<std::string>& words,
                                     const DataFolders& folders);

}  // namespace experiments
