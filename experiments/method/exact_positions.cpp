#include "experiments/method/exact_positions.h"

#include <utility>

#include "datasets/objects_hit.h"

namespace experiments {
namespace {

constexpr double kSigma = 0.001;  // of a position: exact, and a filter needs some [m]
constexpr double kMemory = 4.0;   // unseen for longer, an object is a new one [s]

}  // namespace

ExactPositions::ExactPositions(const ldm::Parameters& parameters)
    : map_(parameters), static_below_(parameters.clusters.static_below) {}

void ExactPositions::update(const ldm::Scan& scan, ldm::StageListener* listener) {
  map_.update(scan, listener);
  if (listener != nullptr) listener->begin("tracking");
  for (auto& [number, object] : followed_) object.filter.predict(scan.time - *time_);
  time_ = scan.time;
  clusters_.clear();
  if (truth_) follow(scan);
  truth_.reset();
}

void ExactPositions::follow(const ldm::Scan& scan) {
  const Eigen::Matrix2d covariance = kSigma * kSigma * Eigen::Matrix2d::Identity();
  std::map<std::size_t, std::vector<Eigen::Vector3d>> returns;  // by position in the truth
  const std::vector<std::int32_t> owners =
      datasets::objects_hit(*truth_, scan.T_world_sensor.translation);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] < 0) continue;
    returns[static_cast<std::size_t>(owners[i])].push_back(scan.T_world_sensor *
                                                           scan.points[i].cast<double>());
  }
  for (auto& [index, points] : returns) {
    const datasets::ObjectState& object = truth_->objects[index];
    const Eigen::Vector2d position = object.position.head<2>();
    auto found = followed_.find(object.id);
    if (found != followed_.end() && scan.time - found->second.seen > kMemory) {
      followed_.erase(found);
      found = followed_.end();
    }
    if (found == followed_.end()) {
      const Followed fresh{scan.time, scan.time, ldm::MotionFilter(position, covariance)};
      found = followed_.emplace(object.id, fresh).first;
    } else {
      found->second.filter.update(position, covariance);
      found->second.seen = scan.time;
    }
    const Followed& followed = found->second;
    const Eigen::Vector2d velocity = followed.filter.state().mean.tail<2>();
    ldm::Cluster cluster;
    cluster.id = object.id + 1;
    cluster.age = scan.time - followed.since;
    cluster.velocity << velocity.cast<float>(), 0;
    const Eigen::Matrix2f c = followed.filter.velocity_covariance().cast<float>();
    cluster.velocity_covariance = 0.5F * (c + c.transpose());
    cluster.dynamic = velocity.norm() >= static_below_;
    clusters_.add(cluster, std::move(points));
  }
}

void ExactPositions::read(ldm::LocalMap& map) const {
  map_.read(map);
  clusters_.read(map);
}

}  // namespace experiments
