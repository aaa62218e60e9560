#include "experiments/runs/score.h"

#include <cstdio>

#include "datasets/files/csv.h"
#include "datasets/files/partial_file.h"
#include "datasets/files/text.h"
#include "experiments/runs/label_score.h"
#include "experiments/runs/score_json.h"
#include "experiments/runs/truth_table.h"

namespace experiments {
namespace {

constexpr std::string_view kScoreColumns =
    "id,dynamic,frames,matched,position_error_m,velocity_error_mps,tracks,switches";

/// Empty, or `nothing`, of no observation.
std::string number(const Mean& mean, int decimals, std::string_view nothing = "") {
  return mean.value() ? datasets::rounded(*mean.value(), decimals) : std::string(nothing);
}

std::string percent(const Mean& mean) {
  return mean.value() ? datasets::rounded(100 * *mean.value(), 1) + " %" : "none";
}

void print_row(const std::string& name, const std::string& kind, const ObjectScore& score,
               std::ostream& out) {
  const double share =
      100.0 * static_cast<double>(score.matched()) / static_cast<double>(score.frames);
  char line[160];
  std::snprintf(line, sizeof line, "%-10s %-8s %8lld %9.1f %%  %10s  %12s %7lld %9lld\n",
                name.c_str(), kind.c_str(), static_cast<long long>(score.frames), share,
                number(score.position_error, 3, "-").c_str(),
                number(score.velocity_error, 3, "-").c_str(), static_cast<long long>(score.tracks),
                static_cast<long long>(score.switches));
  out << line;
}

void print_sum(const std::string& kind, const ObjectScore& score, std::ostream& out) {
  if (score.frames > 0) print_row("all " + std::to_string(score.objects), kind, score, out);
}

void print(const TruthScore& score, std::ostream& out) {
  out << "object     kind       frames   detected  position/m  velocity/mps  tracks  switches\n";
  for (const auto& [id, object] : score.objects) {
    print_row(std::to_string(id), object.dynamic ? "dynamic" : "static", object.score, out);
  }
  print_sum("dynamic", score.of_dynamic, out);
  print_sum("static", score.of_static, out);
  out << "dynamic clusters: " << score.dynamic_without_object << " without an object, "
      << score.dynamic_on_static << " on static ones, in " << score.frames << " frames";
  if (score.not_run > 0) out << "; " << score.not_run << " more of the truth are not in the run";
  out << "\nmoving objects: " << percent(score.recall) << " found, " << percent(score.precision)
      << " of the dynamic clusters are one\n";
}

void print(const LabelScore& score, std::ostream& out) {
  const auto iou = [](const PointCounts& counts) {
    const std::optional<double> share = counts.moving_iou();
    return share ? datasets::rounded(100 * *share, 1) + " %" : std::string("none");
  };
  out << "moving points: intersection over union " << iou(score.all) << " of " << score.all.points()
      << " points in " << score.frames << " frames, " << iou(score.in_map) << " of the "
      << score.in_map.points() << " in the map\n";
}

void print(const RunGhosts& ghosts, std::ostream& out) {
  out << "ghosts: " << datasets::rounded(ghosts.voxels_per_frame, 1) << " voxels a frame, in "
      << ghosts.frames << " frames with a saved map; 90 % of what was left is cleared ";
  if (ghosts.seconds_to_clear) {
    out << "after " << datasets::rounded(*ghosts.seconds_to_clear, 2) << " s\n";
  } else {
    out << "never, or nothing was left\n";
  }
}

void write_csv(const TruthScore& score, std::ostream& out) {
  constexpr int kDecimals = 6;
  datasets::CsvWriter csv(out, kScoreColumns);
  for (const auto& [id, object] : score.objects) {
    const ObjectScore& s = object.score;
    csv.add(id).add(std::int64_t{object.dynamic}).add(s.frames).add(s.matched());
    csv.add(number(s.position_error, kDecimals)).add(number(s.velocity_error, kDecimals));
    csv.add(s.tracks).add(s.switches).end_row();
  }
}

}  // namespace

void score_run(const ScoreRequest& request, std::ostream& out) {
  if (!request.truth && !request.labels) {
    throw ldm::InvalidInput(
        "score: no reference: allowed: --truth FILE.csv, --labels FOLDER, or both");
  }
  RunScores scores;
  if (request.truth) {
    const auto run = read_run_frames(request.run);
    const TruthTable truth = read_truth_table(*request.truth);
    scores.objects = score(run, truth, request.gate);
    scores.ghosts = ghosts_of_run(request.run, run, truth);
  }
  if (request.labels) scores.points = score_labels(request.run, *request.labels);

  datasets::PartialFile json(request.run / "score.json");
  json.stream() << to_json(request, scores);
  if (scores.objects) {
    datasets::PartialFile csv(request.run / "score.csv");
    write_csv(*scores.objects, csv.stream());
    datasets::commit_together({&csv, &json});
    print(*scores.objects, out);
  } else {
    json.commit();
    std::filesystem::remove(request.run / "score.csv");  // of an earlier reference
  }
  if (scores.ghosts) print(*scores.ghosts, out);
  if (scores.points) print(*scores.points, out);
}

}  // namespace experiments
