#pragma once
/// Options that several subcommands have (no paper section).
#include "experiments/commands/command_line.h"
#include "experiments/method/method_on_input.h"
#include "experiments/study/study.h"

namespace experiments {

/// METHOD and INPUT, with what changes them. The request must outlive the command line's execution.
void add_method_and_input(Command& command, MethodOnInput& request);
/// The same, and the folder of a run may stand for METHOD and INPUT.
void add_run_or_method(Command& command, MethodOnInput& request);
/// How a recording is to be read.
void add_recording_options(Command& command, MethodOnInput& request);
/// STUDY, and what is to be run of it.
void add_study_options(Command& command, std::string& study, StudyOptions& options);

}  // namespace experiments
