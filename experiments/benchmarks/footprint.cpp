#include "experiments/benchmarks/footprint.h"

#include "experiments/benchmarks/allocation_count.h"
#include "ldm/particles.h"

namespace benchmarks {

double Footprint::bytes_beside_particles_per_voxel(const ldm::Parameters& parameters) const {
  const double state =
      2.0 * sizeof(ldm::Particle) * static_cast<double>(parameters.particles.count);
  const double voxels = parameters.map.voxels.cast<double>().prod();
  return (static_cast<double>(peak_bytes) - state) / voxels;
}

Footprint footprint(const std::function<std::unique_ptr<ldm::Mapper>()>& make,
                    std::span<const ldm::Scan> scans, std::size_t warm_up) {
  Footprint result;
  const AllocationCount count;
  const std::unique_ptr<ldm::Mapper> map = make();
  for (const ldm::Scan& scan : scans.first(warm_up)) map->update(scan);
  result.peak_bytes = count.peak_bytes();

  ldm::LocalMap local;
  map->read(local);
  for (const ldm::Scan& scan : scans.subspan(warm_up)) {
    const std::int64_t before = count.blocks();
    map->update(scan);
    const std::int64_t between = count.blocks();
    map->read(local);
    result.update_blocks += between - before;
    result.read_blocks += count.blocks() - between;
  }
  return result;
}

}  // namespace benchmarks
