#include "experiments/pictures/label_placer.h"

#include <limits>

namespace experiments {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

AlignedBox2d LabelPlacer::place(const Vector2d& size, const AlignedBox2d& named) {
  constexpr double kGap = 9;  // [pixel]
  const Vector2d reach = (size + named.sizes()) / 2 + Vector2d::Constant(kGap);
  AlignedBox2d best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2d& side : {Vector2d(0, -1), Vector2d(0, 1), Vector2d(1, 0), Vector2d(-1, 0)}) {
    const Vector2d centre = named.center() + side.cwiseProduct(reach);
    const AlignedBox2d box(centre - size / 2, centre + size / 2);
    if (const double covered = covered_area(box); covered < least) {
      least = covered;
      best = box;
    }
  }
  taken_.push_back(best);
  return best;
}

double LabelPlacer::covered_area(const AlignedBox2d& box) const {
  double sum = 0;
  for (const AlignedBox2d& other : taken_) {
    if (box.intersects(other)) sum += box.intersection(other).volume();
  }
  return sum;
}

}  // namespace experiments
