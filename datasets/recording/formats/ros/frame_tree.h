#pragma once
/// The frames of a recording and where they are in each other, as ROS's TF tells (no paper
/// section).
#include <map>
#include <optional>
#include <string>

#include "datasets/recording/formats/ros/transform_messages.h"

namespace datasets {

/// A frame as its ancestors see it at one time.
struct FramePlace {
  ldm::Pose T_root_frame;
  ldm::Pose T_root_vehicle;  ///< the first ancestor that moves; without one, the frame itself
};

class FrameTree {
 public:
  /// @param fixed of /tf_static: valid at all times; else poses in the order of their times, of
  /// which those that go back are left out.
  void add(const StampedTransform& transform, bool fixed);

  /// Frames that move in their parents on the way from `frame` to the root: none if it does not
  /// move at all.
  bool moves(const std::string& frame) const;
  /// The root of the tree that `frame` is in; itself if it has no parent.
  std::string root_of(const std::string& frame) const;
  /// True if the way up leads to `root`, and what moves on it has poses at `time` or later.
  bool covers(const std::string& frame, const std::string& root, double time) const;

  /// @param longest_gap between two poses that is bridged [s]
  /// @return none if there is no pose at that time, of which `gap` then says where
  std::optional<FramePlace> at(const std::string& frame, const std::string& root, double time,
                               double longest_gap, std::string& gap);
  /// T_ancestor_frame where nothing moves between; none if it is no such ancestor.
  std::optional<ldm::Pose> fixed_between(const std::string& ancestor,
                                         const std::string& frame) const;
  /// A frame on the way up from `frame` that has two parents, as `a: b, c`; else empty.
  std::string conflict(const std::string& frame) const;

 private:
  /// From a frame to its parent.
  struct Edge {
    std::string parent;
    bool fixed = false;
    ldm::Pose pose;  ///< if fixed
    PoseTrack track;
    std::string other_parent;  ///< of a conflicting transform
  };
  static constexpr int kDeepest = 64;  ///< a longer way up is a circle

  const Edge* edge(const std::string& frame) const;

  std::map<std::string, Edge> edges_;  ///< by child
};

}  // namespace datasets
