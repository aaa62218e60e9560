#include "experiments/avoidance/sight.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/method/map_check.h"

#include "experiments/method/sees_truth.h"

namespace experiments {
namespace {

// Of a cluster's place and velocity, for maps that do not say [m], [m/s].
constexpr double kPlaceSigma = 0.1, kVelocitySigma = 0.15;
constexpr double kMostDoubt = 0.8;  // [m]

Eigen::Vector3d centre_of(const ldm::VoxelIndex& low, const ldm::VoxelIndex& high,
                          double resolution) {
  return (low + high + ldm::VoxelIndex::Ones()).cast<double>() * (resolution / 2);
}

/// Standard deviation of a cluster's velocity where it is largest [m/s].
double velocity_sigma(const ldm::Cluster& cluster) {
  const Eigen::Matrix2d covariance = cluster.velocity_covariance.cast<double>();
  if (covariance.isZero(0)) return kVelocitySigma;
  const double mean = covariance.trace() / 2;
  return std::sqrt(mean + std::hypot((covariance(0, 0) - covariance(1, 1)) / 2, covariance(0, 1)));
}

/// The voxels that one cluster spans.
struct Span {
  ldm::VoxelIndex low, high;
  bool is_empty = true;

  void add(const ldm::VoxelIndex& v) {
    low = is_empty ? v : ldm::VoxelIndex(low.cwiseMin(v));
    high = is_empty ? v : ldm::VoxelIndex(high.cwiseMax(v));
    is_empty = false;
  }
};

class MappedSight final : public Sight {
 public:
  MappedSight(const Method& method, const ldm::Parameters& parameters, const Trust& trust)
      : name_(method.name), trust_(trust), mapper_(method.create(parameters)) {}

  void see(const datasets::Frame& frame) override {
    update(*mapper_, frame);
    mapper_->read(map_);
    check_map(map_, name_, frame.index);
  }

  void predict(const SampleTimes& times, Surroundings& surroundings) override {
    surroundings.margin = trust_.margin;
    surroundings.movers.clear();
    std::vector<Span> spans(map_.clusters.size());
    occupied_.assign(map_.occupancy.size(), 0);
    for (std::size_t i = 0; i < occupied_.size(); ++i) {
      if (!ldm::is_occupied(map_.occupancy[i])) continue;
      const std::int32_t label = map_.labels[i];
      if (label >= 0 && moves(map_.clusters[static_cast<std::size_t>(label)])) {
        spans[static_cast<std::size_t>(label)].add(map_.window.voxel(i));
      } else {
        occupied_[i] = 1;
      }
    }
    for (std::size_t c = 0; c < spans.size(); ++c) {
      if (!spans[c].is_empty) {
        surroundings.movers.push_back(predicted(spans[c], map_.clusters[c], times));
      }
    }
    surroundings.still.build(map_.window, map_.resolution, occupied_);
  }

  bool knows(const datasets::ObjectState& object) const override {
    const Eigen::Vector3d low = object.position - object.size / 2;
    const Eigen::Vector3d high = object.position + object.size / 2;
    const ldm::VoxelIndex first = ldm::voxel_at(low, map_.resolution).cwiseMax(map_.window.origin);
    const ldm::VoxelIndex last =
        ldm::voxel_at(high, map_.resolution)
            .cwiseMin(map_.window.origin + map_.window.size - ldm::VoxelIndex::Ones());
    for (int z = first.z(); z <= last.z(); ++z) {
      for (int y = first.y(); y <= last.y(); ++y) {
        for (int x = first.x(); x <= last.x(); ++x) {
          if (ldm::is_occupied(map_.occupancy[map_.window.index({x, y, z})])) return true;
        }
      }
    }
    return false;
  }

  ldm::LocalMap map() const override { return map_; }

 private:
  bool moves(const ldm::Cluster& cluster) const {
    return static_cast<double>(cluster.velocity.norm()) >= trust_.moving_from;
  }

  Mover predicted(const Span& span, const ldm::Cluster& cluster, const SampleTimes& times) const {
    Mover mover;
    const Eigen::Vector3d centre = centre_of(span.low, span.high, map_.resolution);
    mover.half_size =
        (span.high - span.low + ldm::VoxelIndex::Ones()).cast<double>() * (map_.resolution / 2);
    const double sigma = velocity_sigma(cluster);
    for (const double t : times) {
      mover.centre.emplace_back(centre + t * cluster.velocity.cast<double>());
      mover.doubt.push_back(
          std::min(kMostDoubt, trust_.doubt * std::hypot(kPlaceSigma, sigma * t)));
    }
    return mover;
  }

