#include "baselines/octomap_file.h"

#include <octomap/OcTree.h>

#include <sstream>

#include "baselines/octomap_keys.h"

namespace baselines {
namespace {

void check_reach(const ldm::LocalMap& map) {
  const ldm::VoxelIndex end = map.window.origin + map.window.size;
  if ((map.window.origin.array() >= -kVoxelsToBorder).all() &&
      (end.array() <= kVoxelsToBorder).all()) {
    return;
  }
  std::ostringstream message;
  message << "map: voxels from (" << map.window.origin.transpose() << ") on: no .bt file holds them"
          << "; allowed: " << -kVoxelsToBorder << " to " << kVoxelsToBorder - 1;
  throw ldm::InvalidInput(message.str());
}

/// As `octomap::OcTree::writeBinary`, which in Debian's build also prints " done." on stderr.
void write(const octomap::OcTree& tree, const std::string& comment, std::ostream& out) {
  out << "# Octomap OcTree binary file\n";
  if (!comment.empty()) out << "# " << comment << '\n';
  out << "id " << tree.getTreeType() << "\nsize " << tree.size() << "\nres " << tree.getResolution()
      << "\ndata\n";
  tree.writeBinaryData(out);
}

}  // namespace

void write_bt(const ldm::LocalMap& map, const std::string& comment, std::ostream& out) {
  check_reach(map);
  octomap::OcTree tree(map.resolution);
  constexpr bool kLazy = true;  // inner nodes follow once, below
  for_each_voxel(map.window, [&](const ldm::VoxelIndex& v, std::size_t i) {
    const float p = map.occupancy[i];
    if (p == ldm::kUnknown) return;
    tree.setNodeValue(
        key_of(v),
        ldm::is_occupied(p) ? tree.getClampingThresMaxLog() : tree.getClampingThresMinLog(), kLazy);
  });
  tree.updateInnerOccupancy();
  tree.toMaxLikelihood();
  tree.prune();
  write(tree, comment, out);
}

}  // namespace baselines
