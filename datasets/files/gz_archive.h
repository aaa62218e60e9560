#pragma once
/// MRPT's objects in a file compressed by gzip, or plain (no paper section).
#include <mrpt/serialization/CArchive.h>
#include <zlib.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "ldm/types.h"

namespace datasets {

/// Reads MRPT's objects. MRPT's own input stream has no word for a short read and hides a broken
/// checksum; hence zlib's functions.
class GzArchive final : public mrpt::serialization::CArchive {
 public:
  /// @throws ldm::InvalidInput if the file cannot be read.
  explicit GzArchive(const std::filesystem::path& file) : gz_(gzopen(file.c_str(), "rb"), gzclose) {
    if (!gz_ || std::filesystem::is_directory(file)) {
      throw ldm::InvalidInput(file.string() + ": cannot be read");
    }
  }

  enum class Place { kMore, kGoodEnd, kBadEnd };
  /// Whether there is more to read; if not, whether the checksum is right.
  Place place() {
    const int byte = gzgetc(gz_.get());
    if (byte >= 0) {
      gzungetc(byte, gz_.get());
      return Place::kMore;
    }
    int error = Z_OK;
    gzerror(gz_.get(), &error);
    return error == Z_OK ? Place::kGoodEnd : Place::kBadEnd;
  }
  /// The next object, or null where the file ends or is damaged: MRPT's own messages are several
  /// lines about its source files, and it believes any size that it reads.
  mrpt::serialization::CSerializable::Ptr read_object();
  /// Why that was null, in words to follow the place: damage, or a class of a newer MRPT.
  const std::string& failure() const { return failure_; }
  std::string getArchiveDescription() const override { return "recorded log"; }

 private:
  std::size_t read(void* buffer, std::size_t count) override {
    // gzfread, unlike gzread, takes sizes beyond an int.
    if (gzfread(buffer, 1, count, gz_.get()) != count) throw std::runtime_error("short read");
    return count;
  }
  std::size_t write(const void*, std::size_t) override {
    throw std::logic_error("this archive is for reading");
  }

  std::unique_ptr<gzFile_s, int (*)(gzFile)> gz_;
  std::string failure_ = "the log is cut short or damaged";
};

}  // namespace datasets
