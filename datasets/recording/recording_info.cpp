#include "datasets/recording/recording_info.h"

#include <algorithm>
#include <cstdio>
#include <string>

#include "datasets/recording/formats/pcap/pcap_contents.h"
#include "datasets/recording/formats/ros/bag_contents.h"
#include "datasets/recording/recording.h"

namespace datasets {
namespace {

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[200];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

/// `12 messages, 10.0 Hz`; the rate where there are two at least.
std::string count_text(const char* what, std::int64_t count, double first, double last) {
  std::string text = std::to_string(count) + what;
  if (count < 2 || !(last > first)) return text;
  return text + formatted(", %.1f Hz", static_cast<double>(count - 1) / (last - first));
}

std::string time_text(double first, double last) {
  return formatted("%.3f to %.3f s (%.1f s)", first, last, last - first);
}

void describe_bag(const std::filesystem::path& path, const RecordingOptions& options,
                  std::ostream& out) {
  const BagContents contents = read_contents(path, true);
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const BagContents::Topic& entry : contents.topics) {
    out << "topic   " << entry.topic.name << ": " << entry.topic.type << ", "
        << count_text(" messages", entry.messages, entry.first, entry.last);
    if (!entry.frame.empty()) out << ", in " << entry.frame;
    if (!entry.child.empty()) out << " of " << entry.child;
    out << '\n';
    first = std::min(first, entry.first);
    last = std::max(last, entry.last);
  }
  if (first <= last) out << "times   " << time_text(first, last) << '\n';
  std::string taken;
  try {
    taken = text_of(plan_of(path, contents, options));
  } catch (const ldm::InvalidInput& error) {
    taken = std::string("nothing: ") + error.what();
  }
  out << "taken   " << taken << '\n';
}

void describe_pcap(const std::filesystem::path& path, const RecordingOptions& options,
                   std::ostream& out) {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const PcapStream& stream : read_streams(path)) {
    out << "packets " << stream.text() << ", "
        << count_text("", stream.datagrams, stream.first, stream.last) << '\n';
    first = std::min(first, stream.first);
    last = std::max(last, stream.last);
  }
  if (first <= last) out << "times   " << time_text(first, last) << '\n';
  std::string taken;
  try {
    open_recording(path, options);
    taken = "scans of " + plan_of_pcap(path).scans->name() +
            (options.input.poses == PoseSource::kStill ? ", at rest" : ", poses of a file");
  } catch (const ldm::InvalidInput& error) {
    taken = std::string("nothing: ") + error.what();
  }
  out << "taken   " << taken << '\n';
}

void describe_frames(const std::filesystem::path& path, RecordingOptions options,
                     std::ostream& out) {
  options.keep_going = true;
  const std::unique_ptr<FrameSource> source = open_recording(path, options);
  std::int64_t scans = 0, points = 0;
  double first = 0, last = 0;
  Eigen::Vector3d begin = Eigen::Vector3d::Zero(), end = begin;
  for (Frame frame; source->next(frame); ++scans) {
    last = frame.scan.time;
    end = frame.scan.T_world_sensor.translation + frame.origin;
    if (scans == 0) first = last;
    if (scans == 0) begin = end;
    points += static_cast<std::int64_t>(frame.scan.points.size());
  }
  out << "scans   " << count_text(" that can be used", scans, first, last) << '\n';
  if (scans > 0) {
    out << "times   " << time_text(first, last) << '\n'
        << "points  " << points / scans << " a scan\n"
        << "sensor  "
        << formatted("from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f) m\n", begin.x(), begin.y(),
                     begin.z(), end.x(), end.y(), end.z());
  }
  const InputCounts counts = source->counts();
  for (const std::string& line : counts.losses(scans, points)) out << "lost    " << line << '\n';
  for (const auto& [what, count] : counts.other) out << "other   " << count << " " << what << '\n';
}

}  // namespace

void describe_recording(const std::filesystem::path& path, const RecordingOptions& options,
                        std::ostream& out) {
  const RecordingFormat format = format_of(path, options);
  out << "format  " << kRecordingFormatNames[static_cast<std::size_t>(format)] << '\n';
  if (format == RecordingFormat::kBag) {
    describe_bag(path, options, out);
  } else if (format == RecordingFormat::kPcap) {
    describe_pcap(path, options, out);
  } else {
    describe_frames(path, options, out);
  }
}

}  // namespace datasets
