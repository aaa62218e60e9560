#include "experiments/study/seeds.h"

#include <string>

#include "datasets/hash.h"

namespace experiments {

std::uint64_t scenario_seed(std::string_view scenario, std::int64_t replicate) {
  return datasets::hash({"scenario", scenario, std::to_string(replicate)});
}

std::uint64_t filter_seed(std::string_view study, std::string_view point, std::int64_t replicate,
                          std::string_view method) {
  return datasets::hash({"filter", study, point, std::to_string(replicate), method});
}

}  // namespace experiments
