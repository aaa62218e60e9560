#include "baselines/centroid_kalman.h"

#include <Eigen/Dense>
#include <algorithm>
#include <tuple>

namespace baselines {
namespace {

constexpr double kCell = 0.3;  // [m]: points in touching cells are one cluster
constexpr std::size_t kLeastPoints = 8;
constexpr double kGate = 2;             // [m] between expected and found centroid
constexpr double kAcceleration = 3;     // [m/s^2]
constexpr double kCentroidSigma = 0.1;  // [m]
constexpr double kUnknownSpeed = 10;    // standard deviation at first [m/s]
constexpr double kMemory = 0.5;         // [s]

Eigen::Vector2d centroid_of(std::span<const Eigen::Vector3d> points) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector3d& p : points) sum += p.head<2>();
  return sum / static_cast<double>(points.size());
}

Eigen::Matrix2d centroid_covariance() {
  return kCentroidSigma * kCentroidSigma * Eigen::Matrix2d::Identity();
}

/// That a cluster may be a track's.
struct Pair {
  double distance;
  std::size_t track, cluster;
};

}  // namespace

CentroidKalman::Track::Track(std::int64_t number, double time, const Eigen::Vector2d& centroid)
    : id(number), since(time), seen(time), covariance(Eigen::Matrix4d::Zero()) {
  mean << centroid, 0, 0;
  covariance.topLeftCorner<2, 2>() = centroid_covariance();
  covariance.bottomRightCorner<2, 2>().diagonal().setConstant(kUnknownSpeed * kUnknownSpeed);
}

void CentroidKalman::Track::predict(double dt) {
  Eigen::Matrix4d step = Eigen::Matrix4d::Identity();
  step(0, 2) = step(1, 3) = dt;
  Eigen::Matrix<double, 4, 2> gain;
  gain << dt * dt / 2 * Eigen::Matrix2d::Identity(), dt * Eigen::Matrix2d::Identity();
  mean = (step * mean).eval();
  covariance = (step * covariance * step.transpose() +
                kAcceleration * kAcceleration * gain * gain.transpose())
                   .eval();
}

void CentroidKalman::Track::see(double time, const Eigen::Vector2d& centroid) {
  const Eigen::Matrix2d innovation = covariance.topLeftCorner<2, 2>() + centroid_covariance();
  const Eigen::Matrix<double, 4, 2> gain = covariance.leftCols<2>() * innovation.inverse();
  mean += gain * (centroid - mean.head<2>());
  covariance -= gain * innovation * gain.transpose();
  seen = time;
}

ldm::Cluster CentroidKalman::Track::cluster(double static_below) const {
  ldm::Cluster cluster;
  cluster.id = id;
  cluster.age = seen - since;
  cluster.velocity << mean.tail<2>().cast<float>(), 0;
  const Eigen::Matrix2f c = covariance.bottomRightCorner<2, 2>().cast<float>();
  cluster.velocity_covariance = 0.5F * (c + c.transpose());
  cluster.dynamic = mean.tail<2>().norm() >= static_below;
  return cluster;
}

CentroidKalman::CentroidKalman(const ldm::Parameters& parameters)
    : map_(parameters),
      map_parameters_(parameters.map),
      static_below_(parameters.clusters.static_below),
      segments_(kCell, {1, 1, 1}) {}

void CentroidKalman::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  map_.update(scan, listener);
  if (listener != nullptr) listener->begin("tracking");
  const ldm::VoxelBox window{
      ldm::voxel_at(scan.T_world_uav.translation, map_parameters_.resolution) -
          map_parameters_.voxels / 2,
      map_parameters_.voxels};
  std::vector<Eigen::Vector3d> points;
  for (const ldm::Point& p : scan.points) {
    const Eigen::Vector3d world = scan.T_world_sensor * p.cast<double>();
    if (window.contains(ldm::voxel_at(world, map_parameters_.resolution))) points.push_back(world);
  }
  follow(scan.time, points);
}

std::vector<CentroidKalman::Group> CentroidKalman::groups(std::span<const Eigen::Vector3d> points) {
  segments_.find(points);
  std::vector<Group> found;
  for (std::size_t s = 0; s < segments_.count(); ++s) {
    const std::span<const std::size_t> members = segments_.members(s);
    if (members.size() < kLeastPoints) continue;
    Group& group = found.emplace_back();
    for (const std::size_t i : members) group.push_back(points[i]);
  }
  return found;
}

/// Nearest centroids first; what none is near begins a track.
void CentroidKalman::follow(double time, std::span<const Eigen::Vector3d> points) {
  for (Track& track : tracks_) track.predict(time - time_.value_or(time));
  time_ = time;
  std::vector<Group> found = groups(points);
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks_.size(); ++t) {
    for (std::size_t c = 0; c < found.size(); ++c) {
      const double distance = (tracks_[t].mean.head<2>() - centroid_of(found[c])).norm();
      if (distance < kGate) pairs.push_back({distance, t, c});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.distance, a.track, a.cluster) < std::tie(b.distance, b.track, b.cluster);
  });

  clusters_.clear();
  std::vector<bool> track_taken(tracks_.size()), cluster_taken(found.size());
  for (const Pair& pair : pairs) {
    if (track_taken[pair.track] || cluster_taken[pair.cluster]) continue;
    track_taken[pair.track] = cluster_taken[pair.cluster] = true;
    Track& track = tracks_[pair.track];
    track.see(time, centroid_of(found[pair.cluster]));
    clusters_.add(track.cluster(static_below_), std::move(found[pair.cluster]));
  }
  std::erase_if(tracks_, [time](const Track& track) { return time - track.seen > kMemory; });
  for (std::size_t c = 0; c < found.size(); ++c) {
    if (cluster_taken[c]) continue;
    tracks_.emplace_back(++last_id_, time, centroid_of(found[c]));
    clusters_.add(tracks_.back().cluster(static_below_), std::move(found[c]));
  }
}

void CentroidKalman::read(ldm::LocalMap& map) const {
  map_.read(map);
  clusters_.read(map);
}

}  // namespace baselines
