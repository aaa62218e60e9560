#pragma once
/// What of a recorded scan a mapper is given: no vehicle, no ground, nothing out of range (paper
/// Sec. 4.2.1: ground returns are ignored).
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "datasets/frame.h"
#include "datasets/recording/filter/ground_removal.h"
#include "datasets/recording/scans/input_parameters.h"

namespace datasets {

/// Another source's frames, with fewer points.
class ScanFilter : public FrameSource {
 public:
  ScanFilter(std::unique_ptr<FrameSource> source, const InputParameters& parameters);

  /// Points keep their order. Rays that end on the ground join `no_returns` if
  /// input.ground.rays = free.
  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return source_->size(); }
  /// The source's, and points by the reason for which they were dropped.
  InputCounts counts() const override;

 private:
  void drop_out_of_place(ldm::Scan& scan);
  void drop_ground(ldm::Scan& scan);

  std::unique_ptr<FrameSource> source_;
  InputParameters parameters_;
  std::optional<GroundFinder> ground_;
  std::vector<std::uint8_t> is_ground_;
  struct Counts {
    std::int64_t not_finite = 0, near = 0, far = 0, on_vehicle = 0, on_ground = 0, no_ground = 0;
  } counts_;
};

}  // namespace datasets
