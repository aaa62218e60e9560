#include "ldm/objects/registration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace ldm {
namespace {

constexpr double kRangeSigma = 0.02;  // of one return [m]
constexpr double kSpotSigma = 0.003;  // of a surface that many returns were averaged to [m]
// How well surfaces and edges repeat from view to view: [m], and of the object's width.
constexpr double kRoughness = 0.005, kRoughnessShare = 0.015;
// Along the surface, what a normal is fitted to: [m], and of the width.
constexpr double kNeighbours = 0.07, kNeighboursShare = 0.1;
// The way of the centre: [m]; of the width, as what is long is no circle; of a change in width; and
// where an end is hidden, [m] and of the width.
constexpr double kCentre = 0.01, kCentreShare = 0.03, kCentreOfChange = 1;
constexpr double kHidden = 0.05, kHiddenShare = 0.5;

constexpr double kCauchy = 3;          // standard deviations from which a residual counts less
constexpr double kMostMisfit = 25;     // variances
constexpr double kUsualMisfit = 0.5;   // variances: above it a fit becomes less certain,
constexpr double kMisfitPower = 3;     // so quickly
constexpr double kCentreInCost = 0.1;  // against the misfit
constexpr double kNoCentre = 1;        // its inverse variance where it is left out [1/m^2]
constexpr int kIterations = 6;
constexpr double kConverged = 1e-4;  // [m]

Outline::Spot spot_at(const View& view, const Slice& slice, std::size_t i) {
  const std::vector<Column>& columns = slice.columns;
  const Column& column = columns[i];
  const double step = slice.spacing() * column.range;
  const double reach = std::max({kNeighbours, kNeighboursShare * view.width(), 1.5 * step});
  const auto near = [&](std::size_t j) { return (columns[j].point - column.point).norm() < reach; };
  std::size_t first = i, last = i;
  while (first > 0 && near(first - 1)) --first;
  while (last + 1 < columns.size() && near(last + 1)) ++last;

  double weight = 0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (std::size_t j = first; j <= last; ++j) {
    weight += columns[j].returns;
    mean += columns[j].returns * columns[j].point;
  }
  mean /= weight;
  Eigen::Vector2d normal = (column.point - view.sensor) / column.range;
  if (last - first >= 2) {
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (std::size_t j = first; j <= last; ++j) {
      const Eigen::Vector2d r = columns[j].point - mean;
      spread += columns[j].returns * r * r.transpose();
    }
    normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(spread).eigenvectors().col(0);
  }
  return {.point = column.point + normal * normal.dot(mean - column.point),
          .normal = normal,
          .reach = std::max(0.03, 1.5 * step),
          .variance = kRangeSigma * kRangeSigma / weight + kSpotSigma * kSpotSigma};
}

double square(double x) {
  return x * x;
}

/// Normal equations of a least-squares step; residuals beyond the bound count less.
class Step {
 public:
  /// @param bound [standard deviations]
  explicit Step(double bound) : bound_(bound) {}

  void add(const Eigen::Vector2d& direction, double residual, double variance) {
    const double squared = residual * residual / variance;
    const double weight = 1 / (1 + squared / square(bound_)) / variance;
    information_ += weight * direction * direction.transpose();
    gradient_ += weight * residual * direction;
    misfit_ += std::min(squared, kMostMisfit);
    ++terms_;
  }
  const Eigen::Matrix2d& information() const { return information_; }
  const Eigen::Vector2d& gradient() const { return gradient_; }
  double misfit() const { return terms_ > 0 ? misfit_ / terms_ : kMostMisfit; }

