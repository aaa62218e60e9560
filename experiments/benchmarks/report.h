#pragma once
/// The output of `ldm_bench`: facts as `# name: value`, then one line of CSV a sample.
#include <ostream>
#include <vector>

#include "experiments/benchmarks/interleaved.h"

namespace benchmarks {

/// What made the numbers: build, machine, number of frames.
void print_build(std::int64_t frames, std::ostream& out);

/// Heap memory of the Local Dynamic Map: its size at 128^3 voxels and 1,000,000 particles, and what
/// it takes after the warm-up at 32^3, 200,000 and two threads.
void print_footprint(Scans& scans, std::ostream& out);

/// All samples that count: wall and CPU time of whole steps, wall time of their stages.
void print_samples(const std::vector<Timed>& all, std::ostream& out);

}  // namespace benchmarks
