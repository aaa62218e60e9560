#pragma once
/// A film from pictures, through Debian's ffmpeg (no paper section).
#include <sys/types.h>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "datasets/files/partial_file.h"

namespace experiments {

/// @throws ldm::InvalidInput naming the option unless the file's name ends so
void check_ending(const char* option, const std::filesystem::path& file, const char* ending);

/// Encodes H.264, which browsers play, while pictures come.
class VideoFile {
 public:
  /// @param rate pictures a second
  /// @throws ldm::InvalidInput if there is no ffmpeg, or the file cannot be written.
  VideoFile(const std::filesystem::path& file, int width, int height, double rate);
  /// Without `finish`, nothing is left.
  ~VideoFile();
  VideoFile(const VideoFile&) = delete;
  VideoFile& operator=(const VideoFile&) = delete;

  /// @param rgb rows from the top, of width times red, green, blue
  /// @throws std::runtime_error if ffmpeg has ended.
  void add(std::span<const std::uint8_t> rgb);
  /// @throws std::runtime_error if ffmpeg failed.
  void finish();

 private:
  bool ended_well();
  /// Throws with what ffmpeg said.
  [[noreturn]] void fail();

  std::string name_;
  datasets::PartialFile file_;
  int errors_ = -1;  // a file in memory
  int to_ffmpeg_ = -1;
  pid_t ffmpeg_ = -1;
};

}  // namespace experiments
