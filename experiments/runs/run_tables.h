#pragma once
/// The tables that `ldm run` writes while it runs (no paper section; docs/run-output.md).
#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

#include "datasets/files/csv.h"
#include "datasets/frame.h"
#include "experiments/method/stage_clock.h"

namespace experiments {

inline constexpr std::string_view kClusterColumns =
    "frame,time_s,cluster,track,age_s,x_m,y_m,z_m,size_x_m,size_y_m,size_z_m,vx_mps,"
    "vy_mps,vz_mps,vx_vx_m2ps2,vx_vy_m2ps2,vy_vy_m2ps2,voxels,points,dynamic";
inline constexpr std::string_view kFrameColumns =
    "frame,time_s,uav_x_m,uav_y_m,uav_z_m,map_x_m,map_y_m,map_z_m,map_size_x_m,map_size_y_m,"
    "map_size_z_m,points,clusters,dynamic";

/// One row of clusters.csv for each cluster.
void write_clusters(const datasets::Frame& frame, const ldm::LocalMap& map,
                    datasets::CsvWriter& out);

/// One row of frames.csv.
void write_frame(const datasets::Frame& frame, const ldm::LocalMap& map, datasets::CsvWriter& out);

/// timing.csv: raw times of every frame [ms], warm-up included.
/// @param frames numbers of the frames that the clock has timed
void write_timing(const std::vector<std::int64_t>& frames, const StageClock& clock,
                  std::ostream& out);

}  // namespace experiments
