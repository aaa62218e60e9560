#include "ldm/clustering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "ldm/log_odds.h"
#include "ldm/read_occupancy.h"
#include "tests/ldm/random_inputs.h"
#include "tests/reference/components_oracle.h"

namespace ldm {
namespace {

class ClusteringTest : public testing::Test {
 protected:
  const std::vector<Cluster>& find(const std::vector<VoxelIndex>& occupied) {
    RingBuffer<float> log_odds(map_.voxels, -1.0F);
    for (const VoxelIndex& v : occupied) log_odds.at(v) = 2.0F;
    clustering_.find(log_odds);
    return clustering_.clusters();
  }

  MapParameters map_ = map_of({9, 9, 9}, 0.5);
  Clustering clustering_{map_, {}};
};

TEST_F(ClusteringTest, VoxelsTouchAcrossFacesEdgesAndCorners) {
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -1; z <= 1; ++z) {
        EXPECT_EQ(find({{0, 0, 0}, {x, y, z}}).size(), 1u) << x << ' ' << y << ' ' << z;
        EXPECT_EQ(find({{0, 0, 0}, {3 * x, 3 * y, 3 * z}}).size(),
                  x == 0 && y == 0 && z == 0 ? 1u : 2u);
      }
    }
  }
  EXPECT_EQ(find({{0, 0, 0}, {2, 1, 0}}).size(), 2u);
  EXPECT_EQ(find({{0, 0, 0}, {1, 0, -2}}).size(), 2u);
}

/// Two of three clusters are one group: their mean, their extent, in window order.
TEST_F(ClusteringTest, JoinsGroupsByHand) {
  ASSERT_EQ(find({{-2, 0, 0}, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}}).size(), 3u);
  std::vector<std::int32_t> group{7, -1, 7};
  clustering_.join(group, VoxelBox{{-4, -4, -4}, {9, 9, 9}});
  EXPECT_EQ(group, (std::vector<std::int32_t>{7, -1}));
  const std::vector<Cluster>& joined = clustering_.clusters();
  ASSERT_EQ(joined.size(), 2u);
  EXPECT_EQ(joined[0].voxels, 3);
  // Centres (-0.75, 0.25), (1.25, 0.25), (1.25, 0.75) m.
  EXPECT_TRUE(joined[0].position.isApprox(Point(1.75F / 3, 1.25F / 3, 0.25F)));
  EXPECT_EQ(joined[0].size, Point(2.5F, 1, 0.5F));
  EXPECT_EQ(joined[1].voxels, 1);
  ASSERT_EQ(clustering_.runs_of(0).size(), 3u);
  EXPECT_EQ(clustering_.runs_of(0)[0].x_begin, 2);
  EXPECT_EQ(clustering_.runs_of(0)[2].y, 5);
  EXPECT_EQ(clustering_.runs_of(1)[0].x_begin, 4);
}

TEST_F(ClusteringTest, JoinsNothingWithoutGroups) {
  find({{-2, 0, 0}, {0, 0, 0}});
  std::vector<std::int32_t> group{-1, 3};
  clustering_.join(group, VoxelBox{{-4, -4, -4}, {9, 9, 9}});
  EXPECT_EQ(group, (std::vector<std::int32_t>{-1, 3}));
  EXPECT_EQ(clustering_.clusters().size(), 2u);
}

TEST_F(ClusteringTest, PositionSizeAndVoxelsByHand) {
  // An L of three voxels: centres (0.25, 0.25, 0.25), (0.75, 0.25, 0.25), (0.25, 0.75, 0.75) m.
  const std::vector<Cluster>& clusters = find({{0, 0, 0}, {1, 0, 0}, {0, 1, 1}});
  ASSERT_EQ(clusters.size(), 1u);
  EXPECT_EQ(clusters[0].voxels, 3);
  EXPECT_TRUE(clusters[0].position.isApprox(Point(1.25F, 1.25F, 1.25F) / 3));
  EXPECT_EQ(clusters[0].size, Point(1, 1, 1));
  EXPECT_EQ(clusters[0].velocity, Velocity(0, 0, 0));
  EXPECT_FALSE(clusters[0].dynamic);
}

TEST_F(ClusteringTest, NumberedByFirstVoxelInWindowOrder) {
  // The first cluster begins at x = 3 in the lowest layer; the others lie above.
  const std::vector<Cluster>& clusters = find({{-4, -4, 0}, {0, 0, 4}, {3, 0, -4}, {0, 0, 2}});
  ASSERT_EQ(clusters.size(), 4u);
  EXPECT_EQ(clusters[0].position, Point(1.75F, 0.25F, -1.75F));
  EXPECT_EQ(clusters[1].position, Point(-1.75F, -1.75F, 0.25F));
  EXPECT_EQ(clusters[2].position, Point(0.25F, 0.25F, 1.25F));
  EXPECT_EQ(clusters[3].position, Point(0.25F, 0.25F, 2.25F));
}

TEST_F(ClusteringTest, BordersOfTheMapDoNotTouch) {
  EXPECT_EQ(find({{-4, 0, 0}, {4, 0, 0}}).size(), 2u);
  EXPECT_EQ(find({{0, -4, 0}, {0, 4, 0}}).size(), 2u);
  EXPECT_EQ(find({{0, 0, -4}, {0, 0, 4}}).size(), 2u);
  EXPECT_EQ(find({{4, -4, 0}, {-4, -3, 0}}).size(), 2u);  // neighbours in memory
}

