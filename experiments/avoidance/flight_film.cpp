#include "experiments/avoidance/flight_film.h"

#include <cmath>
#include <utility>

#include "datasets/scenario/flight/bspline.h"
#include "experiments/pictures/map_picture.h"

namespace experiments {
namespace {

constexpr Colour kFlownColour{40, 48, 66}, kPlannedColour{140, 30, 190};
constexpr double kPathStep = 0.1;   ///< between the balls of a planned path [s]
constexpr double kLastPicture = 1;  ///< for which the end is shown [s]

const std::filesystem::path& film_name(const std::filesystem::path& file) {
  check_ending("--video", file, ".mp4");
  return file;
}

/// What is still ahead of a plan.
Picture::Path planned_path(const FlightMoment& moment, double knot_step) {
  Picture::Path path{
      {}, kPlannedColour, moment.plan.braking ? "planned path: brakes" : "planned path"};
  const double end = static_cast<double>(moment.plan.points.size() - 3) * knot_step;
  const double now = moment.frame.scan.time - moment.planned_at;
  for (double t = now + kPathStep; t <= end; t += kPathStep) {
    path.points.push_back(datasets::curve_at(moment.plan.points, knot_step, t).cast<float>());
  }
  return path;
}

/// Where it was, as far as the picture's box goes.
Picture::Path flown_path(const std::vector<Eigen::Vector3d>& flown,
                         const Eigen::AlignedBox3d& border) {
  Picture::Path path{{}, kFlownColour, "flown path"};
  for (const Eigen::Vector3d& p : flown) {
    if (border.contains(p)) path.points.push_back(p.cast<float>());
  }
  return path;
}

}  // namespace

FlightFilm::FlightFilm(const std::filesystem::path& file, std::string heading,
                       const FlightTask& task)
    : heading_(std::move(heading)),
      knot_step_(task.planner.knot_step),
      rate_(task.sensor.rate),
      video_(film_name(file), Picture::kWidth, Picture::kHeight, rate_),
      colours_(kClusterColours) {}

void FlightFilm::add(const FlightMoment& moment, const ldm::LocalMap& map) {
  picture_ =
      picture_of(moment.frame, map, colours_.next(moment.frame.scan.time, map.clusters), heading_);
  flown_.push_back(moment.frame.scan.T_world_uav.translation);
  picture_.paths = {planned_path(moment, knot_step_), flown_path(flown_, picture_.border)};
  video_.add(pixels(picture_));
}

void FlightFilm::finish(const std::string& ending) {
  picture_.heading.push_back(ending);
  const std::vector<std::uint8_t> last = pixels(picture_);
  for (double shown = 0; shown < kLastPicture * rate_; ++shown) video_.add(last);
  video_.finish();
}

}  // namespace experiments
