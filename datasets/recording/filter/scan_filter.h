#pragma once
/// What of a recorded scan a mapper is given: no vehicle, no ground, nothing out of range (paper
/// Sec. 4.2.1: ground returns are ignored).
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "datasets/frame.h"
#include "datasets/recording/filter/ground_removal.h"
#include "datasets/recording/rays/gap_rays.h"
#include "datasets/recording/rays/missing_rays.h"
#include "datasets/recording/scans/input_parameters.h"

namespace datasets {

/// What of rays without a return is left to find in a source's scans.
enum class RaysToFind {
  kAll,
  kOfGaps,  ///< the source has looked for a pattern, before it moved the points
  kNone,    ///< the source knows as well where nothing was measured
};

/// Another source's frames, with fewer points, and rays without a return that it does not have.
class ScanFilter : public FrameSource {
 public:
  ScanFilter(std::unique_ptr<FrameSource> source, const InputParameters& parameters,
             RaysToFind rays = RaysToFind::kAll);

  /// Points keep their order. To `no_returns` come rays to points beyond input.max_range_m and, if
  /// the source has none, those that MissingRays or GapRays find, as input.no_returns says; and
  /// those that end on the ground, if input.ground.rays = free.
  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return source_->size(); }
  /// The source's, and points by the reason for which they were dropped.
  InputCounts counts() const override;

 private:
  void find_no_returns(ldm::Scan& scan);
  void drop_out_of_place(Frame& frame);
  void drop_ground(Frame& frame);

  std::unique_ptr<FrameSource> source_;
  InputParameters parameters_;
  RaysToFind rays_;
  GapRays gap_rays_;
  MissingRays missing_rays_;
  std::optional<GroundFinder> ground_;
  std::vector<std::uint8_t> is_ground_;
  struct Counts {
    std::int64_t not_finite = 0, near = 0, far = 0, on_vehicle = 0, on_ground = 0, no_ground = 0,
                 no_pattern = 0;
  } counts_;
};

}  // namespace datasets
