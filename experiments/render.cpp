#include "experiments/render.h"

#include "experiments/cluster_colours.h"
#include "experiments/map_picture.h"
#include "experiments/partial_file.h"
#include "experiments/progress_line.h"

namespace experiments {
namespace {

[[noreturn]] void refuse_frame(const RenderRequest& request, std::int64_t frames) {
  throw ldm::InvalidInput("--frame " + std::to_string(request.frame) + ": allowed: 0 to " +
                          std::to_string(frames - 1) + ", the frames of " + request.input);
}

std::string heading(const RenderRequest& request) {
  std::string text = request.method + ", ";
  text += std::filesystem::path(request.input).stem().string();
  if (!request.is_log()) text += ", seed " + std::to_string(request.seed.value_or(1));
  return text;
}

}  // namespace

void render(const RenderRequest& request, const DataFolders& folders) {
  const Method& method = find_method(request.method);
  const std::unique_ptr<ldm::Mapper> mapper = method.create(parameters_of(request, method));
  const std::unique_ptr<datasets::FrameSource> source = open_input(request, folders);
  if (request.output.extension() != ".png") {
    throw ldm::InvalidInput("--output " + request.output.string() + ": allowed: FILE.png");
  }
  if (source->size() && request.frame >= *source->size()) refuse_frame(request, *source->size());
  PartialFile file(request.output);

  ProgressLine progress(request.frame + 1);
  ClusterColours colours(kClusterColours);
  datasets::Frame frame;
  ldm::LocalMap map;
  std::vector<std::size_t> colour_of;
  for (std::int64_t frames = 0; frames <= request.frame; ++frames) {
    if (!source->next(frame)) refuse_frame(request, frames);
    mapper->update(frame.scan);
    mapper->read(map);
    colour_of = colours.next(frame.scan.time, map.clusters);
    progress.show(frames + 1, std::to_string(map.clusters.size()) + " clusters");
  }
  datasets::write_png(picture_of(frame, map, colour_of, heading(request)), file.temporary_name());
  file.commit();
}

}  // namespace experiments
