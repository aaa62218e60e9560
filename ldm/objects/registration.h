#pragma once
/// How far an object has moved between two views of it (no paper section; docs/objects.md).
#include <vector>

#include "ldm/objects/ingredients.h"
#include "ldm/objects/view.h"

namespace ldm {

/// A view that later ones are registered against: its surface with normals.
struct Outline {
  struct Spot {
    Eigen::Vector2d point;   ///< on the surface, world [m]
    Eigen::Vector2d normal;  ///< unit vector
    double reach;            ///< how far along the surface it stands for its neighbourhood [m]
    double variance;         ///< of the point along the normal [m^2]
  };
  View view;
  std::vector<std::vector<Spot>> spots;  ///< per slice of the view, from right to left
};

/// The surface through the columns of `view`: each with a line fitted to its neighbours.
Outline outline_of(const View& view);

struct Displacement {
  Eigen::Vector2d value = Eigen::Vector2d::Zero();  ///< [m]
  /// Inverse covariance [1/m^2]; the layout is the same for every -march, as in Pose.
  Eigen::Matrix<double, 2, 2, Eigen::DontAlign> information = Eigen::Matrix2d::Zero();
  double misfit = 0;  ///< mean squared residual over its variance, each at most 25
  double cost = 0;    ///< of this minimum, to choose among several: misfit and way of the centre
};

/// The displacement from `outline` to `view` that puts each column on the surface of the outline in
/// the same slice, each edge on the line of sight along its edge, and the centre where it has gone:
/// Gauss-Newton with Cauchy's cost, from `guess` [m]. A misfit makes it less certain: what has
/// turned has another outline, and then the centre decides. Cost: columns times spots.
Displacement registered(const Outline& outline, const View& view, const Eigen::Vector2d& guess,
                        const Ingredients& ingredients = {});

}  // namespace ldm
