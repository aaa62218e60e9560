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
    for (const char* inner : {"velodyne", "raw/velodyne_points/data", "raw/oxts/data"}) {
      fs::create_directories(path_ / inner);
    }
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

/// What stands between lines of three dashes; behind the last of them, whatever it is.
std::vector<std::string> parts_of(const std::string& bytes, std::size_t count) {
  constexpr std::string_view kBetween = "---\n";
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (parts.size() + 1 < count) {
    const std::size_t end = std::min(bytes.find(kBetween, begin), bytes.size());
    parts.push_back(bytes.substr(begin, end - begin));
    begin = std::min(end + kBetween.size(), bytes.size());
  }
  parts.push_back(bytes.substr(begin));
  return parts;
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
  const std::vector<std::string> parts = parts_of(bytes, 4);
  write("times.txt", parts[0]);
  write("poses.txt", parts[1]);
  if (parts[2].empty()) {
    fs::remove(folder() / "calib.txt");
  } else {
    write("calib.txt", parts[2]);
  }
  write("velodyne/000000.bin", parts[3]);
  write("velodyne/000001.bin", parts[3]);
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

void kitti_raw(const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 5);
  write("raw/velodyne_points/timestamps.txt", parts[0]);
  write("raw/oxts/timestamps.txt", parts[1]);
  write("raw/calib_imu_to_velo.txt", parts[2]);
  for (const char* name : {"0000000000", "0000000001"}) {
    write(std::string("raw/oxts/data/") + name + ".txt", parts[3]);
    write(std::string("raw/velodyne_points/data/") + name + ".bin", parts[4]);
  }
  read_recording(folder() / "raw", {});
}

void pcap(const std::string& bytes) {
  const std::vector<std::string> parts = parts_of(bytes, 2);
  if (parts[0].empty()) {
    fs::remove(folder() / "fuzz.json");
  } else {
    write("fuzz.json", parts[0]);
  }
  datasets::RecordingOptions options;
  options.input.poses = datasets::PoseSource::kStill;
  read_recording(write("fuzz.pcap", parts[1]), options);
}

}  // namespace fuzz
