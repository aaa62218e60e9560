#pragma once
/// The yardstick of object velocities: Euclidean clusters of a scan, nearest centroid, one
/// constant-velocity Kalman filter. A method that loses to it is not finished.
#include <optional>
#include <span>
#include <vector>

#include "baselines/current_scan.h"
#include "baselines/point_clusters.h"
#include "ldm/objects/segments.h"

namespace baselines {

/// The map of CurrentScan, and in it what tests/yardstick/constant_velocity.py follows, with the
/// same constants; a test holds the two together. The ground has to be removed before.
class CentroidKalman final : public ldm::Mapper {
 public:
  /// Reads what CurrentScan does, and `clusters.static_below_mps`: what is slower is not dynamic.
  /// @throws ldm::InvalidInput on a parameter out of its range.
  explicit CentroidKalman(const ldm::Parameters& parameters);

  void update(const ldm::Scan& scan, ldm::StageListener* listener = nullptr) override;
  void read(ldm::LocalMap& map) const override;

 private:
  /// Centroid and velocity, horizontal (x, y, vx, vy) [m, m/s]. As in ldm::Pose, the layout is the
  /// same for every -march.
  struct Track {
    std::int64_t id;
    double since, seen;  // [s]
    Eigen::Matrix<double, 4, 1, Eigen::DontAlign> mean;
    Eigen::Matrix<double, 4, 4, Eigen::DontAlign> covariance;

    Track(std::int64_t number, double time, const Eigen::Vector2d& centroid);
    void predict(double dt);
    void see(double time, const Eigen::Vector2d& centroid);
    ldm::Cluster cluster(double static_below) const;
  };
  using Group = std::vector<Eigen::Vector3d>;

  void follow(double time, std::span<const Eigen::Vector3d> points);
  std::vector<Group> groups(std::span<const Eigen::Vector3d> points);

  CurrentScan map_;
  ldm::MapParameters map_parameters_;
  double static_below_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::Segments segments_;
  std::vector<Track> tracks_;
  std::int64_t last_id_ = 0;
  PointClusters clusters_;
};

}  // namespace baselines
