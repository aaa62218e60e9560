#pragma once
/// Small bags of ROS 1 and 2 for tests: messages and their containers.
#include <bzlib.h>
#include <lz4frame.h>
#include <sqlite3.h>
#include <zstd.h>

#include <Eigen/Geometry>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "datasets/recording/formats/ros/bag_file.h"
#include "ldm/types.h"

namespace datasets {

/// The fields of a message in one of the two encodings.
class MessageWriter {
 public:
  explicit MessageWriter(MessageEncoding encoding) : cdr_(encoding == MessageEncoding::kCdr) {
    if (cdr_) bytes_.assign("\0\1\0\0", 4);
  }
  template <class Number>
  MessageWriter& add(Number value) {
    while (cdr_ && (bytes_.size() - 4) % sizeof value != 0) bytes_ += '\0';
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    return *this;
  }
  MessageWriter& text(const std::string& text) {
    add(static_cast<std::uint32_t>(text.size() + (cdr_ ? 1 : 0)));
    bytes_ += text;
    if (cdr_) bytes_ += '\0';
    return *this;
  }
  MessageWriter& bytes(const std::string& bytes) {
    add(static_cast<std::uint32_t>(bytes.size()));
    bytes_ += bytes;
    return *this;
  }
  MessageWriter& header(double stamp, const std::string& frame) {
    if (!cdr_) add(std::uint32_t{7});
    const auto seconds = static_cast<std::uint32_t>(stamp);
    add(seconds).add(static_cast<std::uint32_t>((stamp - seconds) * 1e9 + 0.5));
    return text(frame);
  }
  MessageWriter& pose(const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
    for (const double number : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()}) add(number);
    return *this;
  }
  const std::string& str() const { return bytes_; }

 private:
  bool cdr_;
  std::string bytes_;
};

struct TestMessage {
  BagTopic topic;
  double time = 0;
  std::string bytes;
};

/// One point of a test cloud, with its time in the unit of the field.
struct TestPoint {
  double x = 0, y = 0, z = 0, time = 0;
};

/// The layout of a PointCloud2: type of x, y, z and of the time (0: none), padding, rows.
struct CloudLayout {
  std::uint8_t coordinate = 7;
  std::string time_name = "t";
  std::uint8_t time = 0;
  std::uint32_t height = 1;
  std::size_t row_padding = 0;
};

