#include "datasets/recording/formats/ros/frame_tree.h"

#include "datasets/quaternion_pose.h"

namespace datasets {

void FrameTree::add(const StampedTransform& transform, bool fixed) {
  if (transform.child == transform.parent) return;
  const auto [found, is_new] = edges_.try_emplace(transform.child);
  Edge& edge = found->second;
  if (is_new) {
    edge.parent = transform.parent;
    edge.fixed = fixed;
  } else if (edge.parent != transform.parent) {
    edge.other_parent = transform.parent;
    return;
  }
  edge.pose = transform.T_parent_child.pose;
  if (!edge.fixed) edge.track.add(transform.T_parent_child);
}

const FrameTree::Edge* FrameTree::edge(const std::string& frame) const {
  const auto found = edges_.find(frame);
  return found == edges_.end() ? nullptr : &found->second;
}

bool FrameTree::moves(const std::string& frame) const {
  int depth = 0;
  for (const Edge* e = edge(frame); e != nullptr && depth < kDeepest;
       e = edge(e->parent), ++depth) {
    if (!e->fixed) return true;
  }
  return false;
}

std::string FrameTree::root_of(const std::string& frame) const {
  std::string root = frame;
  int depth = 0;
  for (const Edge* e = edge(frame); e != nullptr && depth < kDeepest; e = edge(root), ++depth) {
    root = e->parent;
  }
  return root;
}

bool FrameTree::covers(const std::string& frame, const std::string& root, double time) const {
  std::string child = frame;
  for (int depth = 0; depth < kDeepest && child != root; ++depth) {
    const Edge* const e = edge(child);
    if (e == nullptr || (!e->fixed && !e->track.covers(time))) return false;
    child = e->parent;
  }
  return child == root;
}

std::optional<FramePlace> FrameTree::at(const std::string& frame, const std::string& root,
                                        double time, double longest_gap, std::string& gap) {
  FramePlace place;
  bool moved = false;
  std::string child = frame;
  for (int depth = 0; depth < kDeepest && child != root; ++depth) {
    const auto found = edges_.find(child);
    if (found == edges_.end()) break;
    Edge& e = found->second;
    const std::optional<ldm::Pose> pose = e.fixed ? e.pose : e.track.at(time, longest_gap);
    if (!pose) {
      gap = e.parent + " to " + child + " has " + e.track.around(time);
      return {};
    }
    place.T_root_frame = composed(*pose, place.T_root_frame);
    if (moved || !e.fixed) place.T_root_vehicle = composed(*pose, place.T_root_vehicle);
    moved = moved || !e.fixed;
    child = e.parent;
  }
  if (child == root) return place;
  gap = "TF has no way from " + frame + " to " + root;
  return {};
}

std::optional<ldm::Pose> FrameTree::fixed_between(const std::string& ancestor,
                                                  const std::string& frame) const {
  ldm::Pose pose;
  std::string child = frame;
  for (int depth = 0; depth < kDeepest; ++depth) {
    if (child == ancestor) return pose;
    const Edge* const e = edge(child);
    if (e == nullptr || !e->fixed) return {};
    pose = composed(e->pose, pose);
    child = e->parent;
  }
  return {};
}

std::string FrameTree::conflict(const std::string& frame) const {
  std::string child = frame;
  for (int depth = 0; depth < kDeepest; ++depth) {
    const Edge* const e = edge(child);
    if (e == nullptr) return {};
    if (!e->other_parent.empty()) return child + ": " + e->parent + ", " + e->other_parent;
    child = e->parent;
  }
  return {};
}

}  // namespace datasets
