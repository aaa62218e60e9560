#include "datasets/recording/formats/ros/mcap_bag.h"

#include <map>

#include "datasets/files/printable.h"
#include "datasets/recording/formats/bytes.h"
#include "datasets/recording/formats/record_file.h"
#include "datasets/recording/formats/ros/decompression.h"
#include "ldm/types.h"

namespace datasets {
namespace {

constexpr std::string_view kMagic = "\x89MCAP0\r\n";
enum Operation : std::uint8_t {
  kSchema = 3,
  kChannel = 4,
  kMessage = 5,
  kChunk = 6,
  kDataEnd = 15
};

class McapBag : public BagFile {
 public:
  explicit McapBag(const std::filesystem::path& file) : file_(file) {
    std::string magic;
    if (file_.size() < kMagic.size() || file_.read(kMagic.size(), magic) != kMagic) {
      throw ldm::InvalidInput(file.string() +
                              ": no MCAP file: allowed: one that begins with MCAP0");
    }
  }

  bool next(BagMessage& message) override {
    try {
      for (;;) {
        while (!chunk_.empty()) {
          const auto operation = chunk_.number<std::uint8_t>();
          const auto size = chunk_.number<std::uint64_t>();
          if (take(operation, Bytes(chunk_.take(size)), message)) return true;
        }
        if (ended_ || file_.at_end()) return false;
        const auto operation = file_.number<std::uint8_t>();
        const auto size = file_.number<std::uint64_t>();
        if (operation == kChunk) {
          open_chunk(Bytes(file_.read(size, data_)));
        } else if (operation == kDataEnd) {
          ended_ = true;  // the rest is a summary
        } else if (operation == kSchema || operation == kChannel || operation == kMessage) {
          if (take(operation, Bytes(file_.read(size, data_)), message)) return true;
        } else {
          file_.skip(size);
        }
      }
    } catch (const ShortBytes&) {
      chunk_ = Bytes({});
      ended_ = true;
      file_.reject("a record that is cut short or damaged");
    }
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::string place() const override { return file_.place(); }

 private:
  struct Channel {
    std::size_t topic = 0;
    bool readable = false;  // its messages are of ROS
  };

  void open_chunk(Bytes content) {
    content.take(2 * sizeof(std::uint64_t));  // first and last time
    const auto size = content.number<std::uint64_t>();
    content.take(sizeof(std::uint32_t));  // checksum
    const std::string_view compression = content.text();
    const std::string_view records = content.take(content.number<std::uint64_t>());
    const std::string failure = decompress(compression, records, size, plain_);
    if (!failure.empty()) file_.reject(failure);
    chunk_ = Bytes(plain_);
  }

  bool take(std::uint8_t operation, Bytes content, BagMessage& message) {
    if (operation == kSchema) {
      const auto id = content.number<std::uint16_t>();
      type_of_[id] = type_without_msg(printable(content.text()));
    } else if (operation == kChannel) {
      add_channel(content);
    } else if (operation == kMessage) {
      const auto channel = channels_.find(content.number<std::uint16_t>());
      if (channel == channels_.end()) throw ShortBytes();
      content.take(sizeof(std::uint32_t));  // number
      const double time = 1e-9 * static_cast<double>(content.number<std::uint64_t>());
      content.take(sizeof(std::uint64_t));  // time of publication
      message = {channel->second.topic, time, content.take(content.size())};
      return channel->second.readable;
    }
    return false;
  }

  void add_channel(Bytes content) {
    const auto id = content.number<std::uint16_t>();
    const auto schema = content.number<std::uint16_t>();
    BagTopic topic{printable(content.text()), type_of_[schema], MessageEncoding::kCdr};
    const std::string_view encoding = content.text();
    if (encoding == "ros1") topic.encoding = MessageEncoding::kRos1;
    std::size_t at = 0;
    while (at < topics_.size() && topics_[at].name != topic.name) ++at;
    if (at == topics_.size()) topics_.push_back(topic);
    channels_[id] = {at, encoding == "cdr" || encoding == "ros1"};
  }

  RecordFile file_;
  bool ended_ = false;
  std::string data_, plain_;
  Bytes chunk_{{}};  // the rest of plain_
  std::vector<BagTopic> topics_;
  std::map<std::uint16_t, std::string> type_of_;  // by schema
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace

std::unique_ptr<BagFile> open_mcap_bag(const std::filesystem::path& file) {
  return std::make_unique<McapBag>(file);
}

}  // namespace datasets
