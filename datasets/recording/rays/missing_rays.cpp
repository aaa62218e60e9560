#include "datasets/recording/rays/missing_rays.h"

#include <algorithm>
#include <cmath>

namespace datasets {

bool MissingRays::find(const std::vector<ldm::Point>& points, std::vector<ldm::Point>& rays,
                       const LostAzimuths& lost) {
  angles_of(points, returns_);
  lost_ = lost;
  learn();
  if (!pattern_.holds(returns_)) return false;
  draw();
  for (std::size_t ring = 0; ring < pattern_.slopes().size(); ++ring) fill_ring(ring, rays);
  return true;
}

void MissingRays::learn() {
  pattern_.learn(returns_);
  fresh_.learn(returns_);
  if (++fresh_scans_ < kRenewed) return;
  if (fresh_.is_certain() && !pattern_.includes(fresh_)) pattern_ = fresh_;
  fresh_ = RayPattern();
  fresh_scans_ = 0;
}

void MissingRays::draw() {
  columns_ = static_cast<std::size_t>(std::ceil(kTurn / pattern_.step()));
  image_.assign(pattern_.slopes().size() * columns_, {});
  const std::vector<float>& slopes = pattern_.slopes();
  for (const RayAngles& angles : returns_) {
    const std::size_t ring = pattern_.ring_of(angles.slope);
    put(ring, angles);
    // By how much the slope may differ from that of the ring which it is of.
    const float doubt = kBeamOffset / angles.range * (1 + angles.slope * angles.slope);
    for (std::size_t k = ring; k > 0 && slopes[k - 1] > angles.slope - doubt;) put(--k, angles);
    for (std::size_t k = ring + 1; k < slopes.size() && slopes[k] < angles.slope + doubt; ++k) {
      put(k, angles);
    }
  }
}

void MissingRays::put(std::size_t ring, const RayAngles& angles) {
  const auto column = static_cast<std::size_t>((angles.azimuth + kTurn / 2) / pattern_.step());
  Cell& cell = image_[ring * columns_ + std::min(column, columns_ - 1)];
  if (cell.range == 0) {
    cell = {angles.azimuth, angles.azimuth, angles.range};
    return;
  }
  cell.first = std::min(cell.first, angles.azimuth);
  cell.last = std::max(cell.last, angles.azimuth);
  cell.range = std::min(cell.range, angles.range);
}

void MissingRays::fill_ring(std::size_t ring, std::vector<ldm::Point>& rays) const {
  const Cell* const begin = image_.data() + ring * columns_;
  const Cell* const end = begin + columns_;
  const auto used = [](const Cell& cell) { return cell.range > 0; };
  const Cell* const first = std::find_if(begin, end, used);
  if (first == end) {
    const int count = static_cast<int>(std::lround(kTurn / pattern_.step()));
    const double step = static_cast<double>(kTurn) / count;
    return add_rays(ring, -static_cast<double>(kTurn) / 2, step, count, rays);
  }
  const Cell* from = first;
  for (const Cell* to; (to = std::find_if(from + 1, end, used)) != end; from = to) {
    fill_gap(ring, *from, *to, to->first - from->last, rays);
  }
  fill_gap(ring, *from, *first, first->first - from->last + kTurn, rays);
}

void MissingRays::fill_gap(std::size_t ring, const Cell& from, const Cell& to, float width,
                           std::vector<ldm::Point>& rays) const {
  const int count = static_cast<int>(std::lround(width / pattern_.step())) - 1;
  if (count < 1) return;
  const float across = width * std::min(from.range, to.range);  // [m]
  if (across < kSurface && std::abs(from.range - to.range) < across) return;
  const double step = static_cast<double>(width) / (count + 1);
  add_rays(ring, static_cast<double>(from.last) + step, step, count, rays);
}

void MissingRays::add_rays(std::size_t ring, double azimuth, double step, int count,
                           std::vector<ldm::Point>& rays) const {
  const auto slope = static_cast<double>(pattern_.slopes()[ring]);
  const double across = 1 / std::sqrt(1 + slope * slope);
  double x = across * std::cos(azimuth), y = across * std::sin(azimuth);
  const double turn_x = std::cos(step), turn_y = std::sin(step);
  for (int i = 0; i < count; ++i) {
    const double a = azimuth + step * i;
    if (pattern_.in_view(static_cast<float>(a)) && !lost_.contains(a)) {
      rays.push_back(Eigen::Vector3d(x, y, across * slope).cast<float>());
    }
    const double next = x * turn_x - y * turn_y;
    y = x * turn_y + y * turn_x;
    x = next;
  }
}

}  // namespace datasets