  std::string name_;  // of the method
  Trust trust_;
  std::unique_ptr<ldm::Mapper> mapper_;
  ldm::LocalMap map_;
  std::vector<std::uint8_t> occupied_;
};

class TrueSight final : public Sight {
 public:
  TrueSight(const ldm::Parameters& parameters, const std::vector<datasets::Obstacle>& obstacles,
            bool future, const Trust& trust)
      : parameters_(parameters), obstacles_(obstacles), future_(future), trust_(trust) {}

  void see(const datasets::Frame& frame) override {
    const ldm::VoxelIndex centre =
        ldm::voxel_at(frame.scan.T_world_uav.translation, parameters_.map.resolution);
    window_ = {centre - parameters_.map.voxels / 2, parameters_.map.voxels};
    time_ = frame.scan.time;
    objects_ = frame.truth->objects;
  }

  void predict(const SampleTimes& times, Surroundings& surroundings) override {
    surroundings.margin = trust_.margin;
    surroundings.movers.clear();
    datasets::Truth standing;
    for (std::size_t i = 0; i < objects_.size(); ++i) {
      if (!knows(objects_[i])) continue;
      if (objects_[i].dynamic) {
        surroundings.movers.push_back(predicted(obstacles_[i], objects_[i], times));
      } else {
        standing.objects.push_back(objects_[i]);
      }
    }
    std::vector<std::int32_t> owners;
    datasets::solid_voxels(standing, window_, parameters_.map.resolution, owners);
    std::vector<std::uint8_t> occupied(owners.size());
    std::transform(owners.begin(), owners.end(), occupied.begin(),
                   [](std::int32_t owner) { return owner >= 0 ? 1 : 0; });
    surroundings.still.build(window_, parameters_.map.resolution, occupied);
  }

  bool knows(const datasets::ObjectState& object) const override {
    const Eigen::Vector3d half_window =
        window_.size.cast<double>() * parameters_.map.resolution / 2;
    const Eigen::Vector3d middle =
        window_.origin.cast<double>() * parameters_.map.resolution + half_window;
    return ((object.position - middle).cwiseAbs().array() <=
            (half_window + object.size / 2).array())
        .all();
  }

  ldm::LocalMap map() const override {
    ldm::LocalMap map;
    map.window = window_;
    map.resolution = parameters_.map.resolution;
    datasets::Truth known;
    for (const datasets::ObjectState& object : objects_) {
      if (!knows(object)) continue;
      known.objects.push_back(object);
      map.clusters.push_back({.id = std::int64_t{object.id} + 1,
                              .position = object.position.cast<float>(),
                              .size = object.size.cast<float>(),
                              .velocity = object.velocity.cast<float>(),
                              .voxels = 0,
                              .dynamic = object.dynamic});
    }
    datasets::solid_voxels(known, window_, map.resolution, map.labels);
    map.occupancy.reserve(map.labels.size());
    for (const std::int32_t label : map.labels) {
      map.occupancy.push_back(label >= 0 ? 1.0F : ldm::kUnknown);
      if (label >= 0) ++map.clusters[static_cast<std::size_t>(label)].voxels;
    }
    return map;
  }

 private:
  Mover predicted(const datasets::Obstacle& obstacle, const datasets::ObjectState& now,
                  const SampleTimes& times) const {
    Mover mover{now.size / 2, {}, std::vector<double>(times.size(), 0.0)};
    for (const double t : times) {
      const datasets::MotionState then = obstacle.motion.at(time_ + t);
      mover.centre.emplace_back(
          future_ ? Eigen::Vector3d(then.position.x(), then.position.y(), now.position.z())
                  : Eigen::Vector3d(now.position + t * now.velocity));
    }
    return mover;
  }

  ldm::Parameters parameters_;
  const std::vector<datasets::Obstacle>& obstacles_;
  bool future_;
  Trust trust_;
  ldm::VoxelBox window_;
  double time_ = 0;
  std::vector<datasets::ObjectState> objects_;
};

}  // namespace

std::unique_ptr<Sight> mapped_sight(const Method& method, const ldm::Parameters& parameters,
                                    const Trust& trust) {
  return std::make_unique<MappedSight>(method, parameters, trust);
}

std::unique_ptr<Sight> true_sight(const ldm::Parameters& parameters,
                                  const std::vector<datasets::Obstacle>& obstacles, bool future,
                                  const Trust& trust) {
  return std::make_unique<TrueSight>(parameters, obstacles, future, trust);
}

}  // namespace experiments
