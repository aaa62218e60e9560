#include "experiments/benchmarks/report.h"

#include <iomanip>
#include <span>

#include "experiments/benchmarks/footprint.h"
#include "experiments/benchmarks/memory_bound.h"
#include "experiments/method/provenance.h"
#include "ldm/local_dynamic_map.h"

namespace benchmarks {
namespace {

Footprint footprint_of(const ldm::Parameters& parameters, std::span<const ldm::Scan> scans) {
  const auto make = [&] { return std::make_unique<ldm::LocalDynamicMap>(parameters); };
  return footprint(make, scans, kWarmUp);
}

void print_samples(const Timed& timed, std::ostream& out) {
  const Configuration& c = timed.configuration;
  for (std::size_t k = 0; k < timed.cpu_ms.size(); ++k) {
    if (!counts(k)) continue;
    const auto line = [&](std::string_view part, double wall_ms) -> std::ostream& {
      return out << c.subject << ',' << c.edge << ',' << c.particles << ',' << c.pattern.channels
                 << ',' << c.pattern.azimuths << ',' << c.threads << ',' << k << ',' << part << ','
                 << wall_ms << ',';
    };
    line("total", timed.wall.totals()[k]) << timed.cpu_ms[k] << '\n';
    for (const experiments::StageClock::Stage& stage : timed.wall.stages()) {
      line(stage.name, stage.ms[k]) << '\n';
    }
  }
}

}  // namespace

void print_build(std::int64_t frames, std::ostream& out) {
  const experiments::Provenance p = experiments::provenance();
  out << "# format: 1\n# version: " << p.version << "\n# commit: " << p.commit
      << "\n# dirty: " << (p.dirty ? "true" : "false") << "\n# compiler: " << p.compiler
      << "\n# flags: " << p.flags << "\n# build_type: " << p.build_type << "\n# cpu: " << p.cpu
      << "\n# cores: " << p.cores << "\n# largest_cache_bytes: " << largest_cache()
      << "\n# frames: " << frames << '\n';
}

void print_footprint(Scans& scans, std::ostream& out) {
  const std::span<const ldm::Scan> flight = scans.of({});
  ldm::Parameters large;
  large.map.voxels.setConstant(128);
  large.particles.count = 1'000'000;
  const Footprint in_all = footprint_of(large, flight.first(kWarmUp));
  ldm::Parameters small;
  small.execution.threads = 2;
  const Footprint settled = footprint_of(small, flight);
  out << "# bytes_beside_particles_per_voxel: " << in_all.bytes_beside_particles_per_voxel(large)
      << "\n# blocks_in_steady_state: " << settled.update_blocks + settled.read_blocks << '\n';
}

void print_samples(const std::vector<Timed>& all, std::ostream& out) {
  out << "subject,edge,particles,channels,azimuths,threads,frame,part,wall_ms,cpu_ms\n"
      << std::fixed << std::setprecision(6);
  for (const Timed& timed : all) print_samples(timed, out);
}

}  // namespace benchmarks
