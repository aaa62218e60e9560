#include "experiments/avoidance/arms.h"

#include <string>
#include <vector>

#include "datasets/files/text.h"

namespace experiments {
namespace {

constexpr Control kControls[] = {
    {ArmKind::kBlind, "blind", "knows nothing: the straight line"},
    {ArmKind::kOracle, "oracle", "knows the true shapes, which move on as they do"},
    {ArmKind::kOracleFuture, "oracle_future", "knows the true shapes, and where they will be"},
};

/// What the study `avoidance_trust` chose, which `make study STUDY=avoidance_trust` prints. Arms
/// that are not here have the default (docs/avoidance.md).
struct TunedTrust {
  std::string_view arm;
  double margin;  // [m]
  double doubt;
};
constexpr TunedTrust kTunedTrust[] = {
    {"ldm", 0.2, 2},
    {"object_ldm", 0.2, 2},
    {"circular_buffer", 0.3, 1},
    {"circular_buffer_pf", 0.3, 1},
    {"octomap", 0.2, 1},
    {"current_scan", 0.2, 1},
    {"oracle", 0.1, 1},
    {"oracle_future", 0.1, 1},
};

Trust tuned_trust(std::string_view arm) {
  Trust trust;
  for (const TunedTrust& tuned : kTunedTrust) {
    if (tuned.arm != arm) continue;
    trust.margin = tuned.margin;
    trust.doubt = tuned.doubt;
  }
  return trust;
}

}  // namespace

std::span<const Control> controls() {
  return kControls;
}

std::unique_ptr<Sight> Arm::sight(const ldm::Parameters& parameters,
                                  const Corridor& corridor) const {
  if (method != nullptr) return mapped_sight(*method, parameters, trust);
  return true_sight(parameters, corridor.obstacles, kind == ArmKind::kOracleFuture, trust);
}

Arm find_arm(std::string_view name) {
  Arm arm;
  arm.name = name;
  arm.trust = tuned_trust(name);
  std::vector<std::string> known;
  for (const Control& control : kControls) {
    known.emplace_back(control.name);
    if (control.name != name) continue;
    arm.kind = control.kind;
    if (control.kind == ArmKind::kBlind) arm.method = &find_method("empty_map");
    return arm;
  }
  for (const Method& method : methods()) {
    known.emplace_back(method.name);
    if (method.name != name) continue;
    arm.method = &method;
    return arm;
  }
  throw ldm::InvalidInput("unknown arm " + std::string(name) + ": allowed: " +
                          datasets::joined(known) + datasets::did_you_mean(name, known));
}

ldm::Parameters arm_parameters(const Arm& arm) {
  ldm::Parameters parameters = arm.method ? default_parameters(*arm.method) : ldm::Parameters{};
  parameters.map.voxels = {64, 64, 24};
  return parameters;
}

}  // namespace experiments
