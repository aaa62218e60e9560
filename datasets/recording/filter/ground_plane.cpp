#include "datasets/recording/filter/ground_plane.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/random.h"

namespace datasets {
namespace {

constexpr float kNear = 0.15F;         // [m]: a point this far from a plane may be of it
constexpr int kMinPoints = 3;          // of a cell: a lone one may be a reflection
constexpr std::size_t kMinCells = 10;  // that lie on the plane
constexpr std::size_t kMinShare = 4;   // one in so many cells must
constexpr int kTrials = 200;           // finds a ground of half the cells but once in 10^11 frames
constexpr int kRefinements = 3;
constexpr std::uint64_t kKey = 0x67726f756e64ULL;

bool agrees(const GroundPlane& plane, const ldm::Point& p) {
  return std::abs(plane.above(p)) < kNear;
}

std::size_t agreement(const GroundPlane& plane, const std::vector<ldm::Point>& points) {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [&](const ldm::Point& p) { return agrees(plane, p); }));
}

/// Through three points; none if they lie almost on a line, seen from above.
std::optional<GroundPlane> through(const ldm::Point& a, const ldm::Point& b, const ldm::Point& c) {
  const Eigen::Vector3f normal = (b - a).cross(c - a);
  constexpr float kThinnest = 0.5F;  // [m^2]: twice the triangle's area
  if (std::abs(normal.z()) < kThinnest) return {};
  GroundPlane plane{-normal.x() / normal.z(), -normal.y() / normal.z(), 0};
  plane.height = plane.above(a);
  return plane;
}

/// Least squares of height over the points that agree with `plane`; at least three of them.
GroundPlane refined(const GroundPlane& plane, const std::vector<ldm::Point>& points) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d heights = Eigen::Vector3d::Zero();
  for (const ldm::Point& p : points) {
    if (!agrees(plane, p)) continue;
    const Eigen::Vector3d row(p.x(), p.y(), 1);
    squares += row * row.transpose();
    heights += row * static_cast<double>(p.z());
  }
  const Eigen::Vector3f solution = squares.ldlt().solve(heights).cast<float>();
  return {solution.x(), solution.y(), solution.z()};
}

}  // namespace

GroundPlaneFit::GroundPlaneFit(const GroundParameters& parameters)
    : radius_(static_cast<float>(parameters.radius)),
      cell_(static_cast<float>(parameters.cell)),
      steepest_(static_cast<float>(std::tan(parameters.max_slope * std::numbers::pi / 180))),
      cells_(static_cast<int>(std::ceil(2 * parameters.radius / parameters.cell))) {
  lowest_of_cell_.resize(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_));
  count_of_cell_.resize(lowest_of_cell_.size());
}

std::optional<GroundPlane> GroundPlaneFit::fit(const std::vector<ldm::Point>& points) {
  find_lowest(points);
  if (lowest_.size() < kMinCells) return {};
  GroundPlane plane = search();
  for (int i = 0; i < kRefinements && agreement(plane, lowest_) >= kMinCells; ++i) {
    plane = refined(plane, lowest_);
  }
  const std::size_t cells = agreement(plane, lowest_);
  if (cells < std::max(kMinCells, lowest_.size() / kMinShare) || !(plane.height < 0)) return {};
  return plane;
}

void GroundPlaneFit::find_lowest(const std::vector<ldm::Point>& points) {
  std::fill(count_of_cell_.begin(), count_of_cell_.end(), 0);
  for (const ldm::Point& p : points) {
    if (std::max(std::abs(p.x()), std::abs(p.y())) >= radius_) continue;
    const int column = std::min(static_cast<int>((p.x() + radius_) / cell_), cells_ - 1);
    const int row = std::min(static_cast<int>((p.y() + radius_) / cell_), cells_ - 1);
    const auto cell = static_cast<std::size_t>(column + row * cells_);
    ldm::Point& lowest = lowest_of_cell_[cell];
    if (count_of_cell_[cell]++ == 0 || p.z() < lowest.z()) lowest = p;
  }
  lowest_.clear();
  for (std::size_t i = 0; i < count_of_cell_.size(); ++i) {
    if (count_of_cell_[i] >= kMinPoints) lowest_.push_back(lowest_of_cell_[i]);
  }
}

GroundPlane GroundPlaneFit::search() const {
  Random random(kKey);
  const auto any = [&]() -> const ldm::Point& { return lowest_[random.bits() % lowest_.size()]; };
  GroundPlane best;
  std::size_t best_agreement = 0;
  for (int i = 0; i < kTrials; ++i) {
    const ldm::Point &a = any(), &b = any(), &c = any();
    const std::optional<GroundPlane> plane = through(a, b, c);
    if (!plane || std::hypot(plane->slope_x, plane->slope_y) > steepest_ || plane->height >= 0) {
      continue;
    }
    const std::size_t cells = agreement(*plane, lowest_);
    if (cells <= best_agreement) continue;
    best = *plane;
    best_agreement = cells;
  }
  return best;
}

}  // namespace datasets
