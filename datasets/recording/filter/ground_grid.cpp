#include "datasets/recording/filter/ground_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace datasets {
namespace {

constexpr float kNoPoint = std::numeric_limits<float>::infinity();

}  // namespace

GroundGrid::GroundGrid(const GroundParameters& parameters)
    : cell_(static_cast<float>(parameters.cell)),
      step_(static_cast<float>(std::tan(parameters.max_slope * std::numbers::pi / 180) *
                               parameters.cell)),
      cells_(static_cast<int>(std::ceil(2 * kReach / cell_))) {
  const auto count = static_cast<std::size_t>(cells_) * static_cast<std::size_t>(cells_);
  lowest_.resize(count);
  ground_.resize(count);
  rank_.resize(count);
  outwards_.resize(count);
  std::iota(outwards_.begin(), outwards_.end(), 0);
  const auto squared_distance = [this](std::int32_t cell) {  // in half cells: whole numbers
    const int x = 2 * (cell % cells_) + 1 - cells_, y = 2 * (cell / cells_) + 1 - cells_;
    return x * x + y * y;
  };
  std::stable_sort(outwards_.begin(), outwards_.end(), [&](std::int32_t a, std::int32_t b) {
    return squared_distance(a) < squared_distance(b);
  });
  for (std::size_t i = 0; i < count; ++i) {
    rank_[static_cast<std::size_t>(outwards_[i])] = static_cast<std::int32_t>(i);
  }
}

std::size_t GroundGrid::cell_of(const ldm::Point& p) const {
  const auto along = [this](float x) {
    return static_cast<int>(std::clamp((x + kReach) / cell_, 0.0F, static_cast<float>(cells_ - 1)));
  };
  return static_cast<std::size_t>(along(p.x()) + along(p.y()) * cells_);
}

void GroundGrid::fit(const GroundPlane& plane, const std::vector<ldm::Point>& points) {
  plane_ = plane;
  std::fill(lowest_.begin(), lowest_.end(), kNoPoint);
  for (const ldm::Point& p : points) {
    if (std::max(std::abs(p.x()), std::abs(p.y())) >= kReach) continue;
    float& lowest = lowest_[cell_of(p)];
    lowest = std::min(lowest, plane_.above(p));
  }
  for (const std::int32_t cell : outwards_) {
    const auto i = static_cast<std::size_t>(cell);
    const float expected = of_neighbours(cell);
    ground_[i] = std::abs(lowest_[i] - expected) <= step_ ? lowest_[i] : expected;
  }
}

/// Mean of the ground of those neighbours that lie nearer to the sensor; the first cell has none
/// and lies on the plane.
float GroundGrid::of_neighbours(std::int32_t cell) const {
  const int column = cell % cells_, row = cell / cells_;
  float sum = 0;
  int count = 0;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, cells_ - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, cells_ - 1); ++x) {
      const auto i = static_cast<std::size_t>(x + y * cells_);
      if (rank_[i] >= rank_[static_cast<std::size_t>(cell)]) continue;
      sum += ground_[i];
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<float>(count) : 0;
}

float GroundGrid::above(const ldm::Point& p) const {
  // Between the centres of four cells, bilinearly.
  const float last = static_cast<float>(cells_ - 1);
  const float x = std::clamp((p.x() + kReach) / cell_ - 0.5F, 0.0F, last);
  const float y = std::clamp((p.y() + kReach) / cell_ - 0.5F, 0.0F, last);
  const int left = std::min(static_cast<int>(x), cells_ - 2);
  const int low = std::min(static_cast<int>(y), cells_ - 2);
  const float u = x - static_cast<float>(left), v = y - static_cast<float>(low);
  const float* const at = &ground_[static_cast<std::size_t>(left + low * cells_)];
  const float ground =
      (1 - v) * ((1 - u) * at[0] + u * at[1]) + v * ((1 - u) * at[cells_] + u * at[cells_ + 1]);
  return plane_.above(p) - ground;
}

}  // namespace datasets
