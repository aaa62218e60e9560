#include "experiments/avoidance/flight.h"

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "datasets/scenario/flight/bspline.h"
#include "experiments/avoidance/solid_distance.h"
#include "experiments/avoidance/thread_time.h"

namespace experiments {
namespace {

using datasets::Derivative;

constexpr double kJudgeStep = 0.02;  ///< [s]
constexpr double kArrived = 0.5;     ///< from the goal [m]

void check(const FlightTask& task) {
  if (!(task.delay >= 0 && task.delay <= 1)) {
    throw ldm::InvalidInput("delay = " + std::to_string(task.delay) + ": allowed: 0 to 1 s");
  }
  const double scans = task.planner.knot_step * task.sensor.rate;
  if (!(scans >= 1 && std::abs(scans - std::round(scans)) < 1e-9)) {
    throw ldm::InvalidInput("sensor.rate_hz = " + std::to_string(task.sensor.rate) +
                            ": allowed: a whole number of scans in a knot step of " +
                            std::to_string(task.planner.knot_step) + " s");
  }
}

/// The state of one flight under way.
class Loop {
 public:
  Loop(const FlightTask& task, Sight& sight, const FlightObserver& observer)
      : task_(task),
        sight_(sight),
        observer_(observer),
        caster_(lidar_model(task.sensor)),
        T_uav_sensor_(sensor_pose(task.sensor)),
        planner_(task.planner, task.corridor.start, task.corridor.goal),
        heading_(std::atan2(task.corridor.goal.y() - task.corridor.start.y(),
                            task.corridor.goal.x() - task.corridor.start.x())),
        waits_(static_cast<std::size_t>(std::ceil(task.delay / task.planner.knot_step - 1e-9))) {
    flight_.points.assign(3 + waits_, task.corridor.start);
    // A path has a first segment before anything was planned.
    braking_.assign(waits_, false);
    for (std::size_t i = 0; i < planner_.sample_count(); ++i) {
      sample_times_.push_back(static_cast<double>(i) * planner_.sample_step());
    }
    frame_.truth.emplace();
    frame_.truth->objects.resize(task.corridor.obstacles.size());
  }

  Flight run() {
    const double scan_step = 1 / task_.sensor.rate;
    const auto scans_a_plan = std::llround(task_.planner.knot_step / scan_step);
    const auto judged_a_scan = std::max(1LL, std::llround(scan_step / kJudgeStep));
    const auto scans = std::llround(task_.corridor.duration * task_.sensor.rate);
    for (std::int64_t scan = 0; scan < scans; ++scan) {
      const double t = static_cast<double>(scan) * scan_step;
      see(scan, t);
      if (scan % scans_a_plan == 0) plan();
      if (observer_) observer_({frame_, plan_, planned_at_});
      if (scan == 0 && judge(0)) return std::move(flight_);
      for (long long i = 1; i <= judged_a_scan; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(judged_a_scan);
        if (judge(t + share * scan_step)) return std::move(flight_);
      }
    }
    return std::move(flight_);
  }

 private:
  Eigen::Vector3d flown(double t, Derivative derivative = Derivative::kPosition) const {
    return datasets::curve_at(flight_.points, task_.planner.knot_step, t, derivative);
  }

  void see(std::int64_t index, double t) {
    frame_.index = index;
    frame_.scan.time = t;
    // Before the first plan there is no segment: at rest.
    const bool begun = flight_.points.size() > 3;
    frame_.scan.T_world_uav = datasets::multirotor_pose(
        begun ? flown(t) : task_.corridor.start,
        begun ? flown(t, Derivative::kAcceleration) : Eigen::Vector3d::Zero(), heading_);
    frame_.scan.T_world_sensor = datasets::composed(frame_.scan.T_world_uav, T_uav_sensor_);
    for (std::size_t i = 0; i < frame_.truth->objects.size(); ++i) {
      task_.corridor.obstacles[i].state_at(t, frame_.truth->objects[i]);
    }
    const std::uint64_t key =
        datasets::random_bits(datasets::mixed(task_.noise_seed), static_cast<std::uint64_t>(index));
    caster_.cast(frame_.scan.T_world_sensor, frame_.truth->objects, key, image_,
                 frame_.truth->noise_free_hits);
    caster_.beams().project(image_, frame_.scan);
    flight_.map_ms.push_back(thread_time_of([&] { sight_.see(frame_); }));
    for (const datasets::ObjectState& object : frame_.truth->objects) {
      if (known_from_.contains(object.id) || !sight_.knows(object)) continue;
      known_from_[object.id] = signed_distance(object, frame_.scan.T_world_uav.translation);
    }
  }

