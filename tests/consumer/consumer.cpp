/// The map of one scan: a wall of two by three voxels ahead of the UAV.
#include <ldm/local_dynamic_map.h>
#include <ldm/version.h>

#include <iostream>

int main() {
  ldm::Parameters parameters;
  parameters.map.resolution = 0.5;
  parameters.map.voxels = {16, 16, 16};
  parameters.particles.count = 1000;
  ldm::LocalDynamicMap mapper(parameters);

  ldm::Scan scan;
  for (const float y : {0.25F, 0.75F}) {
    for (const float z : {-0.25F, 0.25F, 0.75F}) scan.points.emplace_back(2.25F, y, z);
  }
  mapper.update(scan);
  ldm::LocalMap map;
  mapper.read(map);

  std::cout << "ldm " << ldm::kVersion << '\n';
  for (const ldm::Cluster& c : map.clusters) {
    std::cout << c.voxels << " voxels at " << c.position.transpose() << '\n';
  }
}
