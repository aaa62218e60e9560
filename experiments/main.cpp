/// The program `ldm`: its subcommands, in the order in which its help lists them.
#include "experiments/commands/commands.h"

int main(int argc, char** argv) {
  experiments::CommandLine line({argv, argv + argc});
  experiments::add_listings(line);
  experiments::add_runs(line);
  experiments::add_trials(line);
  return line.execute();
}
