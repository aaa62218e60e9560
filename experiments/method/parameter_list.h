#pragma once
/// The parameters of methods, recordings and scenarios as rows of one list (no paper section).
#include <optional>
#include <string>
#include <vector>

#include "experiments/method/data_folders.h"

namespace experiments {

struct ListedParameter {
  std::string name;
  std::string symbol;  ///< may be empty, as unit and help
  std::string value;   ///< as text; empty of a scenario without a name
  std::string unit;
  double min = 0, max = 0;
  std::vector<std::string> words;  ///< of a choice; `true` and `false` of a switch
  std::string source;
  std::string help;

  std::string range() const;  ///< "min..max", or the words
};

/// @param of a method: with its values, and only what it uses; `scenario`: what a scenario may say,
/// groups being called NAME; a scenario: with its values; nothing: the defaults. Those of methods
/// are followed by those of recordings, which are the same for all.
/// @throws ldm::InvalidInput if there is no such method or scenario, or the scenario is bad.
std::vector<ListedParameter> listed_parameters(const std::optional<std::string>& of,
                                               const DataFolders& folders);

}  // namespace experiments
