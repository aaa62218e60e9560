#pragma once
/// How far all that one scan shows is displaced, as its pose is known only so well (no paper
/// section; docs/objects.md).
#include <Eigen/Core>
#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "ldm/objects/motion_filter.h"

namespace ldm {

/// The shift that the objects of a scan have in common: each tells how far it is off the place that
/// it was expected at. How large shifts are is seen in how the ways of all objects bend at once.
class ScanShift {
 public:
  /// Begin the scan of `time` [s].
  void begin(double time);
  /// In this scan object `id`, expected by `motion`, is at `fix`. `motion` is read until `find`.
  void add(std::int64_t id, const MotionFilter& motion, const Fix& fix);
  /// After all were added. Cost: their number.
  void find();

  /// The fix of the i-th that was added, less the shift that all others tell of; what they leave
  /// open makes it less certain. Cost: the number of objects.
  Fix freed(std::size_t i) const;
  /// Of the shifts of late, per axis [m].
  double sigma() const;

 private:
  struct Sighting {
    const MotionFilter* motion;
    Fix fix;
    MotionFilter::Evidence evidence;
  };
  struct Places {
    double time;                                 // [s]
    std::map<std::int64_t, Eigen::Vector2d> of;  // per object [m]
  };
  void note_bend();
  Fix told_by_all_but(std::size_t left_out) const;

  std::vector<Sighting> sightings_;
  std::deque<Places> places_;  // of this scan and the two before
  std::deque<double> bends_;   // of late, squared, over what a shift of variance 1 gives [m^2]
  double variance_ = 0;        // of shifts, per axis [m^2]
};

}  // namespace ldm
