/// The program `ldm_kernels`: single steps of the method, on the map and the scans of a flight.
#include <benchmark/benchmark.h>

#include "baselines/circular_buffer.h"
#include "experiments/benchmarks/scans.h"
#include "ldm/clustering.h"
#include "ldm/measurement_flags.h"
#include "ldm/occupancy_update.h"
#include "ldm/particles.h"
#include "ldm/read_occupancy.h"
#include "ldm/scan_check.h"

namespace benchmarks {
namespace {

constexpr std::int64_t kFrames = 20;
constexpr double kFrameTime = 0.1;  // [s]

const ldm::Scan& scan_of(const Pattern& pattern) {
  static Scans scans(kFrames);
  return scans.of(pattern).back();
}

ldm::Parameters parameters_of(std::int64_t edge) {
  ldm::Parameters parameters;
  parameters.map.voxels.setConstant(static_cast<int>(edge));
  return parameters;
}

/// The log-odds at the end of the flight.
ldm::RingBuffer<float> log_odds_of(const ldm::Parameters& parameters) {
  static Scans scans(kFrames);
  baselines::CircularBuffer map(parameters);
  for (const ldm::Scan& scan : scans.of({})) map.update(scan);
  return map.log_odds();
}

/// `n` items a pass, for a time per item.
void count_items(benchmark::State& state, std::size_t n) {
  state.counters["items"] = static_cast<double>(n);
}

/// Of edge^3 voxels.
void count_voxels(benchmark::State& state) {
  count_items(state, static_cast<std::size_t>(state.range(0) * state.range(0) * state.range(0)));
}

void check_scan(benchmark::State& state) {
  const ldm::Scan& scan = scan_of({state.range(0), state.range(1)});
  for (auto _ : state) ldm::check_scan(scan, {});
  count_items(state, scan.points.size() + scan.no_returns.size());
}
BENCHMARK(check_scan)->Args({16, 1024})->Args({64, 2048})->ArgNames({"channels", "azimuths"});

void measurement_flags(benchmark::State& state) {
  const ldm::Parameters parameters = parameters_of(state.range(0));
  const ldm::Scan& scan = scan_of({state.range(1), state.range(2)});
  ldm::MeasurementFlags flags(parameters.map, parameters.sensor_model.no_returns, true);
  const ldm::VoxelIndex centre =
      ldm::voxel_at(scan.T_world_uav.translation, parameters.map.resolution);
  const ldm::VoxelBox window{centre - parameters.map.voxels / 2, parameters.map.voxels};
  for (auto _ : state) {
    flags.mark(scan, window);
    benchmark::DoNotOptimize(flags.flags().data());
  }
  count_items(state, scan.points.size() + scan.no_returns.size());
}
BENCHMARK(measurement_flags)
    ->ArgsProduct({{32, 128}, {16}, {1024}})
    ->ArgsProduct({{32, 128}, {64}, {2048}})
    ->ArgNames({"edge", "channels", "azimuths"});

void occupancy_update(benchmark::State& state) {
  const ldm::Parameters parameters = parameters_of(state.range(0));
  ldm::RingBuffer<float> log_odds = log_odds_of(parameters);
  ldm::MeasurementFlags flags(parameters.map, parameters.sensor_model.no_returns, true);
  flags.mark(scan_of({}), log_odds.index().window());
  const ldm::OccupancyUpdate update(parameters.map, parameters.sensor_model, parameters.survival);
  for (auto _ : state) {
    update.apply(flags.flags(), {}, log_odds);
    benchmark::DoNotOptimize(log_odds.cells().data());
  }
  count_voxels(state);
}
BENCHMARK(occupancy_update)->Arg(32)->Arg(128)->ArgName("edge");

void ring_buffer_step(benchmark::State& state) {
  ldm::RingBuffer<float> log_odds(parameters_of(state.range(0)).map.voxels, 0.0F);
  ldm::VoxelIndex centre = ldm::VoxelIndex::Zero();
  for (auto _ : state) {
    centre.x() += 1;
    log_odds.recenter(centre);
  }
  count_items(state, static_cast<std::size_t>(state.range(0) * state.range(0)));
}
BENCHMARK(ring_buffer_step)->Arg(32)->Arg(128)->ArgName("edge");

void clustering(benchmark::State& state) {
  const ldm::Parameters parameters = parameters_of(state.range(0));
  const ldm::RingBuffer<float> log_odds = log_odds_of(parameters);
  ldm::Clustering clusters(parameters.map, parameters.clusters);
  for (auto _ : state) {
    clusters.find(log_odds);
    benchmark::DoNotOptimize(clusters.clusters().data());
  }
  count_voxels(state);
}
BENCHMARK(clustering)->Arg(32)->Arg(128)->ArgName("edge");

void read_occupancy(benchmark::State& state) {
  const ldm::Parameters parameters = parameters_of(state.range(0));
  const ldm::RingBuffer<float> log_odds = log_odds_of(parameters);
  ldm::LocalMap map;
  for (auto _ : state) {
    ldm::read_occupancy(log_odds, parameters.map.resolution, map);
    benchmark::DoNotOptimize(map.occupancy.data());
  }
  count_voxels(state);
}
BENCHMARK(read_occupancy)->Arg(32)->Arg(128)->ArgName("edge");

/// Prediction, weights and resampling: one needs what the other left.
void particle_filter(benchmark::State& state) {
  ldm::Parameters parameters = parameters_of(state.range(0));
  parameters.particles.count = state.range(1);
  const ldm::RingBuffer<float> log_odds = log_odds_of(parameters);
  ldm::Particles particles(parameters.map, parameters.particles, parameters.clusters,
                           parameters.execution, log_odds.index());
  for (auto _ : state) {
    particles.predict(kFrameTime, log_odds.index());
    particles.weigh(log_odds);
    particles.resample(log_odds.index());
    benchmark::DoNotOptimize(particles.all().data());
  }
  count_items(state, static_cast<std::size_t>(state.range(1)));
}
BENCHMARK(particle_filter)
    ->Args({32, 200'000})
    ->Args({128, 1'000'000})
    ->ArgNames({"edge", "particles"});

}  // namespace
}  // namespace benchmarks

BENCHMARK_MAIN();
