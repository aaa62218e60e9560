#include "ldm/objects/scan_shift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ldm {
namespace {

constexpr std::size_t kScans = 30;      // that the size of shifts is found from: a few seconds
constexpr std::size_t kLeastScans = 5;  // from fewer nothing is concluded
constexpr double kLeastSigma = 0.001;   // [m]: below what registration can see
constexpr int kIterations = 3;          // which object turns, and how large the shift is
constexpr double kMedianOfChiSquare = 1.386;  // of two numbers
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

}  // namespace

void ScanShift::begin(double time) {
  sightings_.clear();
  places_.push_back({time, {}});
  if (places_.size() > 3) places_.pop_front();
}

void ScanShift::add(std::int64_t id, const MotionFilter& motion, const Fix& fix) {
  sightings_.push_back({&motion, fix, {}});
  places_.back().of[id] = fix.position;
}

/// How the way from the scan before the last to this one bends: the median over objects, as what
/// turns or brakes does so alone.
void ScanShift::note_bend() {
  if (places_.size() < 3 || places_[1].time <= places_[0].time) return;
  const double steps = (places_[2].time - places_[1].time) / (places_[1].time - places_[0].time);
  std::vector<double> x, y;
  for (const auto& [id, now] : places_[2].of) {
    const auto last = places_[1].of.find(id), first = places_[0].of.find(id);
    if (last == places_[1].of.end() || first == places_[0].of.end()) continue;
    const Eigen::Vector2d bend = now - last->second - steps * (last->second - first->second);
    x.push_back(bend.x());
    y.push_back(bend.y());
  }
  if (x.empty()) return;
  const double of_one = 1 + (1 + steps) * (1 + steps) + steps * steps;  // three independent shifts
  bends_.push_back((median(x) * median(x) + median(y) * median(y)) / of_one);
  if (bends_.size() > kScans) bends_.pop_front();
}

void ScanShift::find() {
  note_bend();
  variance_ = kLeastSigma * kLeastSigma;
  if (bends_.size() >= kLeastScans) {
    variance_ = std::max(variance_, median({bends_.begin(), bends_.end()}) / kMedianOfChiSquare);
  }
  Fix shift;
  shift.covariance = variance_ * Eigen::Matrix2d::Identity();
  for (int i = 0; i < kIterations; ++i) {
    for (Sighting& s : sightings_) s.evidence = s.motion->evidence(s.fix, shift);
    shift = told_by_all_but(kNone);
  }
}

Fix ScanShift::told_by_all_but(std::size_t left_out) const {
  Eigen::Matrix2d information = Eigen::Matrix2d::Identity() / variance_;
  Eigen::Vector2d vector = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < sightings_.size(); ++i) {
    if (i == left_out) continue;
    information += sightings_[i].evidence.information;
    vector += sightings_[i].evidence.vector;
  }
  Fix shift;
  shift.covariance = information.inverse();
  shift.position = shift.covariance * vector;
  return shift;
}

Fix ScanShift::freed(std::size_t i) const {
  const Fix& fix = sightings_[i].fix;
  const Fix shift = told_by_all_but(i);
  return {fix.position - shift.position, fix.covariance + shift.covariance};
}

double ScanShift::sigma() const {
  return std::sqrt(variance_);
}

}  // namespace ldm