 private:
  double bound_;
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d gradient_ = Eigen::Vector2d::Zero();
  double misfit_ = 0;
  int terms_ = 0;
};

void add_surface(std::span<const Outline::Spot> spots, const View& view, const Slice& slice,
                 const Eigen::Vector2d& displacement, Step& step) {
  const double roughness = square(kRoughness + kRoughnessShare * view.width());
  for (const Column& column : slice.columns) {
    const Eigen::Vector2d p = column.point - displacement;
    const auto nearest =
        std::min_element(spots.begin(), spots.end(), [&](const auto& a, const auto& b) {
          return (a.point - p).squaredNorm() < (b.point - p).squaredNorm();
        });
    const Eigen::Vector2d r = p - nearest->point;
    const double across = nearest->normal.dot(r);
    if (r.squaredNorm() - square(across) > square(nearest->reach)) continue;
    const double cosine = nearest->normal.dot(column.point - view.sensor) / column.range;
    step.add(nearest->normal, across,
             square(kRangeSigma * cosine) / column.returns + roughness + nearest->variance);
  }
}

void add_edges(const View& view, const Slice& now, const Slice& then,
               const Eigen::Vector2d& displacement, Step& step) {
  const double roughness = square(kRoughness + kRoughnessShare * view.width());
  for (const std::size_t side : {0, 1}) {
    if (!now.edges[side] || !then.edges[side]) continue;
    const Column& a = side == 0 ? now.columns.front() : now.columns.back();
    const Column& b = side == 0 ? then.columns.front() : then.columns.back();
    const Eigen::Vector2d sight = (a.point - view.sensor) / a.range;
    const Eigen::Vector2d across(-sight.y(), sight.x());
    // The edge is anywhere within a column's width: variance width^2 / 12.
    step.add(
        across, across.dot(a.point - displacement - b.point),
        (square(now.spacing() * a.range) + square(then.spacing() * b.range)) / 12 + 2 * roughness);
  }
}

void add_slices(const Outline& outline, const View& view, const Eigen::Vector2d& displacement,
                Step& step) {
  std::size_t o = 0;
  for (const Slice& slice : view.slices) {
    const std::vector<Slice>& then = outline.view.slices;
    while (o < then.size() && then[o].level < slice.level) ++o;
    if (o == then.size()) break;
    if (then[o].level != slice.level) continue;
    add_surface(outline.spots[o], view, slice, displacement, step);
    add_edges(view, slice, then[o], displacement, step);
  }
}

/// Inverse variance of the displacement of the centre [1/m^2].
double centre_information(const View& now, const View& then) {
  double sigma =
      kCentre + kCentreShare * now.width() + kCentreOfChange * std::abs(now.width() - then.width());
  if (!now.whole() || !then.whole()) sigma += kHidden + kHiddenShare * now.width();
  return 1 / square(sigma);
}

}  // namespace

Outline outline_of(const View& view) {
  Outline outline{.view = view, .spots = {}};
  for (const Slice& slice : view.slices) {
    std::vector<Outline::Spot>& spots = outline.spots.emplace_back();
    for (std::size_t i = 0; i < slice.columns.size(); ++i) spots.push_back(spot_at(view, slice, i));
  }
  return outline;
}

Displacement registered(const Outline& outline, const View& view, const Eigen::Vector2d& guess,
                        const Ingredients& ingredients) {
  const Eigen::Vector2d centre = view.centre() - outline.view.centre();
  const double of_centre = ingredients.centre ? centre_information(view, outline.view) : kNoCentre;
  const Eigen::Matrix2d prior = of_centre * Eigen::Matrix2d::Identity();
  Displacement d;
  d.value = guess;
  double scale = 4;  // of the bound: from coarse to fine
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    Step step(kCauchy * scale);
    if (ingredients.outline) add_slices(outline, view, d.value, step);
    d.misfit = step.misfit();
    d.information =
        step.information() / std::max(1.0, std::pow(d.misfit / kUsualMisfit, kMisfitPower)) + prior;
    d.cost = d.misfit + kCentreInCost * of_centre * (d.value - centre).squaredNorm();
    const Eigen::Vector2d move =
        (step.information() + prior).ldlt().solve(step.gradient() + of_centre * (centre - d.value));
    d.value += move;
    if (scale == 1 && move.norm() < kConverged) break;
    scale = std::max(1.0, scale / 2);
  }
  return d;
}

}  // namespace ldm
