#pragma once
/// From leaf to leaf of OctoMap's tree; for files of baselines/ that use liboctomap (no paper
/// section).
#include <octomap/OcTree.h>

#include <array>
#include <bit>

namespace baselines {

/// Finds leaves near the one found last through their nearest common ancestor: two levels up and
/// down instead of sixteen down, twice, as octomap::OcTree::updateNode goes. No one else may prune
/// the tree.
class OctreeCursor {
 public:
  explicit OctreeCursor(octomap::OcTree& tree) : tree_(tree) {}

  /// The leaf of `key` at the lowest level, made if there is none; its caller gives it a value.
  octomap::OcTreeNode& leaf(const octomap::OcTreeKey& key) {
    if (path_[0] == nullptr) start(key);
    const auto differ =
        static_cast<unsigned>((key[0] ^ last_[0]) | (key[1] ^ last_[1]) | (key[2] ^ last_[2]));
    for (int depth = kDepth - std::bit_width(differ); depth < kDepth; ++depth) {
      octomap::OcTreeNode* const node = path_[static_cast<std::size_t>(depth)];
      const unsigned child = octomap::computeChildIdx(key, kDepth - 1 - depth);
      path_[static_cast<std::size_t>(depth) + 1] = tree_.nodeChildExists(node, child)
                                                       ? tree_.getNodeChild(node, child)
                                                       : tree_.createNodeChild(node, child);
    }
    last_ = key;
    return *path_[kDepth];
  }

 private:
  static constexpr int kDepth = 16;  // of every octomap::OcTree

  /// The tree makes its root with its first leaf.
  void start(const octomap::OcTreeKey& key) {
    constexpr bool kLazily = true;
    tree_.updateNode(key, 0.0F, kLazily);
    path_[0] = tree_.getRoot();
    last_ = key;
    last_[0] ^= 0x8000;  // no ancestor but the root is known
  }

  octomap::OcTree& tree_;
  octomap::OcTreeKey last_;
  std::array<octomap::OcTreeNode*, kDepth + 1> path_ = {};  // from the root to the leaf of last_
};

}  // namespace baselines
