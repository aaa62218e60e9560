#pragma once
/// Bags of ROS as a sequence of messages (no paper section; docs/recordings.md).
#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace datasets {

/// How the fields of a message lie in its bytes.
enum class MessageEncoding { kRos1, kCdr };

struct BagTopic {
  std::string name;
  std::string type;  ///< without the `msg/` of ROS 2: sensor_msgs/PointCloud2
  MessageEncoding encoding = MessageEncoding::kCdr;
};

struct BagMessage {
  std::size_t topic = 0;   ///< its place in `topics`
  double time = 0;         ///< when it was recorded [s]
  std::string_view bytes;  ///< until the next message is read
};

/// Reads a bag from its beginning, message by message, as they lie in it; an index is not needed.
class BagFile {
 public:
  virtual ~BagFile() = default;
  /// False at the end.
  /// @throws BrokenFrame naming file and place where it is damaged: the bag then ends.
  virtual bool next(BagMessage& message) = 0;
  /// Those that were met until now, or all where the file begins with them.
  virtual const std::vector<BagTopic>& topics() const = 0;
  /// Where the last message stands, for messages.
  virtual std::string place() const = 0;
};

/// True for *.bag, *.mcap and *.db3, and for a folder that has such files.
bool is_bag(const std::filesystem::path& path);

/// A bag of ROS 1 or 2, or a folder with the files of a split one, which are read one after the
/// other in the natural order of their names.
/// @throws ldm::InvalidInput if it cannot be read or is none.
std::unique_ptr<BagFile> open_bag(const std::filesystem::path& path);

/// `sensor_msgs/msg/PointCloud2` of ROS 2 as ROS 1 writes it.
std::string type_without_msg(std::string type);

}  // namespace datasets
