#pragma once
/// What moving objects leave behind in a map (no paper section: the scores are ours).
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "experiments/metrics/truth_grid.h"
#include "ldm/types.h"

namespace experiments {

/// A voxel is left over from the frame on in which no solid holds its centre any more, if in the
/// frame before a moving object held it and the map called it occupied. It stays so until the map
/// once calls it free or unknown (it is cleared), a solid holds it again, or the map leaves it.
///
/// It is a ghost in the frames in which it is left over and no solid is in one of the 26 voxels
/// around it: beside a solid, part of the voxel, or noise of its returns, may rightly be occupied.
class GhostTally {
 public:
  /// Share of what was left that has to be cleared.
  static constexpr double kCleared = 0.9;

  /// Frames in the order of time. Requires `truth` filled for the map's window.
  /// Cost: the voxels of moving objects and those left over.
  void add(double time, const ldm::LocalMap& map, const TruthGrid& truth);
  /// What is still left over was not cleared. Nothing may be added afterwards.
  void finish();

  std::int64_t frames() const { return frames_; }
  std::int64_t ghosts() const { return ghosts_; }  ///< sum over the frames

  /// Time from the last frame in which the object held a voxel until `kCleared` of them are cleared
  /// [s]; those that a solid took again or the map left count until then (Kaplan and Meier, 1958).
  /// None if so many never are, or nothing was left.
  std::optional<double> time_to_clear() const;

 private:
  struct LeftOver {
    ldm::VoxelIndex voxel;
    double held;  ///< last time that the object held it [s]
  };
  struct Ends {
    std::int64_t cleared = 0, lost = 0;
  };

  bool ends(const LeftOver& left, const ldm::LocalMap& map, const TruthGrid& truth);
  Ends& ends_of(const LeftOver& left);

  double time_ = 0;  ///< of the last frame [s]
  std::int64_t frames_ = 0, ghosts_ = 0;
  std::vector<LeftOver> held_;  ///< by a moving object in the last frame, and called occupied
  std::vector<LeftOver> left_;
  std::map<std::int64_t, Ends> ends_;  ///< by age [ms]: memory does not grow with the frames
};

}  // namespace experiments
