#pragma once
/// What a method knows, frame by frame, as pictures (no paper section; docs/pictures.md).
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiments/method/method_on_input.h"
#include "experiments/pictures/cluster_colours.h"
#include "experiments/pictures/picture.h"

namespace experiments {

/// Runs a method over its input; a picture of the last frame is drawn on demand.
class PictureStream {
 public:
  /// @param request if its `input` is empty, `method` is the folder of a run, which is repeated
  /// @throws ldm::InvalidInput on a bad request.
  PictureStream(const MethodOnInput& request, const DataFolders& folders);

  /// Take the next frame; false after the last.
  bool next();
  /// Of the last frame taken.
  Picture picture() const;

  const std::string& input() const { return request_.input; }
  std::optional<std::int64_t> size() const { return source_->size(); }
  double time() const { return frame_.scan.time; }  ///< of the last frame [s]
  std::size_t clusters() const { return map_.clusters.size(); }

 private:
  MethodOnInput request_;
  std::unique_ptr<ldm::Mapper> mapper_;
  std::unique_ptr<datasets::FrameSource> source_;
  ClusterColours colours_;
  datasets::Frame frame_;
  ldm::LocalMap map_;
  std::vector<std::size_t> colour_of_;  ///< of the clusters
};

}  // namespace experiments
