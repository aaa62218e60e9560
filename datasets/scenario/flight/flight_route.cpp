#include "datasets/scenario/flight/flight_route.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "datasets/scenario/flight/keep_out.h"

namespace datasets {
namespace {

constexpr int kHalfWidth = 10;  // of the window of cells around the polyline
constexpr int kWidth = 2 * kHalfWidth + 1;
constexpr int kCells = kWidth * kWidth;
constexpr int kReach = 3;        // cells the UAV crosses in a step at its speed limit
constexpr double kMargin = 0.3;  // kept beyond the clearance [m], for the corners cut
// Costs, a step each. Their ratios matter alone: a keep-out outweighs any way round it, and it is
// cheaper to fly beside the polyline for a while than to change to and fro.
constexpr double kOffsetCost = 0.05;  // [1/m^2] of the distance from the polyline
constexpr double kMoveCost = 1;       // [1/m^2] of the motion relative to the polyline's
constexpr double kKeepOutCost = 300;  // [1/m^2] of the depth in a keep-out and its clearance

struct Move {
  int x = 0, y = 0;
};

std::vector<Move> moves_within_reach() {
  std::vector<Move> moves;
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      if (x * x + y * y <= kReach * kReach) moves.push_back({x, y});
    }
  }
  return moves;
}

/// The cells that the walk may use at one step: a square of the world's grid, around the polyline.
struct Window {
  Eigen::Vector3d centre;  // point of the polyline [m]
  int x0 = 0, y0 = 0;      // lowest cell

  Window(const Eigen::Vector3d& polyline_point, double cell)
      : centre(polyline_point),
        x0(static_cast<int>(std::lround(centre.x() / cell)) - kHalfWidth),
        y0(static_cast<int>(std::lround(centre.y() / cell)) - kHalfWidth) {}

  Eigen::Vector3d position(int x, int y, double cell) const {
    return {(x0 + x) * cell, (y0 + y) * cell, centre.z()};
  }
};

/// Cost of being at p at one sample.
double stay_cost(const FlightTask& task, const Window& window, std::size_t sample,
                 const Eigen::Vector3d& p) {
  double cost = kOffsetCost * (p - window.centre).squaredNorm();
  for (const KeepOut& keep_out : task.keep_outs) {
    const double depth = task.clearance + kMargin - signed_distance(keep_out, sample, p).value;
    if (depth > 0) cost += kKeepOutCost * depth * depth;
  }
  return cost;
}

/// Cheapest cost of a walk to each cell of one window, and the move that led there.
struct Layer {
  std::vector<double> cost = std::vector<double>(kCells, std::numeric_limits<double>::infinity());
  std::vector<std::uint8_t> move = std::vector<std::uint8_t>(kCells, 0);
};

/// The layer that follows `from`, before the cost of staying in its cells.
Layer relax(const Layer& from, const Window& from_window, const Window& to_window, double cell,
            const std::vector<Move>& moves) {
  const Eigen::Vector2d advance = (to_window.centre - from_window.centre).head<2>();
  Layer to;
  for (std::size_t m = 0; m < moves.size(); ++m) {
    const Eigen::Vector2d shift(moves[m].x * cell, moves[m].y * cell);
    const double move_cost = kMoveCost * (shift - advance).squaredNorm();
    // Cell (x, y) of the new window is cell (x + dx, y + dy) of the old one, before the move.
    const int dx = to_window.x0 - from_window.x0 - moves[m].x;
    const int dy = to_window.y0 - from_window.y0 - moves[m].y;
    for (int y = std::max(0, -dy); y < std::min(kWidth, kWidth - dy); ++y) {
      for (int x = std::max(0, -dx); x < std::min(kWidth, kWidth - dx); ++x) {
        const auto target = static_cast<std::size_t>(y * kWidth + x);
        const auto source = static_cast<std::size_t>((y + dy) * kWidth + x + dx);
        const double cost = from.cost[source] + move_cost;
        if (cost < to.cost[target]) {
          to.cost[target] = cost;
          to.move[target] = static_cast<std::uint8_t>(m);
        }
      }
    }
  }
  return to;
}

/// Follow the moves back from the cheapest cell of the last layer.
std::vector<Eigen::Vector3d> walk_back(const std::vector<Layer>& layers,
                                       const std::vector<Window>& windows, double cell,
                                       const std::vector<Move>& moves) {
  const std::vector<double>& last = layers.back().cost;
  const auto end = static_cast<int>(std::min_element(last.begin(), last.end()) - last.begin());
  int x = end % kWidth + windows.back().x0;
  int y = end / kWidth + windows.back().y0;
  std::vector<Eigen::Vector3d> positions(layers.size());
  for (std::size_t k = layers.size(); k-- > 0;) {
    const int in_window_x = x - windows[k].x0, in_window_y = y - windows[k].y0;
    positions[k] = windows[k].position(in_window_x, in_window_y, cell);
    const Move& move =
        moves[layers[k].move[static_cast<std::size_t>(in_window_y * kWidth + in_window_x)]];
    x -= move.x;
    y -= move.y;
  }
  return positions;
}

}  // namespace

std::vector<TimedWaypoint> time_waypoints(const FlightTask& task) {
  std::vector<TimedWaypoint> timed{{0, task.waypoints.front()}};
  for (std::size_t i = 1; i < task.waypoints.size(); ++i) {
    const double leg = (task.waypoints[i] - task.waypoints[i - 1]).norm();
    timed.push_back({timed.back().time + leg, task.waypoints[i]});
  }
  const double length = timed.back().time;
  const double last = static_cast<double>(timed.size() - 1);
  for (std::size_t i = 1; i < timed.size(); ++i) {
    const double share = length > 0 ? timed[i].time / length : static_cast<double>(i) / last;
    timed[i].time = task.duration * share;
  }
  return timed;
}

Eigen::Vector3d on_polyline(const std::vector<TimedWaypoint>& waypoints, double t) {
  const auto after = std::find_if(waypoints.begin(), waypoints.end(),
                                  [t](const TimedWaypoint& waypoint) { return waypoint.time > t; });
  if (after == waypoints.begin()) return waypoints.front().position;
  if (after == waypoints.end()) return waypoints.back().position;
  const TimedWaypoint& before = *(after - 1);
  const double share = (t - before.time) / (after->time - before.time);
  return before.position + share * (after->position - before.position);
}

std::vector<Eigen::Vector3d> route(const FlightTask& task,
                                   const std::vector<TimedWaypoint>& waypoints, double step,
                                   std::size_t steps) {
  const double cell = task.max_speed * step / kReach;
  const std::size_t last_sample = sample_count(task) - 1;
  const std::vector<Move> moves = moves_within_reach();
  std::vector<Window> windows;
  std::vector<Layer> layers;
  for (std::size_t k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) * step;
    const auto sample = static_cast<std::size_t>(std::lround(t / task.sample_step));
    windows.emplace_back(on_polyline(waypoints, t), cell);
    Layer layer;
    if (k == 0) {
      std::fill(layer.cost.begin(), layer.cost.end(), 0.0);
    } else {
      layer = relax(layers.back(), windows[k - 1], windows[k], cell, moves);
    }
    for (int i = 0; i < kCells; ++i) {
      const Eigen::Vector3d p = windows[k].position(i % kWidth, i / kWidth, cell);
      layer.cost[static_cast<std::size_t>(i)] +=
          stay_cost(task, windows[k], std::min(sample, last_sample), p);
    }
    layers.push_back(std::move(layer));
  }
  return walk_back(layers, windows, cell, moves);
}

}  // namespace datasets
