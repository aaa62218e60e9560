#pragma once
/// How well the clusters of a run fit a reference, object by object (in the manner of Sec. 4.2 of
/// the paper; the rule is ours: docs/scores.md).
#include <map>
#include <vector>

#include "experiments/metrics/mean.h"
#include "experiments/runs/run_folder.h"
#include "experiments/runs/truth_table.h"

namespace experiments {

/// Of one object, or of several together.
struct ObjectScore {
  std::int64_t objects = 0;
  std::int64_t frames = 0;    ///< in which its centre was in the map
  Mean position_error;        ///< of the matched cluster's centroid, frame by frame [m]
  Mean velocity_error;        ///< norm of the difference [m/s]
  std::int64_t tracks = 0;    ///< different ones
  std::int64_t switches = 0;  ///< matched frames with another track than the one before, in a stay

  std::int64_t matched() const { return velocity_error.count(); }
};

struct TruthScore {
  std::int64_t frames = 0;   ///< judged: in the run and in the reference
  std::int64_t not_run = 0;  ///< frames of the reference that are not in the run
  /// Objects that were in the map, by id.
  struct Object {
    bool dynamic = false;
    ObjectScore score;
  };
  std::map<std::int64_t, Object> objects;
  ObjectScore of_static, of_dynamic;
  Mean recall;     ///< 1 per moving object with a dynamic cluster, 0 per other one, in the map
  Mean precision;  ///< 1 per dynamic cluster that stands for a moving object, 0 per other one
  std::int64_t dynamic_without_object = 0;  ///< dynamic clusters matched with no object
  std::int64_t dynamic_on_static = 0;       ///< with one that never moves
};

/// In each frame one cluster at most for each object, nearest centres first.
/// @param gate a cluster's centroid lies in the object's box or so near to it [m]
/// @throws ldm::InvalidInput if no frame is in both, or if their times differ by more than 1 ms.
TruthScore score(const std::map<std::int64_t, RunFrame>& run, const TruthTable& truth, double gate);

}  // namespace experiments
