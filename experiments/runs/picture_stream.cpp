#include "experiments/runs/picture_stream.h"

#include "experiments/method/map_check.h"
#include "experiments/method/sees_truth.h"
#include "experiments/pictures/map_picture.h"
#include "experiments/runs/run_summary.h"

namespace experiments {
namespace {

MethodOnInput resolved(const MethodOnInput& request) {
  if (!request.input.empty()) return request;
  const datasets::RecordingOptions& recording = request.recording;
  if (request.config || !request.settings.empty() || request.seed || request.format ||
      recording.poses || recording.times || recording.keep_going) {
    throw ldm::InvalidInput("RUN " + request.method +
                            ": is repeated as it was: allowed: no parameters, seed or format");
  }
  return read_request(std::filesystem::path(request.method) / "summary.json");
}

std::string heading(const MethodOnInput& request) {
  std::string text = request.method + ", ";
  text += std::filesystem::path(request.input).stem().string();
  if (!request.is_log()) text += ", seed " + std::to_string(request.world_seed());
  return text;
}

}  // namespace

PictureStream::PictureStream(const MethodOnInput& request, const DataFolders& folders)
    : request_(resolved(request)), colours_(kClusterColours) {
  const Method& method = find_method(request_.method);
  mapper_ = method.create(parameters_of(request_, method, folders));
  source_ = open_input(request_, folders);
}

bool PictureStream::next() {
  if (!source_->next(frame_)) return false;
  update(*mapper_, frame_);
  mapper_->read(map_);
  check_map(map_, request_.method, frame_.index);
  colour_of_ = colours_.next(frame_.scan.time, map_.clusters);
  return true;
}

Picture PictureStream::picture() const {
  return picture_of(frame_, map_, colour_of_, heading(request_));
}

}  // namespace experiments
