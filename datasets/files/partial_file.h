#pragma once
/// A file that exists under its name only when it is complete (no paper section).
#include <filesystem>
#include <fstream>

namespace datasets {

/// Writes to a hidden temporary name beside the final one; without `commit` nothing is left.
class PartialFile {
 public:
  /// @throws ldm::InvalidInput if the folder cannot be written.
  explicit PartialFile(std::filesystem::path final_name);
  ~PartialFile();
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// For a library that opens files itself, in place of the stream.
  const std::filesystem::path& temporary_name() const { return temporary_name_; }
  /// Give the file its final name, in place of an older one.
  /// @throws std::runtime_error if something could not be written.
  void commit();

 private:
  std::filesystem::path final_name_, temporary_name_;
  std::ofstream stream_;
};

/// Make a folder, and those above it, unless they exist.
/// @throws ldm::InvalidInput if it cannot be made.
void make_folder(const std::filesystem::path& folder);

}  // namespace datasets
