#include "datasets/files/partial_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include "ldm/types.h"

namespace datasets {
namespace {

/// Hidden, and with the process id: two runs may write the same file. The ending stays: it tells
/// some libraries what to write.
std::filesystem::path hidden_name(const std::filesystem::path& final_name) {
  std::string name(1, '.');
  name.append(final_name.stem().string()).append(".").append(std::to_string(getpid()));
  return final_name.parent_path() / name.append(".part").append(final_name.extension().string());
}

}  // namespace

PartialFile::PartialFile(std::filesystem::path final_name)
    : final_name_(std::move(final_name)), temporary_name_(hidden_name(final_name_)) {
  if (std::filesystem::is_directory(final_name_)) {
    throw ldm::InvalidInput(final_name_.string() + ": is a folder: allowed: the name of a file");
  }
  errno = 0;
  stream_.open(temporary_name_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw ldm::InvalidInput(final_name_.string() + ": cannot be written (" + std::strerror(errno) +
                            "): allowed: a file in an existing folder");
  }
}

PartialFile::~PartialFile() {
  std::error_code ignored;  // a stray temporary file does no harm
  stream_.close();
  if (!temporary_name_.empty()) std::filesystem::remove(temporary_name_, ignored);
}

void PartialFile::require(bool written) const {
  if (!written) throw std::runtime_error(final_name_.string() + ": cannot be written: disk full?");
}

void PartialFile::complete() {
  if (stream_.is_open()) stream_.close();
  require(!stream_.fail());
}

void PartialFile::commit() {
  complete();
  std::error_code error;
  std::filesystem::rename(temporary_name_, final_name_, error);
  if (error) {
    throw std::runtime_error(final_name_.string() + ": cannot be written (" + error.message() +
                             ")");
  }
  temporary_name_.clear();
}

void commit_together(std::initializer_list<PartialFile*> files) {
  for (PartialFile* file : files) file->complete();
  for (PartialFile* file : files) file->commit();
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder)) {
    throw ldm::InvalidInput(folder.string() + ": cannot be made (" + error.message() +
                            "): allowed: a folder that can be written");
  }
}

}  // namespace datasets
