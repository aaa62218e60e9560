/// Worked example of docs/variants.md: the circular buffer, but what no ray meets fades away.
#include <ldm/measurement_flags.h>
#include <ldm/occupancy_update.h>
#include <ldm/plugin.h>
#include <ldm/read_occupancy.h>
#include <ldm/scan_check.h>

#include <optional>

namespace baselines {
namespace {

class FadingBuffer final : public ldm::Mapper {
 public:
  explicit FadingBuffer(const ldm::Parameters& parameters)
      : resolution_(ldm::checked(parameters).map.resolution),
        log_odds_(parameters.map.voxels, 0.0F),
        flags_(parameters.map, parameters.sensor_model.no_returns, parameters.survival.enabled),
        occupancy_(parameters.map, parameters.sensor_model, parameters.survival) {}

  void update(const ldm::Scan& scan, ldm::StageListener* listener) override {
    ldm::check_scan(scan, time_);
    time_ = scan.time;
    if (listener != nullptr) listener->begin("movement_update");
    log_odds_.recenter(ldm::voxel_at(scan.T_world_uav.translation, resolution_));
    if (listener != nullptr) listener->begin("occupancy_update");
    flags_.mark(scan, log_odds_.index().window());
    occupancy_.apply(flags_.flags(), {}, log_odds_);
  }

  void read(ldm::LocalMap& map) const override {
    ldm::read_occupancy(log_odds_, resolution_, map);
    map.labels.assign(map.window.count(), -1);
    map.clusters.clear();
  }

 private:
  double resolution_;
  std::optional<double> time_;  // of the last scan [s]
  ldm::RingBuffer<float> log_odds_;
  ldm::MeasurementFlags flags_;
  ldm::OccupancyUpdate occupancy_;
};

}  // namespace

ldm::Method fading_buffer() {
  return {.name = "fading_buffer",
          .help = "circular_buffer whose voxels fade where no ray meets them",
          .parameters = {"map", "sensor_model", "survival"},
          .overrides = {{"survival.outside_view", "0.95"}},
          .create = ldm::create<FadingBuffer>};
}

}  // namespace baselines

LDM_PLUGIN(baselines::fading_buffer())