  void plan() {
    flight_.field_ms.push_back(
        thread_time_of([&] { sight_.predict(sample_times_, surroundings_); }));
    const ControlPoints fixed(flight_.points.end() - static_cast<std::ptrdiff_t>(3 + waits_),
                              flight_.points.end());
    flight_.solve_ms.push_back(
        thread_time_of([&] { plan_ = planner_.next(fixed, surroundings_); }));
    planned_at_ = frame_.scan.time;
    flight_.points.push_back(plan_.points[fixed.size()]);
    if (plan_.braking && (braking_.empty() || !braking_.back())) ++flight_.brakings;
    braking_.push_back(plan_.braking);
  }

  /// Note where the UAV is; true if the flight ends here.
  bool judge(double t) {
    FlightSample sample;
    sample.time = t;
    const bool begun = flight_.points.size() > 3;
    sample.position = begun ? flown(t) : task_.corridor.start;
    sample.velocity = begun ? flown(t, Derivative::kVelocity) : Eigen::Vector3d::Zero();
    sample.acceleration = begun ? flown(t, Derivative::kAcceleration) : Eigen::Vector3d::Zero();
    const auto segment = static_cast<std::size_t>(t / task_.planner.knot_step);
    sample.braking = segment < braking_.size() && braking_[segment];
    sample.clearance = std::numeric_limits<double>::infinity();
    const datasets::Obstacle* nearest = nullptr;
    for (const datasets::Obstacle& obstacle : task_.corridor.obstacles) {
      const datasets::MotionState moved = obstacle.motion.at(t);
      const double least = (moved.position - sample.position.head<2>()).norm() -
                           obstacle.body.radius - task_.planner.radius;
      if (least >= sample.clearance) continue;  // its cylinder is farther than another's surface
      obstacle.state_at(t, object_);
      const double clearance = signed_distance(object_, sample.position) - task_.planner.radius;
      if (clearance >= sample.clearance) continue;
      sample.clearance = clearance;
      nearest = &obstacle;
    }
    flight_.samples.push_back(sample);
    if (sample.clearance <= 0) return end_by_hitting(*nearest, sample.braking);
    if ((sample.position - task_.corridor.goal).norm() > kArrived) return false;
    flight_.outcome = Outcome::kReached;
    return true;
  }

  bool end_by_hitting(const datasets::Obstacle& obstacle, bool braking) {
    flight_.hit = obstacle.id;
    const auto known = known_from_.find(obstacle.id);
    flight_.hit_known_from = known == known_from_.end() ? 0 : known->second;
    flight_.outcome = braking                       ? Outcome::kHitBraking
                      : obstacle.motion.is_static() ? Outcome::kHitStatic
                                                    : Outcome::kHitMoving;
    return true;
  }

  const FlightTask& task_;
  Sight& sight_;
  const FlightObserver& observer_;
  datasets::LidarCaster caster_;
  ldm::Pose T_uav_sensor_;
  Planner planner_;
  double heading_;
  std::size_t waits_;  // segments that are flown before a plan takes effect
  SampleTimes sample_times_;
  Surroundings surroundings_;
  Plan plan_;
  double planned_at_ = 0;
  std::vector<bool> braking_;  // by segment
  std::map<std::int32_t, double> known_from_;
  datasets::Frame frame_;
  datasets::RangeImage image_;
  datasets::ObjectState object_;
  Flight flight_;
};

}  // namespace

Flight fly(const FlightTask& task, Sight& sight, const FlightObserver& observer) {
  check(task);
  return Loop(task, sight, observer).run();
}

}  // namespace experiments
