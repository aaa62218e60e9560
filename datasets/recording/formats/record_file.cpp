#include "datasets/recording/formats/record_file.h"

#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/number_lines.h"

namespace datasets {

RecordFile::RecordFile(const std::filesystem::path& file)
    : name_(file.string()), stream_(file, std::ios::binary) {
  if (!stream_ || std::filesystem::is_directory(file)) open_file(file);  // which says why
  size_ = std::filesystem::file_size(file);
}

std::string_view RecordFile::read(std::uint64_t count, std::string& buffer) {
  require(count);
  buffer.resize(static_cast<std::size_t>(count));
  read_into(buffer.data(), count);
  return buffer;
}

void RecordFile::read_into(char* to, std::uint64_t count) {
  require(count);
  stream_.read(to, static_cast<std::streamsize>(count));
  if (!stream_) reject("it cannot be read");
  position_ += count;
}

void RecordFile::skip(std::uint64_t count) {
  require(count);
  go_to(position_ + count);
}

void RecordFile::go_to(std::uint64_t position) {
  position_ = position;
  stream_.seekg(static_cast<std::streamoff>(position));
}

void RecordFile::require(std::uint64_t count) const {
  if (count > size_ - position_) reject("the file is cut short or damaged");
}

std::string RecordFile::place() const {
  return name_ + ": byte " + std::to_string(position_);
}

void RecordFile::reject(const std::string& message) const {
  throw BrokenFrame("broken log", place() + ": " + message);
}

}  // namespace datasets
