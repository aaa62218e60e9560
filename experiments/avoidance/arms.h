#pragma once
/// The arms of the closed loop: every method, and controls that know nothing or all
/// (docs/avoidance.md).
#include <memory>
#include <span>
#include <string_view>

#include "experiments/avoidance/corridor.h"
#include "experiments/avoidance/sight.h"

namespace experiments {

enum class ArmKind { kMapped, kBlind, kOracle, kOracleFuture };

struct Arm {
  ArmKind kind = ArmKind::kMapped;
  std::string_view name;
  const Method* method = nullptr;  ///< whose map it has; null of the oracles
  Trust trust;                     ///< tuned for the arm, if the study `avoidance_trust` has it

  /// `corridor` must outlive the sight.
  std::unique_ptr<Sight> sight(const ldm::Parameters& parameters, const Corridor& corridor) const;
};

struct Control {
  ArmKind kind;
  std::string_view name;
  std::string_view help;
};
std::span<const Control> controls();

/// The control or method of that name.
/// @throws ldm::InvalidInput listing the known ones
Arm find_arm(std::string_view name);

/// Parameters of an arm's map: the method's defaults, over the window that every arm has:
/// 64 x 64 x 24 voxels. A plan of 3 s looks farther than the 32 voxels of the paper.
ldm::Parameters arm_parameters(const Arm& arm);

}  // namespace experiments
