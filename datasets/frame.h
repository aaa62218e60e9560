#pragma once
/// What every data source yields, frame by frame: the scan, and the truth where it is known.
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "datasets/input_counts.h"
#include "ldm/types.h"

namespace datasets {

/// A solid of an obstacle, posed in the world frame. Its local z axis is its axis.
struct Solid {
  enum class Shape : std::uint8_t { kBox, kCylinder, kSphere };
  Shape shape = Shape::kBox;
  ldm::Pose T_world_solid;  ///< centre of the solid
  /// Box: edge lengths. Cylinder: diameter, diameter, height. Sphere: diameter three times. [m]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();

  /// True if p (world frame) lies inside or on the surface.
  bool contains(const Eigen::Vector3d& p) const;
};

/// Truth of one obstacle in one frame.
struct ObjectState {
  std::int32_t id = 0;                                 ///< constant over the log, unique in it
  bool dynamic = false;                                ///< it moves at some time of the log
  Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< centre of its bounding box, world [m]
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();  ///< world [m/s]
  Eigen::Vector3d acceleration = Eigen::Vector3d::Zero();  ///< world [m/s^2]
  Eigen::Vector3d size = Eigen::Vector3d::Zero();          ///< of its bounding box, world axes [m]
  std::vector<Solid> solids;
};

struct Truth {
  std::vector<ObjectState> objects;  ///< sorted by id
  /// Where the scan's rays meet obstacles, one for each of its points, in their order, world [m].
  std::vector<ldm::Point> noise_free_hits;
};

/// Which points of a scan as it was recorded are left.
struct KeptPoints {
  std::size_t recorded = 0;        ///< their number before
  std::vector<std::uint32_t> was;  ///< per point of the scan its position among those, upwards
};

struct Frame {
  std::int64_t index = 0;  ///< from 0
  ldm::Scan scan;
  /// The world's origin of a recording in coordinates as large as a country's grid: everything of
  /// the frame is relative to it, since maps and clusters are floats. [m]
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::optional<Truth> truth;
  std::optional<KeptPoints> kept;  ///< of a scan that was filtered
};

/// `origin_m 500000.25 5400000 0`, for files whose coordinates are relative to it; empty for 0.
std::string origin_text(const Frame& frame);

/// A scenario being simulated, or a log being read. Frames stream: memory does not grow.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  /// Fill `frame` with the next one (its memory is reused); false after the last.
  /// @throws ldm::InvalidInput naming file and place where a log is broken.
  virtual bool next(Frame& frame) = 0;
  /// Number of frames in all, where known beforehand.
  virtual std::optional<std::int64_t> size() const = 0;
  /// What was left out until now; of a scenario or a log of our own, nothing.
  virtual InputCounts counts() const { return {}; }
};

/// Which object owns each voxel of `window`: position in `truth.objects`, or -1 for free space.
/// A voxel belongs to the first object that contains its centre. Output in window order.
void solid_voxels(const Truth& truth, const ldm::VoxelBox& window, double resolution,
                  std::vector<std::int32_t>& object_of_voxel);

/// Set of the voxels of `window` that noise-free rays hit (1) or not (0). Output in window order.
void visible_voxels(const Truth& truth, const ldm::VoxelBox& window, double resolution,
                    std::vector<std::uint8_t>& visible);

}  // namespace datasets
