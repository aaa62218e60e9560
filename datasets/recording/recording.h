#pragma once
/// Recorded data of any known format as a source of frames (no paper section; docs/recordings.md).
#include <filesystem>
#include <memory>
#include <optional>

#include "datasets/frame.h"
#include "datasets/recording/scans/recording_options.h"
#include "datasets/recording/scans/scan_reader.h"

namespace datasets {

/// A folder with velodyne/ is KITTI's, one with velodyne_points/ a raw recording of KITTI's, one
/// with *.pcd files PCD's, one with *.bin files nuScenes'; *.bag, *.mcap, *.db3 and folders of
/// these are bags, *.pcap and *.pcapng recordings of a network; NAME.rawlog is our own log if
/// NAME.log.toml stands beside it, else an MRPT log. None for anything else.
std::optional<RecordingFormat> recognised_format(const std::filesystem::path& path);

/// That of the options, or recognised.
/// @throws ldm::InvalidInput if there is no such file, or it is no recording.
RecordingFormat format_of(const std::filesystem::path& path, const RecordingOptions& options);

/// A recording's frames come in order of time, filtered as `options.input` says; a scan with the
/// time of the one before is left out and counted. A log of our own is taken as it is, whatever
/// `options.input` says. Memory does not grow with the length of the recording, but for the names
/// in a folder of scans.
///
/// `Frame::index` is the number of the scan in the recording: frames left out leave gaps.
/// @throws ldm::InvalidInput as its readers do; if the format is not recognised; from `next` also
///   on a frame that cannot be used, unless `options.keep_going`.
std::unique_ptr<FrameSource> open_recording(const std::filesystem::path& path,
                                            const RecordingOptions& options);

/// A log of our own, whose files hang together: behind damage nothing can be read. With
/// `keep_going` it ends there, and what is lost is counted.
class UndamagedFrames : public FrameSource {
 public:
  explicit UndamagedFrames(std::unique_ptr<FrameSource> source) : source_(std::move(source)) {}

  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return source_->size(); }
  InputCounts counts() const override { return counts_; }

 private:
  std::unique_ptr<FrameSource> source_;
  std::int64_t read_ = 0;
  bool ended_ = false;
  InputCounts counts_;
};

/// The frames of a reader in order of time: those that cannot be used end the run or, if
/// `keep_going`, are counted. Their world begins at `Frame::origin`: that is 0 along each axis on
/// which the first vehicle is nearer than kNear.
class OrderedFrames : public FrameSource {
 public:
  static constexpr double kNear = 1000;  ///< [m]: floats still tell 0.06 mm there

  OrderedFrames(std::unique_ptr<ScanReader> reader, const RecordingOptions& options);

  bool next(Frame& frame) override;
  std::optional<std::int64_t> size() const override { return reader_->size(); }
  InputCounts counts() const override;

 private:
  bool take_one(Frame& frame, bool& usable);
  void set_origin(Frame& frame);

  std::unique_ptr<ScanReader> reader_;
  bool keep_going_;
  double origin_step_;                     // [m]
  std::optional<Eigen::Vector3d> origin_;  // [m], from the first frame on
  std::optional<double> last_time_;        // [s]
  InputCounts counts_;
};

}  // namespace datasets
