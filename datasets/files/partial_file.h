#pragma once
/// A file that exists under its name only when it is complete (no paper section).
#include <filesystem>
#include <fstream>
#include <initializer_list>

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
  /// For the outcome of such a library. @throws std::runtime_error naming the final name if false.
  void require(bool written) const;
  /// Close the stream. @throws std::runtime_error if something could not be written.
  void complete();
  /// Complete it, and give it its final name, in place of an older one.
  /// @throws std::runtime_error if that fails.
  void commit();

 private:
  std::filesystem::path final_name_, temporary_name_;
  std::ofstream stream_;
};

/// As `commit`, but no file is given its name before all are complete.
void commit_together(std::initializer_list<PartialFile*> files);

/// Make a folder, and those above it, unless they exist.
/// @throws ldm::InvalidInput if it cannot be made.
void make_folder(const std::filesystem::path& folder);

}  // namespace datasets
