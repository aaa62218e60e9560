#pragma once
/// The subcommands of the program, in groups; each is added with its options and its action
/// (no paper section). The command line must outlive what it executes.
#include "experiments/commands/command_line.h"

namespace experiments {

/// methods, scenarios, studies, parameters, trials, info
void add_listings(CommandLine& line);
/// simulate, run, score, render, view
void add_runs(CommandLine& line);
/// fly, trial
void add_trials(CommandLine& line);

}  // namespace experiments
