#include "datasets/scenario/obstacle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "datasets/quaternion_pose.h"
#include "datasets/solid_bounds.h"

namespace datasets {
namespace {

Solid upright(Solid::Shape shape, const Eigen::Vector3d& centre, const Eigen::Vector3d& size) {
  return {shape, {Eigen::Matrix3d::Identity(), centre}, size};
}

/// Legs, torso and head in the proportions of a grown-up: crotch at 47%, shoulders at 85% of the
/// height, and a head 14% high.
std::vector<Solid> person(double width, double height) {
  const double crotch = 0.47 * height, shoulders = 0.85 * height, head = 0.14 * height;
  const double leg = 0.36 * width, depth = 0.5 * width;
  const auto z = [height](double from, double to) { return (from + to - height) / 2; };
  return {
      upright(Solid::Shape::kBox, {0, 0, z(crotch, shoulders)}, {depth, width, shoulders - crotch}),
      upright(Solid::Shape::kSphere, {0, 0, z(height - head, height)},
              Eigen::Vector3d::Constant(head)),
      upright(Solid::Shape::kCylinder, {0, 0.25 * width, z(0, crotch)}, {leg, leg, crotch}),
      upright(Solid::Shape::kCylinder, {0, -0.25 * width, z(0, crotch)}, {leg, leg, crotch}),
  };
}

/// Upper bound of the distance of the solid's points from the z axis: exact for upright boxes and
/// for upright cylinders and spheres.
double reach(const Solid& solid) {
  const double offset = solid.T_world_solid.translation.head<2>().norm();
  const Eigen::Vector3d half = solid.size / 2;
  if (solid.shape != Solid::Shape::kBox) return offset + half.x();
  return offset + half.head<2>().norm();
}

/// A leg turned about its upper end, its foot forward for angles above 0.
void swing(Solid& leg, double angle) {
  const Eigen::Vector3d below_hip(0, 0, -leg.size.z() / 2);
  const Eigen::Vector3d hip = leg.T_world_solid.translation - below_hip;
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(-angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
  leg.T_world_solid = {turn, hip + turn * below_hip};
}

void swing_legs(const Gait& gait, const MotionState& moved, std::vector<Solid>& solids) {
  const double phase = 2 * std::numbers::pi * moved.walked / gait.stride + gait.phase;
  const double angle = gait.widest * moved.pace * std::sin(phase);
  swing(solids[gait.left_leg], angle);
  swing(solids[gait.right_leg], -angle);
}

/// Makes a person walk. A foot reaches a quarter of a stride before and behind the hip.
void add_gait(const ObstacleGroup& group, Random& random, ObstacleBody& body) {
  Gait gait;
  gait.stride = random.uniform(group.stride);
  gait.phase = random.uniform(-std::numbers::pi, std::numbers::pi);
  gait.left_leg = body.solids.size() - 2;
  gait.right_leg = body.solids.size() - 1;
  const Solid& leg = body.solids[gait.left_leg];
  gait.widest = std::atan(gait.stride / 4 / leg.size.z());
  Solid swung = leg;
  swing(swung, gait.widest);
  const Eigen::Vector3d& centre = swung.T_world_solid.translation;
  const Eigen::Vector3d half = half_extent(swung);
  body.radius = std::max(
      body.radius, std::hypot(std::abs(centre.x()) + half.x(), std::abs(centre.y()) + half.y()));
  body.gait = gait;
}

}  // namespace

ObstacleBody draw_body(const ObstacleGroup& group, Random& random) {
  const double width = random.uniform(group.width);
  const double height = random.uniform(group.height);
  ObstacleBody body;
  body.height = height;
  switch (group.shape) {
    case ObstacleShape::kBox:
      body.solids = {upright(Solid::Shape::kBox, Eigen::Vector3d::Zero(),
                             {random.uniform(group.width), width, height})};
      break;
    case ObstacleShape::kCylinder:
      body.solids = {
          upright(Solid::Shape::kCylinder, Eigen::Vector3d::Zero(), {width, width, height})};
      break;
    case ObstacleShape::kPerson:
    case ObstacleShape::kWalker:
      body.solids = person(width, height);
      break;
  }
  for (const Solid& solid : body.solids) body.radius = std::max(body.radius, reach(solid));
  if (group.shape == ObstacleShape::kWalker) add_gait(group, random, body);
  return body;
}

void Obstacle::state_at(double t, ObjectState& state) const {
  const MotionState moved = motion.at(t);
  const auto in_plane = [](const Eigen::Vector2d& v) { return Eigen::Vector3d(v.x(), v.y(), 0); };
  state.id = id;
  state.dynamic = !motion.is_static();
  state.velocity = in_plane(moved.velocity);
  state.acceleration = in_plane(moved.acceleration);
  const ldm::Pose T_world_obstacle{
      Eigen::AngleAxisd(moved.heading, Eigen::Vector3d::UnitZ()).toRotationMatrix(),
      Eigen::Vector3d(moved.position.x(), moved.position.y(), bottom + body.height / 2)};
  state.position = T_world_obstacle.translation;
  state.solids = body.solids;
  if (body.gait) swing_legs(*body.gait, moved, state.solids);
  Eigen::Vector3d reached = Eigen::Vector3d::Zero();
  for (Solid& solid : state.solids) {
    solid.T_world_solid = composed(T_world_obstacle, solid.T_world_solid);
    const Eigen::Vector3d offset = solid.T_world_solid.translation - state.position;
    reached = reached.cwiseMax(offset.cwiseAbs() + half_extent(solid));
  }
  state.size = 2 * reached;
}

}  // namespace datasets
