#include "datasets/recording/rays/gap_rays.h"

#include <algorithm>
#include <cmath>

namespace datasets {
namespace {

constexpr float kDegree = kTurn / 360;
constexpr float kPixel = 0.5F * kDegree;
constexpr int kRows = 360, kColumns = 720;  // 180 by 360 degrees
constexpr int kAcross = static_cast<int>(GapRays::kAround * kDegree / kPixel);
constexpr int kInView = 60;  // 30 degrees
constexpr std::size_t kFewestReturns = 1000;
constexpr int kFarthestRings = 12;  // 6 degrees

int wrapped(int column) {
  return (column + kColumns) % kColumns;
}

float nearer(float a, float b) {
  if (a == 0 || b == 0) return std::max(a, b);
  return std::min(a, b);
}

}  // namespace

float& GapRays::range_at(int row, int column) {
  return image_[static_cast<std::size_t>(row * kColumns + column)];
}

bool GapRays::find(const std::vector<ldm::Point>& points, std::vector<ldm::Point>& rays) {
  angles_of(points, returns_);
  if (returns_.size() < kFewestReturns) return false;
  draw();
  const int distance = usual_distance();
  if (distance == 0) return false;
  spread((3 * distance + 1) / 2);
  for (int row = lowest_; row <= highest_; ++row) fill_row(row, rays);
  return true;
}

void GapRays::draw() {
  image_.assign(static_cast<std::size_t>(kRows * kColumns), 0);
  view_.assign(static_cast<std::size_t>(kColumns), 0);
  std::vector<std::size_t> of_row(static_cast<std::size_t>(kRows));
  for (const RayAngles& angles : returns_) {
    const int row =
        std::clamp(static_cast<int>((std::atan(angles.slope) + kTurn / 4) / kPixel), 0, kRows - 1);
    const int column =
        std::clamp(static_cast<int>((angles.azimuth + kTurn / 2) / kPixel), 0, kColumns - 1);
    range_at(row, column) = nearer(range_at(row, column), angles.range);
    view_[static_cast<std::size_t>(column)] = 1;
    ++of_row[static_cast<std::size_t>(row)];
  }
  const std::size_t outermost = returns_.size() / 100;
  std::size_t below = 0, above = 0;
  for (lowest_ = 0; (below += of_row[static_cast<std::size_t>(lowest_)]) <= outermost;) ++lowest_;
  for (highest_ = kRows - 1; (above += of_row[static_cast<std::size_t>(highest_)]) <= outermost;) {
    --highest_;
  }
}

/// In rows between two returns above each other, that of nine in ten; 0 if few are.
int GapRays::usual_distance() const {
  std::vector<int> of_distance(static_cast<std::size_t>(kFarthestRings) + 1);
  int all = 0;
  for (int column = 0; column < kColumns; ++column) {
    int last = -kRows;
    for (int row = lowest_; row <= highest_; ++row) {
      if (image_[static_cast<std::size_t>(row * kColumns + column)] == 0) continue;
      if (row - last <= kFarthestRings) {
        ++of_distance[static_cast<std::size_t>(row - last)];
        ++all;
      }
      last = row;
    }
  }
  if (static_cast<std::size_t>(all) < kFewestReturns / 4) return 0;
  int most = 0;
  for (int distance = 1; distance <= kFarthestRings; ++distance) {
    most += of_distance[static_cast<std::size_t>(distance)];
    if (10 * most >= 9 * all) return distance;
  }
  return 0;
}

void GapRays::spread(int rows) {
  // Along the rows, then along the columns.
  std::vector<float> along(image_.size());
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float range = range_at(row, column);
      if (range == 0) continue;
      for (int k = -kAcross; k <= kAcross; ++k) {
        float& other = along[static_cast<std::size_t>(row * kColumns + wrapped(column + k))];
        other = nearer(other, range);
      }
    }
  }
  spread_.assign(image_.size(), 0);
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const float range = along[static_cast<std::size_t>(row * kColumns + column)];
      if (range == 0) continue;
      for (int r = std::max(row - rows, 0); r <= std::min(row + rows, kRows - 1); ++r) {
        float& other = spread_[static_cast<std::size_t>(r * kColumns + column)];
        other = nearer(other, range);
      }
    }
  }
}

void GapRays::fill_row(int row, std::vector<ldm::Point>& rays) const {
  const float* const ranges = spread_.data() + row * kColumns;
  const float* const used = std::find_if(ranges, ranges + kColumns, [](float r) { return r > 0; });
  const int start = used == ranges + kColumns ? 0 : static_cast<int>(used - ranges);
  const float elevation = (static_cast<float>(row) + 0.5F) * kPixel - kTurn / 4;
  for (int k = 0; k < kColumns;) {
    if (ranges[wrapped(start + k)] > 0) {
      ++k;
      continue;
    }
    int end = k;
    while (end < kColumns && ranges[(start + end) % kColumns] == 0) ++end;
    const float from = ranges[wrapped(start + k - 1)], to = ranges[(start + end) % kColumns];
    const float across = static_cast<float>(end - k + 2 * kAcross) * kPixel * std::min(from, to);
    const bool surface = across < kSurface && std::abs(from - to) < across;
    for (; k < end; ++k) {
      const int column = (start + k) % kColumns;
      if (surface || !in_view(column)) continue;
      const float azimuth = (static_cast<float>(column) + 0.5F) * kPixel - kTurn / 2;
      rays.emplace_back(std::cos(elevation) * std::cos(azimuth),
                        std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
    }
  }
}

bool GapRays::in_view(int column) const {
  for (int k = -kInView; k <= kInView; ++k) {
    if (view_[static_cast<std::size_t>(wrapped(column + k))] != 0) return true;
  }
  return false;
}

}  // namespace datasets
