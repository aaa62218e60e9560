#pragma once
/// Every parameter of the method and of its baselines, once: symbol, unit, value, range, source.
///
/// The values are the paper's where it gives one; "assumed" marks those it leaves open, settled in
/// REPRODUCING.md. `visit_parameters` at the end is the table that every reader and writer uses.
#include <cstdint>
#include <string>
#include <string_view>

#include "ldm/types.h"

namespace ldm {

/// How occupancy moves with its cluster when v dt is not a whole number of voxels (Fig. 3).
enum class SubVoxelMotion {
  kNone,       ///< no occupancy prediction
  kRound,      ///< each frame by the nearest whole number of voxels; the rest is lost
  kResidual,   ///< by whole voxels; the rest is carried to the next frame with the cluster
  kTrilinear,  ///< probabilities are shared out to the eight voxels around the moved centre
};
inline constexpr std::string_view kSubVoxelMotionNames[] = {"none", "round", "residual",
                                                            "trilinear"};

/// What a ray without a return says.
enum class NoReturnRays {
  kFree,  ///< free space up to the border of the map
  kDrop,  ///< nothing
};
inline constexpr std::string_view kNoReturnRaysNames[] = {"free", "drop"};

struct MapParameters {
  double resolution = 0.15;
  Eigen::Vector3i voxels{32, 32, 32};
};

struct SensorModelParameters {
  double p_occ = 0.7;
  double p_free = 0.4;
  double log_odds_min = -2.0;
  double log_odds_max = 3.5;
  NoReturnRays no_returns = NoReturnRays::kFree;
};

struct SurvivalParameters {
  bool enabled = true;
  double outside_view = 0.9;
  double shadow = 0.98;
  double shadow_range = 0.3;
};

struct PredictionParameters {
  SubVoxelMotion sub_voxel = SubVoxelMotion::kResidual;
  double min_speed = 0.1;
};

struct ParticleParameters {
  std::int64_t count = 200000;
  double sigma_xy = 0.35;
  double sigma_z = 0.07;
  bool birth = true;
  std::int64_t min_per_voxel = 800;
};

struct ClusterParameters {
  double occupied_above = 0.5;
  double static_below = 0.2;
  bool readjust = true;
};

struct ExecutionParameters {
  std::int64_t threads = 1;
  std::uint64_t seed = 1;
};

struct Parameters {
  MapParameters map;
  SensorModelParameters sensor_model;
  SurvivalParameters survival;
  PredictionParameters prediction;
  ParticleParameters particles;
  ClusterParameters clusters;
  ExecutionParameters execution;
};

/// What the table says of one parameter beside its value. Bounds are inclusive.
struct ParameterInfo {
  std::string_view name;    ///< as in a TOML file: section.key, unit at the end
  std::string_view symbol;  ///< the paper's, or empty
  std::string_view unit;    ///< empty: a pure number
  double min = 0;
  double max = 0;
  std::string_view source;  ///< section or equation of the paper, or "assumed"
  std::string_view help;
};

/// Calls `visit(const ParameterInfo&, T& value)` for each parameter in turn, and
/// `visit(info, value, names)` for an enumeration (`names[i]` is the word for value i).
/// T is double, std::int64_t, std::uint64_t, bool, Eigen::Vector3i or an enumeration, const if P
/// is.
template <class P, class Visitor>
void visit_parameters(P& p, Visitor&& visit) {
  using Info = ParameterInfo;
  visit(Info{"map.resolution_m", "r", "m", 0.01, 10, "Sec. 4.1.1", "edge of a voxel"},
        p.map.resolution);
  visit(Info{"map.voxels", "M", "", 5, 512, "Sec. 4.1.1", "voxels along x, y, z"}, p.map.voxels);

  visit(Info{"sensor_model.p_occ", "p_occ", "", 0.501, 0.999, "Eq. 9, value of [9]",
             "probability of occupied given a hit"},
        p.sensor_model.p_occ);
  visit(Info{"sensor_model.p_free", "p_free", "", 0.001, 0.499, "Eq. 9, value of [9]",
             "probability of occupied given a crossing ray"},
        p.sensor_model.p_free);
  visit(Info{"sensor_model.log_odds_min", "l_min", "", -20, -0.1, "value of [9]",
             "lower clamp of the log-odds"},
        p.sensor_model.log_odds_min);
  visit(Info{"sensor_model.log_odds_max", "l_max", "", 0.1, 20, "value of [9]",
             "upper clamp of the log-odds"},
        p.sensor_model.log_odds_max);
  visit(Info{"sensor_model.no_returns", "", "", 0, 1, "assumed",
             "a ray without a return marks free space up to the map border, or nothing"},
        p.sensor_model.no_returns, kNoReturnRaysNames);

  visit(Info{"survival.enabled", "", "", 0, 1, "Sec. 3.3.2", "voxels without a flag decay"},
        p.survival.enabled);
  visit(Info{"survival.outside_view", "P_s", "", 0, 1, "Eq. 10, value assumed",
             "survival out of the sensor's view"},
        p.survival.outside_view);
  visit(Info{"survival.shadow", "P_s", "", 0, 1, "Eq. 10, value assumed",
             "survival just behind an obstacle"},
        p.survival.shadow);
  visit(Info{"survival.shadow_range_m", "", "m", 0.01, 100, "Sec. 3.3.2, value assumed",
             "survival falls as 1/distance beyond this distance behind the obstacle"},
        p.survival.shadow_range);

  visit(Info{"prediction.sub_voxel", "", "", 0, 3, "Sec. 3.2, Fig. 3, way assumed",
             "how occupancy moves by less than a voxel"},
        p.prediction.sub_voxel, kSubVoxelMotionNames);
  visit(Info{"prediction.min_speed_mps", "", "m/s", 0, 100, "assumed",
             "clusters slower than this are not moved; 0 moves all"},
        p.prediction.min_speed);

  visit(Info{"particles.count", "N_init", "", 1, 50e6, "Sec. 4.1.1", "particles after resampling"},
        p.particles.count);
  visit(Info{"particles.sigma_xy_mps", "Sigma", "m/s", 0, 3, "Eq. 4, value assumed",
             "process noise of a particle's horizontal velocity, per axis and frame"},
        p.particles.sigma_xy);
  visit(Info{"particles.sigma_z_mps", "Sigma", "m/s", 0, 3, "Eq. 4, value assumed",
             "process noise of a particle's vertical velocity, per frame"},
        p.particles.sigma_z);
  visit(Info{"particles.birth", "", "", 0, 1, "Eq. 13", "new particles in occupied voxels"},
        p.particles.birth);
  visit(Info{"particles.min_per_voxel", "", "", 1, 10000, "Sec. 3.3.3, value assumed",
             "an occupied voxel with fewer particles is filled up to this number"},
        p.particles.min_per_voxel);

  visit(Info{"clusters.occupied_above", "", "", 0.01, 0.99, "Sec. 3.5, value assumed",
             "voxels of a higher probability are occupied: clustered, and given particles"},
        p.clusters.occupied_above);
  visit(Info{"clusters.static_below_mps", "", "m/s", 0, 100, "Sec. 3.3.2, value assumed",
             "threshold velocity: a slower voxel is static"},
        p.clusters.static_below);
  visit(
      Info{"clusters.readjust", "", "", 0, 1, "Eq. 17", "particles take their cluster's velocity"},
      p.clusters.readjust);

  visit(Info{"execution.threads", "", "", 0, 256, "-", "threads of one update; 0: as many as pay"},
        p.execution.threads);
  visit(Info{"execution.seed", "", "", 0, 18446744073709551615.0, "-", "of the particle filter"},
        p.execution.seed);
}

/// The value of one parameter as text: a number, `true`, a word, or "32,32,32".
/// @throws InvalidInput if there is no such parameter.
std::string get_parameter(const Parameters& parameters, std::string_view name);

/// Set one parameter from text, in the form `get_parameter` writes it; `map.voxels` also takes one
/// number for all axes.
/// @throws InvalidInput naming the parameter, the text and the allowed range; nothing is changed.
void set_parameter(Parameters& parameters, std::string_view name, std::string_view text);

/// The threads that pay: one for each million, or part of one, of voxels and particles together, at
/// most as many as run at once (parallel.h). A second one brings less than 1.4 times the speed on a
/// smaller map (docs/benchmarks.md).
std::int64_t threads_that_pay(const Parameters& parameters);

/// Its argument. @throws InvalidInput naming the first parameter out of its range, its value and
/// the range.
const Parameters& checked(const Parameters& parameters);

}  // namespace ldm
