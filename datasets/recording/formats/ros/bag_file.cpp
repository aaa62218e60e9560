#include "datasets/recording/formats/ros/bag_file.h"

#include <algorithm>
#include <array>

#include "datasets/recording/formats/ros/mcap_bag.h"
#include "datasets/recording/formats/ros/ros1_bag.h"
#include "datasets/recording/formats/ros/sqlite_bag.h"
#include "datasets/recording/scans/scan_names.h"
#include "ldm/types.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

struct Container {
  std::string_view ending;
  std::unique_ptr<BagFile> (*open)(const fs::path&);
};
constexpr std::array kContainers = {Container{".bag", open_ros1_bag},
                                    Container{".mcap", open_mcap_bag},
                                    Container{".db3", open_sqlite_bag}};

const Container* container_of(const fs::path& file) {
  const auto* const found =
      std::find_if(kContainers.begin(), kContainers.end(),
                   [&](const Container& c) { return is_scan_name(file, c.ending); });
  return found == kContainers.end() ? nullptr : found;
}

std::vector<std::string> bags_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (container_of(entry.path()) != nullptr) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end(),
            [](const auto& a, const auto& b) { return natural_less(a, b); });
  return names;
}

std::unique_ptr<BagFile> open_one(const fs::path& file) {
  const Container* const container = container_of(file);
  if (container != nullptr) return container->open(file);
  throw ldm::InvalidInput(file.string() +
                          ": no bag: allowed: *.bag, *.mcap, *.db3, or their folder");
}

/// The files of a split bag. Topics of one name are the same.
class SplitBag : public BagFile {
 public:
  explicit SplitBag(std::vector<fs::path> files) : files_(std::move(files)) { open_next(); }

  bool next(BagMessage& message) override {
    while (!bag_->next(message)) {
      if (opened_ == files_.size()) return false;
      open_next();
    }
    const BagTopic& topic = bag_->topics()[message.topic];
    message.topic = 0;
    while (message.topic < topics_.size() && topics_[message.topic].name != topic.name) {
      ++message.topic;
    }
    if (message.topic == topics_.size()) topics_.push_back(topic);
    return true;
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::string place() const override { return bag_->place(); }

 private:
  void open_next() { bag_ = open_one(files_[opened_++]); }

  std::vector<fs::path> files_;
  std::size_t opened_ = 0;
  std::unique_ptr<BagFile> bag_;
  std::vector<BagTopic> topics_;
};

}  // namespace

bool is_bag(const fs::path& path) {
  return fs::is_directory(path) ? !bags_in(path).empty() : container_of(path) != nullptr;
}

std::unique_ptr<BagFile> open_bag(const fs::path& path) {
  if (!fs::is_directory(path)) return open_one(path);
  std::vector<fs::path> files;
  for (const std::string& name : bags_in(path)) files.push_back(path / name);
  if (files.empty()) {
    throw ldm::InvalidInput(path.string() + ": has no bags: allowed: *.bag, *.mcap, *.db3");
  }
  return std::make_unique<SplitBag>(std::move(files));
}

std::string type_without_msg(std::string type) {
  const std::size_t at = type.find("/msg/");
  if (at != std::string::npos) type.erase(at, 4);
  return type;
}

}  // namespace datasets
