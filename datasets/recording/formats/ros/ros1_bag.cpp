#include "datasets/recording/formats/ros/ros1_bag.h"

#include <map>

#include "datasets/files/printable.h"
#include "datasets/recording/formats/bytes.h"
#include "datasets/recording/formats/record_file.h"
#include "datasets/recording/formats/ros/decompression.h"
#include "ldm/types.h"

namespace datasets {
namespace {

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
enum Operation : std::uint8_t { kMessage = 2, kBagHeader = 3, kChunk = 5, kConnection = 7 };

/// The fields of a record's header, `name=value` each behind its length.
class Header {
 public:
  explicit Header(std::string_view bytes) {
    for (Bytes rest(bytes); !rest.empty();) {
      const std::string_view field = rest.text();
      const std::size_t equals = field.find('=');
      if (equals == std::string_view::npos) throw ShortBytes();
      fields_[std::string(field.substr(0, equals))] = field.substr(equals + 1);
    }
  }
  std::string_view text(const std::string& name) const {
    const auto found = fields_.find(name);
    return found == fields_.end() ? std::string_view() : found->second;
  }
  template <class Number>
  Number number(const std::string& name) const {
    return Bytes(text(name)).number<Number>();
  }
  std::uint8_t operation() const { return number<std::uint8_t>("op"); }

 private:
  std::map<std::string, std::string_view> fields_;
};

class Ros1Bag : public BagFile {
 public:
  explicit Ros1Bag(const std::filesystem::path& file) : file_(file) {
    std::string magic;
    if (file_.size() < kMagic.size() || file_.read(kMagic.size(), magic) != kMagic) {
      throw ldm::InvalidInput(file.string() + ": no bag of ROS 1: allowed: #ROSBAG V2.0");
    }
  }

  bool next(BagMessage& message) override {
    try {
      for (;;) {
        while (!chunk_.empty()) {
          if (take_record(chunk_, message)) return true;
        }
        if (file_.at_end()) return false;
        if (read_record(message)) return true;
      }
    } catch (const ShortBytes&) {
      chunk_ = Bytes({});
      file_.go_to(file_.size());
      file_.reject("a record that is cut short or damaged");
    }
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::string place() const override { return file_.place(); }

 private:
  /// A record of the file: a chunk becomes `chunk_`. @return true if it is a message
  bool read_record(BagMessage& message) {
    const auto header_size = file_.number<std::uint32_t>();
    const Header header(file_.read(header_size, header_));
    const auto size = file_.number<std::uint32_t>();
    switch (header.operation()) {
      case kChunk: {
        file_.read(size, compressed_);
        const std::string failure = decompress(header.text("compression"), compressed_,
                                               header.number<std::uint32_t>("size"), plain_);
        if (!failure.empty()) file_.reject(failure);
        chunk_ = Bytes(plain_);
        return false;
      }
      case kConnection:
      case kMessage:
        return take(header, file_.read(size, data_), message);
      default:
        file_.skip(size);
        return false;
    }
  }

  /// The same for a record of a chunk.
  bool take_record(Bytes& bytes, BagMessage& message) {
    const Header header(bytes.text());
    return take(header, bytes.text(), message);
  }

  bool take(const Header& header, std::string_view data, BagMessage& message) {
    if (header.operation() == kConnection) add_connection(header, data);
    if (header.operation() != kMessage) return false;
    const auto topic = topic_of_.find(header.number<std::uint32_t>("conn"));
    if (topic == topic_of_.end()) throw ShortBytes();
    Bytes time(header.text("time"));
    const auto seconds = time.number<std::uint32_t>();
    message = {topic->second, seconds + 1e-9 * time.number<std::uint32_t>(), data};
    return true;
  }

  /// One topic may have several: one of each publisher.
  void add_connection(const Header& header, std::string_view data) {
    const BagTopic topic{printable(header.text("topic")), printable(Header(data).text("type")),
                         MessageEncoding::kRos1};
    std::size_t at = 0;
    while (at < topics_.size() && topics_[at].name != topic.name) ++at;
    if (at == topics_.size()) topics_.push_back(topic);
    topic_of_[header.number<std::uint32_t>("conn")] = at;
  }

  RecordFile file_;
  std::string header_, compressed_, plain_, data_;
  Bytes chunk_{{}};  // the rest of plain_
  std::vector<BagTopic> topics_;
  std::map<std::uint32_t, std::size_t> topic_of_;  // by connection
};

}  // namespace

std::unique_ptr<BagFile> open_ros1_bag(const std::filesystem::path& file) {
  return std::make_unique<Ros1Bag>(file);
}

}  // namespace datasets
