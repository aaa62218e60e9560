#include "experiments/runs/render.h"

#include <algorithm>
#include <cmath>

#include "datasets/files/partial_file.h"
#include "experiments/pictures/video_file.h"
#include "experiments/runs/interruption.h"
#include "experiments/runs/picture_stream.h"
#include "experiments/runs/progress_line.h"

namespace experiments {
namespace {

namespace fs = std::filesystem;

void check(const RenderRequest& request) {
  if (!request.output && !request.video) {
    throw ldm::InvalidInput(
        "--output is required: allowed: -o FILE.png with --frame, or --video FILE.mp4");
  }
  if (request.output.has_value() != request.frame.has_value()) {
    throw ldm::InvalidInput(request.output ? "--frame is required with --output"
                                           : "--output is required with --frame");
  }
  if (request.output && request.video) {
    throw ldm::InvalidInput("--output and --video: allowed: one of them");
  }
  if (request.output) check_ending("--output", *request.output, ".png");
  if (request.video) check_ending("--video", *request.video, ".mp4");
  if (request.to && *request.to < request.from) {
    throw ldm::InvalidInput("--to " + std::to_string(*request.to) +
                            ": allowed: not before --from " + std::to_string(request.from));
  }
}

/// @throws ldm::InvalidInput if the log has `frames` frames only.
void check_frame(const char* option, std::int64_t frame, std::optional<std::int64_t> frames,
                 const std::string& input) {
  if (!frames || frame < *frames) return;
  throw ldm::InvalidInput(std::string(option) + " " + std::to_string(frame) + ": allowed: 0 to " +
                          std::to_string(*frames - 1) + ", the frames of " + input);
}

std::string cluster_count(const PictureStream& stream) {
  return std::to_string(stream.clusters()) + " clusters";
}

void render_still(const RenderRequest& request, PictureStream& stream) {
  check_frame("--frame", *request.frame, stream.size(), stream.input());
  datasets::PartialFile file(*request.output);
  ProgressLine progress(*request.frame + 1);
  for (std::int64_t frames = 0; frames <= *request.frame; ++frames) {
    if (!stream.next()) check_frame("--frame", *request.frame, frames, stream.input());
    progress.show(frames + 1, cluster_count(stream));
  }
  write_png(stream.picture(), file);
  file.commit();
}

/// Pictures at equal steps of time: one stays for as long as the log has no other.
class Film {
 public:
  Film(const fs::path& file, double rate)
      : rate_(rate), video_(file, Picture::kWidth, Picture::kHeight, rate) {}

  void add(double time, const Picture& picture) {
    if (!began_) began_ = time;
    const std::int64_t place = std::llround((time - *began_) * rate_);
    for (; shown_ < place; ++shown_) video_.add(pixels_);
    if (shown_ > place) return;  // another of the same step
    pixels_ = pixels(picture);
    video_.add(pixels_);
    ++shown_;
  }
  void finish() { video_.finish(); }

 private:
  double rate_;  // [Hz]
  VideoFile video_;
  std::optional<double> began_;
  std::int64_t shown_ = 0;
  std::vector<std::uint8_t> pixels_;
};

/// That of the first two frames [Hz], within what players show.
double rate_between(double first, double second) {
  return std::clamp(1 / std::max(second - first, 1e-6), 1.0, 100.0);
}

void render_film(const RenderRequest& request, PictureStream& stream) {
  for (const std::int64_t frame : {request.from, request.to.value_or(request.from)}) {
    check_frame(frame == request.from ? "--from" : "--to", frame, stream.size(), stream.input());
  }
  const Interruption interruption;
  const std::optional<std::int64_t> frames =
      request.to ? std::optional(*request.to + 1) : stream.size();
  ProgressLine progress(frames);

  if (!stream.next()) throw ldm::InvalidInput(stream.input() + ": has no frame");
  const double began = stream.time();
  const Picture first = stream.picture();
  bool more = stream.next();
  Film film(*request.video, more ? rate_between(began, stream.time()) : 1);
  if (request.from == 0) film.add(began, first);
  std::int64_t frame = 1;
  for (; more && (!request.to || frame <= *request.to) && !interruption.requested(); ++frame) {
    if (frame >= request.from) film.add(stream.time(), stream.picture());
    progress.show(frame + 1, cluster_count(stream));
    more = stream.next();
  }
  if (!interruption.requested()) {
    check_frame("--to", request.to.value_or(request.from), frame, stream.input());
  }
  film.finish();
}

}  // namespace

void render(const RenderRequest& request, const DataFolders& folders) {
  check(request);
  PictureStream stream(request, folders);
  if (request.output) {
    render_still(request, stream);
  } else {
    render_film(request, stream);
  }
}

}  // namespace experiments
