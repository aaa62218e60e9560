#include "tests/fuzz/targets.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "datasets/recording/formats/pcd_file.h"
#include "datasets/recording/recording.h"
#include "datasets/recording/scans/number_lines.h"
#include "datasets/recording/scans/trajectory.h"
#include "ldm/scan_check.h"

namespace fuzz {
namespace {

namespace fs = std::filesystem;

/// A folder of this process, in memory where that is possible.
class Folder {
 public:
  Folder() {
    const fs::path memory = "/dev/shm";
    path_ = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
            ("ldm_fuzz_" + std::to_string(getpid()));
    fs::create_directories(path_ / "velodyne");
  }
  ~Folder() {
    std::error_code ignored;  // a stray folder does no harm
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

const fs::path& folder() {
  static const Folder folder;
  return folder.path();
}

fs::path write(const std::string& name, const std::string& bytes) {
  const fs::path file = folder() / name;
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  return file;
}

/// Refusing is right, if it is done in one line.
template <class Read>
void refused_or_done(Read&& read) {
  try {
    read();
  } catch (const ldm::InvalidInput& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) {
      throw std::logic_error(error.what());
    }
  } catch (const std::exception& error) {
    throw std::logic_error(std::string("not InvalidInput: ") + error.what());
  }
}

/// All frames, without and with --keep-going; each is fit for a mapper.
void read_recording(const fs::path& path, datasets::RecordingOptions options) {
  for (const bool keep_going : {false, true}) {
    refused_or_done([&] {
      options.keep_going = keep_going;
      const auto source = datasets::open_recording(path, options);
      datasets::Frame frame;
      std::optional<double> last;
      while (source->next(frame)) {
        try {
          ldm::check_scan(frame.scan, last);
        } catch (const ldm::InvalidInput& error) {
          throw std::logic_error(error.what());
        }
        last = frame.scan.time;
      }
    });
  }
}

}  // namespace

void pcd(const std::string& bytes) {
  refused_or_done([&] {
    std::vector<ldm::Point> points;
    datasets::parse_pcd(bytes, "fuzz.pcd", points);
  });
}

void trajectory(const std::string& bytes) {
  refused_or_done([&] {
    datasets::PoseTrack track;
    datasets::TrajectoryFile file(
        datasets::NumberLines(std::make_unique<std::istringstream>(bytes), "fuzz.tum"));
    while (file.advance()) {
      const datasets::StampedPose pose = file.pose();
      if (track.add(pose)) track.at(pose.time - 0.05, 1);
    }
  });
}

void kitti(const std::string& bytes) {
  constexpr std::string_view kBetween = "---\n";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t end = std::min(bytes.find(kBetween, begin), bytes.size());
    parts.push_back(bytes.substr(begin, end - begin));
    begin = std::min(end + kBetween.size(), bytes.size());
  }
  write("times.txt", parts[0]);
  write("poses.txt", parts[1]);
  if (parts[2].empty()) {
    fs::remove(folder() / "calib.txt");
  } else {
    write("calib.txt", parts[2]);
  }
  write("velodyne/000000.bin", bytes.substr(begin));
  write("velodyne/000001.bin", bytes.substr(begin));
  datasets::RecordingOptions options;
  options.input.ground.removal = datasets::GroundRemoval::kGrid;
  options.input.ground.cell = 8;  // few cells: many inputs a second
  read_recording(folder(), options);
}

void mrpt_log(const std::string& bytes) {
  datasets::RecordingOptions options;
  options.input.rotating = {-15, 15, datasets::ZeroRanges::kNothing};
  read_recording(write("fuzz.rawlog", bytes), options);
}

void ros1_bag(const std::string& bytes) {
  read_recording(write("fuzz.bag", bytes), {});
}
void mcap_bag(const std::string& bytes) {
  read_recording(write("fuzz.mcap", bytes), {});
}
void sqlite_bag(const std::string& bytes) {
  read_recording(write("fuzz.db3", bytes), {});
}

}  // namespace fuzz
