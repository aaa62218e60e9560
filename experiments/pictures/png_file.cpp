#include "experiments/pictures/png_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>

namespace experiments {
namespace {

/// While it lives, nothing reaches standard error: the library has its own words for a full disk.
class QuietStandardError {
 public:
  QuietStandardError() : before_(dup(STDERR_FILENO)) {
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDERR_FILENO);
    close(nowhere);
  }
  ~QuietStandardError() {
    dup2(before_, STDERR_FILENO);
    close(before_);
  }
  QuietStandardError(const QuietStandardError&) = delete;
  QuietStandardError& operator=(const QuietStandardError&) = delete;

 private:
  int before_;
};

/// It ends as a PNG does. The library does not tell of a disk that was full in the end.
bool is_whole(const std::filesystem::path& name) {
  std::ifstream stream(name, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return bytes.ends_with("IEND\xae\x42\x60\x82");
}

}  // namespace

void save_png(const mrpt::img::CImage& image, datasets::PartialFile& file) {
  const std::filesystem::path& name = file.temporary_name();
  const QuietStandardError quiet;
  file.require(image.saveToFile(name.string()) && is_whole(name));
}

}  // namespace experiments
