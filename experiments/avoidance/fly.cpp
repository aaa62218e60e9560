#include "experiments/avoidance/fly.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>

#include "datasets/files/csv.h"
#include "datasets/files/partial_file.h"
#include "datasets/scenario/flight/bspline.h"
#include "experiments/avoidance/flight_film.h"
#include "experiments/avoidance/flight_record.h"
#include "experiments/avoidance/flight_study.h"

namespace experiments {
namespace {

constexpr double kPlanStep = 0.2;  ///< of the planned paths in plans.csv [s]

constexpr int kDecimals = 4;

void write_samples(const Flight& flight, std::ostream& out) {
  datasets::CsvWriter csv(
      out, "time_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,clearance_m,braking");
  for (const FlightSample& sample : flight.samples) {
    csv.add(sample.time, kDecimals)
        .add_vector(sample.position, kDecimals)
        .add_vector(sample.velocity, kDecimals)
        .add_vector(sample.acceleration, kDecimals)
        .add(sample.clearance, kDecimals)
        .add(std::int64_t{sample.braking})
        .end_row();
  }
}

void write_obstacles(const datasets::Frame& frame, datasets::CsvWriter& csv) {
  for (const datasets::ObjectState& object : frame.truth->objects) {
    csv.add(frame.scan.time, kDecimals)
        .add(std::int64_t{object.id})
        .add(std::int64_t{object.dynamic})
        .add_vector(object.position, kDecimals)
        .add_vector(object.size, kDecimals)
        .end_row();
  }
}

void write_plan(const datasets::Frame& frame, const Plan& plan, double knot_step,
                datasets::CsvWriter& csv) {
  const double end = static_cast<double>(plan.points.size() - 3) * knot_step;
  for (double t = 0; t <= end + kPlanStep / 2; t += kPlanStep) {
    csv.add(frame.scan.time, kDecimals)
        .add(t, kDecimals)
        .add_vector(datasets::curve_at(plan.points, knot_step, t), kDecimals)
        .add(std::int64_t{plan.braking})
        .end_row();
  }
}

std::string heading(const FlyRequest& request) {
  return request.arm + ", " + std::filesystem::path(request.world).stem().string() + ", seed " +
         std::to_string(request.seed);
}

std::string ending(const Flight& flight) {
  const FlightSample& last = flight.samples.back();
  char text[160];
  std::snprintf(text, sizeof text, "%s after %.2f s at (%.2f, %.2f, %.2f) m",
                kOutcomeNames[static_cast<std::size_t>(flight.outcome)].data(), last.time,
                last.position.x(), last.position.y(), last.position.z());
  return flight.hit ? text + (", obstacle " + std::to_string(*flight.hit)) : text;
}

}  // namespace

void fly(const FlyRequest& request, const DataFolders& folders, std::ostream& out) {
  FlightRecord record;
  record.settings = flight_settings(request.arm);
  record.world = datasets::read_scenario(folders.corridors.file(request.world));
  for (const std::string& text : request.settings) {
    const Setting setting = parse_setting(text);
    if (scenario_key(setting).empty()) {
      apply(setting, record.settings);
    } else {
      apply(setting, record.world);
    }
  }
  record.command = request.command;
  record.scenario_seed = request.seed;
  const FlightTask task = flight_task(record.world, record.scenario_seed, record.settings);
  datasets::make_folder(request.output);
  datasets::PartialFile samples(request.output / "flight.csv");
  datasets::PartialFile obstacles(request.output / "obstacles.csv");
  datasets::PartialFile plans(request.output / "plans.csv");
  datasets::PartialFile summary(request.output / "summary.json");
  datasets::CsvWriter obstacle_rows(obstacles.stream(),
                                    "time_s,id,dynamic,x_m,y_m,z_m,size_x_m,size_y_m,size_z_m");
  datasets::CsvWriter plan_rows(plans.stream(), "planned_at_s,ahead_s,x_m,y_m,z_m,braking");
  const Arm& arm = record.settings.arm;
  const std::unique_ptr<Sight> sight = arm.sight(record.settings.map, task.corridor);
  std::optional<FlightFilm> film;
  if (request.video) film.emplace(*request.video, heading(request), task);
  const auto observe = [&](const FlightMoment& moment) {
    if (moment.planned_at == moment.frame.scan.time) {
      write_obstacles(moment.frame, obstacle_rows);
      write_plan(moment.frame, moment.plan, task.planner.knot_step, plan_rows);
    }
    if (film) film->add(moment, sight->map());
  };
  record.flight = fly(task, *sight, observe);
  record.scores = flight_scores(task, record.flight);
  if (film) film->finish(ending(record.flight));
  write_samples(record.flight, samples.stream());
  summary.stream() << to_json(record, provenance());
  datasets::commit_together({&samples, &obstacles, &plans, &summary});

  out << ending(record.flight) << '\n';
}

}  // namespace experiments