inline void append_number(std::string& bytes, std::uint8_t type, double value) {
  const auto append = [&bytes](auto number) {
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  if (type == 6) append(static_cast<std::uint32_t>(value));
  if (type == 7) append(static_cast<float>(value));
  if (type == 8) append(value);
}

inline std::string cloud_bytes(MessageEncoding encoding, double stamp, const std::string& frame,
                               const std::vector<TestPoint>& points,
                               const CloudLayout& layout = {}) {
  const std::uint32_t width = static_cast<std::uint32_t>(points.size()) / layout.height;
  const std::uint32_t size = layout.coordinate == 8 ? 8 : 4;
  MessageWriter message(encoding);
  message.header(stamp, frame).add(layout.height).add(width);
  message.add(std::uint32_t{layout.time == 0 ? 4U : 5U});
  std::uint32_t offset = 4;  // the ring stands in front
  const auto field = [&](const std::string& name, std::uint32_t at, std::uint8_t type) {
    message.text(name).add(at).add(type).add(std::uint32_t{1});
  };
  field("ring", 0, 4);
  for (const char* name : {"x", "y", "z"}) {
    field(name, offset, layout.coordinate);
    offset += size;
  }
  if (layout.time != 0) field(layout.time_name, offset, layout.time);
  const std::uint32_t step = offset + (layout.time == 0 ? 0 : layout.time == 8 ? 8 : 4) + 3;
  message.add(std::uint8_t{0}).add(step);
  message.add(static_cast<std::uint32_t>(width * step + layout.row_padding));
  std::string data;
  for (std::size_t i = 0; i < points.size(); ++i) {
    data.append("\1\0\0\0", 4);
    for (const double c : {points[i].x, points[i].y, points[i].z}) {
      append_number(data, layout.coordinate, c);
    }
    append_number(data, layout.time, points[i].time);
    data.append(3, 'p');
    if ((i + 1) % width == 0) data.append(layout.row_padding, 'r');
  }
  return message.bytes(data).add(std::uint8_t{1}).str();
}

inline std::string livox_bytes(MessageEncoding encoding, double stamp, const std::string& frame,
                               const std::vector<TestPoint>& points) {
  MessageWriter message(encoding);
  const auto count = static_cast<std::uint32_t>(points.size());
  message.header(stamp, frame).add(std::uint64_t{5}).add(count);
  for (int i = 0; i < 4; ++i) message.add(std::uint8_t{0});
  message.add(count);
  for (const TestPoint& p : points) {
    message.add(static_cast<std::uint32_t>(p.time));
    for (const double c : {p.x, p.y, p.z}) message.add(static_cast<float>(c));
    for (int i = 0; i < 3; ++i) message.add(std::uint8_t{1});
  }
  return message.str();
}

struct TestTransform {
  double stamp = 0;
  std::string parent, child;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

inline std::string tf_bytes(MessageEncoding encoding,
                            const std::vector<TestTransform>& transforms) {
  MessageWriter message(encoding);
  message.add(static_cast<std::uint32_t>(transforms.size()));
  for (const TestTransform& t : transforms) {
    message.header(t.stamp, t.parent).text(t.child).pose(t.translation, t.rotation);
  }
  return message.str();
}

inline std::string odometry_bytes(MessageEncoding encoding, const TestTransform& t) {
  MessageWriter message(encoding);
  message.header(t.stamp, t.parent).text(t.child).pose(t.translation, t.rotation);
  for (int i = 0; i < 36 + 6 + 36; ++i) message.add(0.0);
  return message.str();
}

inline std::string pose_bytes(MessageEncoding encoding, const TestTransform& t) {
  return MessageWriter(encoding).header(t.stamp, t.parent).pose(t.translation, t.rotation).str();
}

/// lz4 frame, zstd, bz2 or as it is.
inline std::string compressed(const std::string& name, const std::string& plain) {
  std::string bytes(plain.size() + 4096, '\0');
  if (name == "lz4") {
    bytes.resize(
        LZ4F_compressFrame(bytes.data(), bytes.size(), plain.data(), plain.size(), nullptr));
  } else if (name == "zstd") {
    bytes.resize(ZSTD_compress(bytes.data(), bytes.size(), plain.data(), plain.size(), 1));
  } else if (name == "bz2") {
    auto size = static_cast<unsigned>(bytes.size());
    std::string source = plain;
    BZ2_bzBuffToBuffCompress(bytes.data(), &size, source.data(),
                             static_cast<unsigned>(source.size()), 1, 0, 0);
    bytes.resize(size);
  } else {
    return plain;
  }
  return bytes;
}

template <class Number>
void append(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class Length>
void append_text(std::string& bytes, const std::string& text) {
  append(bytes, static_cast<Length>(text.size()));
  bytes += text;
}
template <class Number>
std::string number_bytes(Number value) {
  std::string bytes;
  append(bytes, value);
  return bytes;
}

/// A bag of ROS 1 without an index; `compression` none, lz4 or bz2, a chunk for `chunk` messages.
inline std::string ros1_bag(const std::vector<TestMessage>& messages,
                            const std::string& compression = "none", std::size_t chunk = 3) {
  using Fields = std::vector<std::pair<std::string, std::string>>;
  const auto header = [](const Fields& fields) {
    std::string bytes;
    for (const auto& [name, value] : fields) append_text<std::uint32_t>(bytes, name + "=" + value);
    return bytes;
  };
  const auto record = [&](const Fields& fields, const std::string& data) {
    std::string bytes;
    append_text<std::uint32_t>(bytes, header(fields));
    append_text<std::uint32_t>(bytes, data);
    return bytes;
  };
  std::string bag = "#ROSBAG V2.0\n";
  bag +=
      record({{"op", "\3"}, {"index_pos", number_bytes(std::uint64_t{0})}}, std::string(64, ' '));
  std::vector<std::string> names;
  std::string content;
  const auto finish_chunk = [&] {
    bag += record({{"op", "\5"},
                   {"compression", compression},
                   {"size", number_bytes(static_cast<std::uint32_t>(content.size()))}},
                  compressed(compression, content));
    bag += record({{"op", "\4"}}, "an index");
    content.clear();
  };
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const TestMessage& m = messages[i];
    std::uint32_t id = 0;
    while (id < names.size() && names[id] != m.topic.name) ++id;
    if (id == names.size()) {
      names.push_back(m.topic.name);
      content += record({{"op", "\7"}, {"conn", number_bytes(id)}, {"topic", m.topic.name}},
                        header({{"topic", m.topic.name}, {"type", m.topic.type}}));
    }
    const auto seconds = static_cast<std::uint32_t>(m.time);
    const auto rest = static_cast<std::uint32_t>((m.time - seconds) * 1e9 + 0.5);
    content += record({{"op", "\2"},
                       {"conn", number_bytes(id)},
                       {"time", number_bytes(seconds) + number_bytes(rest)}},
                      m.bytes);
    if ((i + 1) % chunk == 0) finish_chunk();
  }
  if (!content.empty()) finish_chunk();
  return bag;
}

/// An MCAP file without a summary: in chunks of that compression, or ("-") without chunks.
inline std::string mcap_bag(const std::vector<TestMessage>& messages,
                            const std::string& compression, std::size_t chunk = 3) {
  const auto record = [](std::uint8_t operation, const std::string& data) {
    std::string bytes(1, static_cast<char>(operation));
    append_text<std::uint64_t>(bytes, data);
    return bytes;
  };
  std::string bag = "\x89MCAP0\r\n", content;
  std::string library;
  append_text<std::uint32_t>(library, "ros2");
  append_text<std::uint32_t>(library, "test");
  bag += record(1, library);
  const auto finish_chunk = [&] {
    if (compression == "-") {
      bag += content;
    } else {
      std::string data(16, '\0');
      append(data, static_cast<std::uint64_t>(content.size()));
      append(data, std::uint32_t{0});
      append_text<std::uint32_t>(data, compression);
      append_text<std::uint64_t>(data, compressed(compression, content));
      bag += record(6, data) + record(7, "an index");
    }
    content.clear();
  };
  std::vector<std::string> names;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    const TestMessage& m = messages[i];
    std::uint16_t id = 0;
    while (id < names.size() && names[id] != m.topic.name) ++id;
    if (id == names.size()) {
      names.push_back(m.topic.name);
      std::string schema = number_bytes(static_cast<std::uint16_t>(id + 1)),
                  channel = number_bytes(id);
      const std::size_t slash = m.topic.type.find('/');
      append_text<std::uint32_t>(
          schema, m.topic.type.substr(0, slash) + "/msg" + m.topic.type.substr(slash));
      append_text<std::uint32_t>(schema, "ros2msg");
      append_text<std::uint32_t>(schema, "uint8 field");
      append(channel, static_cast<std::uint16_t>(id + 1));
      append_text<std::uint32_t>(channel, m.topic.name);
      append_text<std::uint32_t>(channel, "cdr");
      append(channel, std::uint32_t{0});
      content += record(3, schema) + record(4, channel);
    }
    std::string data = number_bytes(id) + number_bytes(std::uint32_t{0});
    append(data, static_cast<std::uint64_t>(m.time * 1e9));
    append(data, static_cast<std::uint64_t>(m.time * 1e9));
    content += record(5, data + m.bytes);
    if ((i + 1) % chunk == 0) finish_chunk();
  }
  if (!content.empty()) finish_chunk();
  return bag + record(15, std::string(4, '\0')) + record(2, std::string(20, '\0')) +
         "\x89MCAP0\r\n";
}

/// A bag of ROS 2 in SQLite.
inline void write_sqlite_bag(const std::filesystem::path& file,
                             const std::vector<TestMessage>& messages) {
  std::filesystem::remove(file);
  sqlite3* database = nullptr;
  sqlite3_open(file.c_str(), &database);
  const auto run = [&](const std::string& query) {
    sqlite3_exec(database, query.c_str(), nullptr, nullptr, nullptr);
  };
  run("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format "
      "TEXT)");
  run("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data "
      "BLOB)");
  std::vector<std::string> names;
  for (const TestMessage& m : messages) {
    std::size_t id = 0;
    while (id < names.size() && names[id] != m.topic.name) ++id;
    if (id == names.size()) {
      names.push_back(m.topic.name);
      std::string type = m.topic.type;
      type.insert(type.find('/'), "/msg");
      run("INSERT INTO topics VALUES(" + std::to_string(id + 1) + ",'" + m.topic.name + "','" +
          type + "','cdr')");
    }
    sqlite3_stmt* insert = nullptr;
    sqlite3_prepare_v2(database, "INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)", -1,
                       &insert, nullptr);
    sqlite3_bind_int64(insert, 1, static_cast<std::int64_t>(id + 1));
    sqlite3_bind_int64(insert, 2, static_cast<std::int64_t>(m.time * 1e9));
    sqlite3_bind_blob(insert, 3, m.bytes.data(), static_cast<int>(m.bytes.size()), SQLITE_STATIC);
    sqlite3_step(insert);
    sqlite3_finalize(insert);
  }
  sqlite3_close(database);
}

}  // namespace datasets
