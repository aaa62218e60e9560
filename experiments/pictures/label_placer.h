#pragma once
/// Places for labels in a picture (no paper section).
#include <Eigen/Geometry>
#include <vector>

namespace experiments {

/// Finds places for labels beside what they name, as free of other labels and drawings as can be.
/// Boxes are in pixels, y down.
class LabelPlacer {
 public:
  /// No label shall cover this box, if there is a choice.
  void keep_clear(const Eigen::AlignedBox2d& box) { taken_.push_back(box); }
  /// A box of that size above, below, right or left of what it names: of those that cover least
  /// the first. Later labels keep clear of it.
  Eigen::AlignedBox2d place(const Eigen::Vector2d& size, const Eigen::AlignedBox2d& named);

 private:
  double covered_area(const Eigen::AlignedBox2d& box) const;

  std::vector<Eigen::AlignedBox2d> taken_;
};

}  // namespace experiments
