#pragma once
/// Scans in messages of ROS: sensor_msgs/PointCloud2 and Livox's CustomMsg (no paper section).
#include <optional>
#include <string>
#include <vector>

#include "datasets/recording/formats/ros/message_fields.h"
#include "ldm/types.h"

namespace datasets {

struct CloudMessage {
  MessageHeader header;
  std::vector<ldm::Point> points;  ///< sensor frame; of pixels without a return not finite [m]
  /// When each point was measured, after the header's stamp [s]; empty if the points do not say.
  std::vector<float> delays;
};

/// True for the types that `read_cloud` takes.
bool is_cloud(const std::string& type);

/// Fields x, y, z of 32 or 64 bits in any layout. Times of points are those of a field t, time,
/// timestamp, offset_time or time_offset: after the stamp or of the same clock, in s, ms, us or ns,
/// of which a sweep of 2 ms to 2 s tells.
/// @param with_delays whether they are of interest
/// @return an empty text, or what is wrong
/// @throws ShortBytes if the message ends too early.
std::string read_cloud(const BagTopic& topic, std::string_view bytes, bool with_delays,
                       CloudMessage& cloud);

/// Seconds of a point's time, by the length of a sweep [in that unit].
std::optional<double> unit_of_sweep(double length);

}  // namespace datasets
