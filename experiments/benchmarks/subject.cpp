#include "experiments/benchmarks/subject.h"

#include "baselines/liboctomap.h"
#include "datasets/scenario/simulation.h"
#include "experiments/benchmarks/memory_bound.h"
#include "experiments/method/methods.h"

namespace benchmarks {
namespace {

/// Its scan is copied before the clock starts: a LiDAR's driver, too, has just written it.
class MapperSubject final : public Subject {
 public:
  MapperSubject(std::unique_ptr<ldm::Mapper> mapper, const std::vector<ldm::Scan>& scans)
      : mapper_(std::move(mapper)), scans_(scans) {}
  void prepare(std::size_t k) override { scan_ = scans_.at(k); }
  void step(std::size_t, ldm::StageListener& listener) override {
    mapper_->update(scan_, &listener);
  }

 private:
  std::unique_ptr<ldm::Mapper> mapper_;
  const std::vector<ldm::Scan>& scans_;
  ldm::Scan scan_;
};

class BoundSubject final : public Subject {
 public:
  BoundSubject(MemoryBound::State state, const Configuration& c)
      : bound_(state, c.particles, c.threads) {}
  void prepare(std::size_t) override { bound_.visit_pages(); }
  void step(std::size_t, ldm::StageListener&) override { bound_.step(); }

 private:
  MemoryBound bound_;
};

/// The scan alone counts, but its truth comes with it: what a study pays.
class SimulationSubject final : public Subject {
 public:
  SimulationSubject(const Pattern& pattern, std::int64_t frames)
      : simulation_(flight_scenario(pattern), kFlightSeed, frames) {}
  void step(std::size_t, ldm::StageListener&) override { simulation_.next(frame_); }

 private:
  datasets::Simulation simulation_;
  datasets::Frame frame_;
};

std::unique_ptr<ldm::Mapper> make_mapper(const Configuration& c) {
  const bool is_library = c.subject == kLibOctomap;
  const experiments::Method& method = experiments::find_method(is_library ? "octomap" : c.subject);
  ldm::Parameters parameters = experiments::default_parameters(method);
  parameters.map.voxels.setConstant(c.edge);
  if (c.particles > 0) parameters.particles.count = c.particles;
  parameters.particles.min_per_voxel = 20;  // whatever the default: times stay comparable
  parameters.execution.threads = c.threads;
  return is_library ? ldm::create<baselines::LibOctomap>(parameters) : method.create(parameters);
}

}  // namespace

std::unique_ptr<Subject> make_subject(const Configuration& c, Scans& scans, std::int64_t frames) {
  using State = MemoryBound::State;
  if (c.subject == kBoundCache) return std::make_unique<BoundSubject>(State::kCached, c);
  if (c.subject == kBoundMemory) return std::make_unique<BoundSubject>(State::kFromMemory, c);
  if (c.subject == kSimulate) return std::make_unique<SimulationSubject>(c.pattern, frames);
  return std::make_unique<MapperSubject>(make_mapper(c), scans.of(c.pattern));
}

}  // namespace benchmarks
