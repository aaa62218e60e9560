#include "datasets/recording/formats/ros/sqlite_bag.h"

#include <sqlite3.h>

#include <map>

#include "datasets/files/printable.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/number_lines.h"

namespace datasets {
namespace {

using Database = std::unique_ptr<sqlite3, int (*)(sqlite3*)>;
using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt*)>;

std::string text_in(sqlite3_stmt* row, int column) {
  const auto* text = sqlite3_column_text(row, column);
  return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
}

class SqliteBag : public BagFile {
 public:
  explicit SqliteBag(const std::filesystem::path& file) : name_(file.string()) {
    open_file(file);  // which says why, if it cannot be read
    std::error_code none;
    if (std::filesystem::file_size(name_ + "-wal", none) > 0 && !none) {
      throw ldm::InvalidInput(name_ +
                              "-wal: the bag was not closed, its last messages are in this "
                              "file: allowed: sqlite3 " +
                              name_ + " 'PRAGMA wal_checkpoint'");
    }
    sqlite3* raw = nullptr;
    // Without locks and journals: a bag on a read-only disk is read as well.
    const int error = sqlite3_open_v2(("file:" + uri_of(file) + "?immutable=1").c_str(), &raw,
                                      SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
    database_.reset(raw);
    if (error != SQLITE_OK) reject_file();
    read_topics();
    messages_ = prepare("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp");
  }

  bool next(BagMessage& message) override {
    for (;;) {
      const int state = ended_ ? SQLITE_DONE : sqlite3_step(messages_.get());
      ended_ = state != SQLITE_ROW;
      if (state == SQLITE_DONE) return false;
      ++row_;
      const auto topic = topic_of_.find(ended_ ? 0 : sqlite3_column_int64(messages_.get(), 0));
      if (topic == topic_of_.end()) {
        ended_ = true;
        throw BrokenFrame("broken log", place() + ": the bag is damaged");
      }
      const void* const data = sqlite3_column_blob(messages_.get(), 2);
      const int size = sqlite3_column_bytes(messages_.get(), 2);
      if (data == nullptr || !readable_[topic->second]) continue;
      message = {topic->second,
                 1e-9 * static_cast<double>(sqlite3_column_int64(messages_.get(), 1)),
                 {static_cast<const char*>(data), static_cast<std::size_t>(size)}};
      return true;
    }
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }
  std::string place() const override { return name_ + ": message " + std::to_string(row_); }

 private:
  /// Characters with a meaning in a URI as %41.
  static std::string uri_of(const std::filesystem::path& file) {
    std::string uri;
    for (const char c : std::filesystem::absolute(file).string()) {
      char code[4] = {c};
      if (c == '%' || c == '?' || c == '#') {
        std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
      }
      uri += code;
    }
    return uri;
  }

  Statement prepare(const char* query) const {
    sqlite3_stmt* raw = nullptr;
    if (sqlite3_prepare_v2(database_.get(), query, -1, &raw, nullptr) != SQLITE_OK) reject_file();
    return {raw, sqlite3_finalize};
  }

  void read_topics() {
    const Statement query = prepare("SELECT id, name, type, serialization_format FROM topics");
    while (sqlite3_step(query.get()) == SQLITE_ROW) {
      topic_of_[sqlite3_column_int64(query.get(), 0)] = topics_.size();
      topics_.push_back({printable(text_in(query.get(), 1)),
                         type_without_msg(printable(text_in(query.get(), 2))),
                         MessageEncoding::kCdr});
      readable_.push_back(text_in(query.get(), 3) == "cdr");
    }
  }

  [[noreturn]] void reject_file() const {
    throw ldm::InvalidInput(name_ +
                            ": no bag of ROS 2: allowed: a SQLite file with the tables "
                            "topics and messages");
  }

  std::string name_;
  Database database_{nullptr, sqlite3_close_v2};
  Statement messages_{nullptr, sqlite3_finalize};
  std::vector<BagTopic> topics_;
  std::vector<bool> readable_;                    // its messages are in CDR
  std::map<std::int64_t, std::size_t> topic_of_;  // by id
  std::int64_t row_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<BagFile> open_sqlite_bag(const std::filesystem::path& file) {
  return std::make_unique<SqliteBag>(file);
}

}  // namespace datasets
