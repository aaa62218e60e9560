#include "experiments/avoidance/fly.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <ostream>

#include "datasets/files/partial_file.h"
#include "datasets/scenario/flight/bspline.h"
#include "experiments/avoidance/flight_film.h"
#include "experiments/avoidance/flight_record.h"
#include "experiments/avoidance/flight_study.h"

namespace experiments {
namespace {

constexpr double kPlanStep = 0.2;  ///< of the planned paths in plans.csv [s]

/// Appends numbers with commas between, and the end of the line.
class Row {
 public:
  explicit Row(std::ostream& out) : out_(out) {}
  ~Row() { out_ << '\n'; }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  Row& add(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4f", value);
    return add(std::string_view(text));
  }
  Row& add(std::int64_t value) { return add(std::string_view(std::to_string(value))); }
  Row& add(const Eigen::Vector3d& v) { return add(v.x()).add(v.y()).add(v.z()); }

 private:
  Row& add(std::string_view text) {
    if (!first_) out_ << ',';
    first_ = false;
    out_ << text;
    return *this;
  }

  std::ostream& out_;
  bool first_ = true;
};

void write_samples(const Flight& flight, std::ostream& out) {
  out << "time_s,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,clearance_m,braking\n";
  for (const FlightSample& sample : flight.samples) {
    Row(out)
        .add(sample.time)
        .add(sample.position)
        .add(sample.velocity)
        .add(sample.acceleration)
        .add(sample.clearance)
        .add(std::int64_t{sample.braking});
  }
}

void write_obstacles(const datasets::Frame& frame, std::ostream& out) {
  for (const datasets::ObjectState& object : frame.truth->objects) {
    Row(out)
        .add(frame.scan.time)
        .add(std::int64_t{object.id})
        .add(std::int64_t{object.dynamic})
        .add(object.position)
        .add(object.size);
  }
}

void write_plan(const datasets::Frame& frame, const Plan& plan, double knot_step,
                std::ostream& out) {
  const double end = static_cast<double>(plan.points.size() - 3) * knot_step;
  for (double t = 0; t <= end + kPlanStep / 2; t += kPlanStep) {
    Row(out)
        .add(frame.scan.time)
        .add(t)
        .add(datasets::curve_at(plan.points, knot_step, t))
        .add(std::int64_t{plan.braking});
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
  for (const std::string& text : request.settings) {
    apply(parse_setting(text), record.settings);
  }
  record.command = request.command;
  record.world = datasets::read_scenario(folders.corridors.file(request.world));
  record.seed = request.seed;
  const FlightTask task = flight_task(record.world, record.seed, record.settings);
  datasets::make_folder(request.output);
  datasets::PartialFile samples(request.output / "flight.csv");
  datasets::PartialFile obstacles(request.output / "obstacles.csv");
  datasets::PartialFile plans(request.output / "plans.csv");
  datasets::PartialFile summary(request.output / "summary.json");
  obstacles.stream() << "time_s,id,dynamic,x_m,y_m,z_m,size_x_m,size_y_m,size_z_m\n";
  plans.stream() << "planned_at_s,ahead_s,x_m,y_m,z_m,braking\n";
  const Arm& arm = record.settings.arm;
  const std::unique_ptr<Sight> sight = arm.sight(record.settings.map, task.corridor);
  std::optional<FlightFilm> film;
  if (request.video) film.emplace(*request.video, heading(request), task);
  const auto observe = [&](const FlightMoment& moment) {
    if (moment.planned_at == moment.frame.scan.time) {
      write_obstacles(moment.frame, obstacles.stream());
      write_plan(moment.frame, moment.plan, task.planner.knot_step, plans.stream());
    }
    if (film) film->add(moment, sight->map());
  };
  record.flight = fly(task, *sight, observe);
  record.scores = flight_scores(task, record.flight);
  if (film) film->finish(ending(record.flight));
  write_samples(record.flight, samples.stream());
  summary.stream() << to_json(record, provenance());
  for (datasets::PartialFile* file : {&samples, &obstacles, &plans, &summary}) file->commit();

  out << ending(record.flight) << '\n';
}

}  // namespace experiments
