#include <gtest/gtest.h>

#include <map>
#include <set>

#include "datasets/scenario/simulation.h"
#include "experiments/method/data_folders.h"
#include "experiments/method/evaluation.h"
#include "experiments/metrics/matching.h"
#include "ldm/cluster_tracker.h"

namespace experiments {
namespace {

/// The ids that the library gives, held against the truth of a scenario.
TEST(Identity, ObjectsOfAScenarioSeldomChangeTheirTrack) {
  ldm::Parameters parameters;
  parameters.particles.count = 20000;
  const Method& method = find_method("ldm");
  datasets::Simulation source(datasets::read_scenario(DataFolders({}).scenarios.file("scenario3")),
                              1, 300);
  TruthGrid grid;
  struct Last {
    double time = 0;
    std::int64_t track = 0;
  };
  std::map<std::int32_t, Last> last;  // by object
  std::int64_t matched = 0, switches = 0;
  const auto observe = [&](const datasets::Frame& frame, const ldm::LocalMap& map) {
    std::set<std::int64_t> ids;
    for (const ldm::Cluster& cluster : map.clusters) ids.insert(cluster.id);
    ASSERT_EQ(ids.size(), map.clusters.size());
    grid.fill(*frame.truth, map.window, map.resolution);
    const Matching matching = match(map, grid);
    for (std::size_t i = 0; i < matching.objects.size(); ++i) {
      const auto cluster = matching.objects[i].cluster;
      if (!cluster) continue;
      ++matched;
      const Last now{frame.scan.time, map.clusters[*cluster].id};
      Last& before = last[frame.truth->objects[i].id];
      const bool lately = now.time - before.time < ldm::ClusterTracker::kMemory;
      if (before.track != 0 && lately && before.track != now.track) ++switches;
      before = now;
    }
  };
  evaluate(method, parameters, source, {.frames = {}, .series = false, .observer = observe});
  EXPECT_GT(matched, 1000);
  EXPECT_LT(switches, matched / 60);  // most by objects whose clusters merge and break
}

}  // namespace
}  // namespace experiments