TEST_F(ClusteringTest, OnlyAboveTheThreshold) {
  ClusterParameters parameters;
  parameters.occupied_above = 0.7;
  Clustering clustering(map_, parameters);
  EXPECT_FLOAT_EQ(clustering.threshold(), static_cast<float>(log_odds(0.7)));
  RingBuffer<float> map(map_.voxels);
  map.at({0, 0, 0}) = clustering.threshold();
  clustering.find(map);
  EXPECT_TRUE(clustering.clusters().empty());
  map.at({0, 0, 0}) = std::nextafter(clustering.threshold(), 4.0F);
  clustering.find(map);
  EXPECT_EQ(clustering.clusters().size(), 1u);
}

TEST_F(ClusteringTest, NothingAndEverything) {
  EXPECT_TRUE(find({}).empty());
  LocalMap map;
  map.window = {{-4, -4, -4}, {9, 9, 9}};
  clustering_.read(map);
  EXPECT_EQ(map.labels, std::vector<std::int32_t>(9 * 9 * 9, -1));

  RingBuffer<float> full(map_.voxels, 1.0F);
  clustering_.find(full);
  ASSERT_EQ(clustering_.clusters().size(), 1u);
  EXPECT_EQ(clustering_.clusters()[0].voxels, 9 * 9 * 9);
  EXPECT_EQ(clustering_.clusters()[0].position, Point(0.25F, 0.25F, 0.25F));
  EXPECT_EQ(clustering_.clusters()[0].size, Point(4.5F, 4.5F, 4.5F));
  clustering_.read(map);
  EXPECT_EQ(map.labels, std::vector<std::int32_t>(9 * 9 * 9, 0));
}

/// A map at a random place with a share of occupied voxels, clustered both ways.
class ClusteringOracleTest : public testing::Test {
 protected:
  void draw(const Eigen::Vector3i& n, double density) {
    log_odds_.emplace(n);
    log_odds_->recenter(random_vector(-50, 50, random_));
    occupied_.clear();
    for_each_voxel(window(), [&](const VoxelIndex& v, std::size_t) {
      const bool occupied = uniform(0, 1, random_) < density;
      log_odds_->at(v) =
          static_cast<float>(occupied ? uniform(0.01, 3.5, random_) : uniform(-2, 0, random_));
      if (occupied) occupied_.push_back(v);
    });
    component_ = reference::components(occupied_);
  }
  const VoxelBox& window() const { return log_odds_->index().window(); }

  void compare_labels(const Clustering& clustering) {
    LocalMap map;
    read_occupancy(*log_odds_, kResolution, map);
    clustering.read(map);
    std::vector<std::int32_t> expected(window().count(), -1);
    for (std::size_t i = 0; i < occupied_.size(); ++i) {
      expected[window().index(occupied_[i])] = component_[i];
    }
    EXPECT_EQ(map.labels, expected);
    EXPECT_EQ(map.clusters.size(), clustering.clusters().size());
  }

  void compare_shapes(const Clustering& clustering) {
    for (std::size_t c = 0; c < clustering.clusters().size(); ++c) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      VoxelIndex low = VoxelIndex::Constant(1000);
      VoxelIndex high = VoxelIndex::Constant(-1000);
      int voxels = 0;
      for (std::size_t i = 0; i < occupied_.size(); ++i) {
        if (component_[i] != static_cast<int>(c)) continue;
        sum += occupied_[i].cast<double>();
        low = low.cwiseMin(occupied_[i]);
        high = high.cwiseMax(occupied_[i]);
        ++voxels;
      }
      const Eigen::Vector3d mean = (sum / voxels).array() + 0.5;
      const Cluster& cluster = clustering.clusters()[c];
      ASSERT_EQ(cluster.voxels, voxels);
      EXPECT_LT((cluster.position.cast<double>() - mean * kResolution).norm(), 1e-5);
      const Eigen::Vector3d size = (high - low).cast<double>().array() + 1;
      EXPECT_LT((cluster.size.cast<double>() - size * kResolution).norm(), 1e-5);
    }
  }

  /// The runs of each cluster hold its voxels, in window order, and lead to their slots.
  void compare_runs(const Clustering& clustering) {
    std::size_t total = 0;
    for (std::size_t c = 0; c < clustering.clusters().size(); ++c) {
      std::vector<std::size_t> slots;
      for (const ldm::Run& run : clustering.runs_of(c)) {
        EXPECT_EQ(run.cluster, static_cast<std::int32_t>(c));
      }
      for_each_stretch(log_odds_->index(), clustering.runs_of(c),
                       [&](std::size_t first, std::size_t n) {
                         ASSERT_GT(n, 0u);
                         for (std::size_t i = 0; i < n; ++i) slots.push_back(first + i);
                       });
      std::vector<std::size_t> expected;
      for (std::size_t i = 0; i < occupied_.size(); ++i) {
        if (component_[i] != static_cast<int>(c)) continue;
        expected.push_back(log_odds_->index().slot(occupied_[i]));
      }
      ASSERT_EQ(slots, expected);
      total += clustering.runs_of(c).size();
    }
    EXPECT_EQ(total, clustering.runs().size());
  }

  static constexpr double kResolution = 0.15;
  Random random_{1};
  std::optional<RingBuffer<float>> log_odds_;
  std::vector<VoxelIndex> occupied_;
  std::vector<int> component_;
};

TEST_F(ClusteringOracleTest, SameAsComparingVoxelsPairByPair) {
  for (const Eigen::Vector3i& n : map_sizes()) {
    Clustering clustering(map_of(n), {});
    for (const double density : {0.01, 0.04, 0.08, 0.15, 0.5}) {
      if (density * n.prod() > 3500) continue;  // the oracle compares all pairs
      SCOPED_TRACE(testing::Message() << n.transpose() << ", density " << density);
      draw(n, density);
      clustering.find(*log_odds_);
      compare_labels(clustering);
      compare_shapes(clustering);
      compare_runs(clustering);
    }
  }
}

}  // namespace
}  // namespace ldm
