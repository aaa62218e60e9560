#pragma once
/// Seeds of a trial, from what the trial is (no paper section).
#include <cstdint>
#include <string_view>

namespace experiments {

/// Seed of the world. It knows nothing of study, method or sweep: comparisons between them are
/// paired, world by world.
std::uint64_t scenario_seed(std::string_view scenario, std::int64_t replicate);

/// Seed of the particle filter. `point` is the swept values in words, so that a sweep that grows
/// keeps the seeds of its old points.
std::uint64_t filter_seed(std::string_view study, std::string_view point, std::int64_t replicate,
                          std::string_view method);

}  // namespace experiments
