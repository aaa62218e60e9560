#include "datasets/recording/formats/nuscenes_tables.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "datasets/files/text.h"
#include "datasets/recording/scans/number_lines.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

/// What a row of a table has of texts and lists of numbers.
struct Row {
  std::unordered_map<std::string, std::string> texts;
  std::unordered_map<std::string, std::vector<double>> numbers;
};

/// Hands over row after row of a list of flat objects.
class TableReader : public nlohmann::json_sax<nlohmann::json> {
 public:
  explicit TableReader(std::function<void(const Row&)> take) : take_(std::move(take)) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t&) override { return number(value); }
  bool string(string_t& value) override {
    if (depth_ == kInRow) row_.texts[key_] = value;
    return true;
  }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override {
    if (++depth_ == kInRow) row_ = {};
    return depth_ <= kMostDepth;
  }
  bool key(string_t& value) override {
    if (depth_ == kInRow) key_ = value;
    return true;
  }
  bool end_object() override {
    if (depth_-- == kInRow) take_(row_);
    return true;
  }
  bool start_array(std::size_t) override { return ++depth_ <= kMostDepth; }
  bool end_array() override {
    --depth_;
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

 private:
  static constexpr int kInRow = 2, kMostDepth = 16;  // the list is 1

  bool number(double value) {
    if (depth_ == kInRow + 1) row_.numbers[key_].push_back(value);
    return true;
  }

  std::function<void(const Row&)> take_;
  Row row_;
  std::string key_;
  int depth_ = 0;
};

void read_table(const fs::path& file, const std::function<void(const Row&)>& take) {
  TableReader reader(take);
  const auto stream = open_file(file);
  if (!nlohmann::json::sax_parse(*stream, &reader)) {
    throw ldm::InvalidInput(file.string() + ": no table: allowed: a list of rows in JSON");
  }
}

ldm::Pose pose_in(const Row& row, const fs::path& file) {
  const auto translation = row.numbers.find("translation"), rotation = row.numbers.find("rotation");
  if (translation != row.numbers.end() && rotation != row.numbers.end() &&
      translation->second.size() == 3 && rotation->second.size() == 4) {
    const std::vector<double>&t = translation->second, &q = rotation->second;
    const Eigen::Quaterniond quaternion(q[0], q[1], q[2], q[3]);
    constexpr double kWrongNorm = 0.05;
    if (std::abs(quaternion.norm() - 1) < kWrongNorm) {
      return {quaternion.normalized().toRotationMatrix(), {t[0], t[1], t[2]}};
    }
  }
  throw ldm::InvalidInput(
      file.string() +
      ": a row without a pose: allowed: translation of 3 numbers, rotation of 4, "
      "of norm 1");
}

std::string text_in(const Row& row, const std::string& key) {
  const auto found = row.texts.find(key);
  return found == row.texts.end() ? "" : found->second;
}

}  // namespace

std::optional<fs::path> nuscenes_tables(const fs::path& scans) {
  std::vector<std::string> found;
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(scans);
  for (const fs::path& place : {whole, whole.parent_path().parent_path()}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(place, error)) {
      if (entry.path().filename().string().starts_with("v1.0-") &&
          fs::exists(entry.path() / "sample_data.json")) {
        found.push_back(entry.path().string());
      }
    }
  }
  if (found.empty()) return {};
  if (found.size() == 1) return found.front();
  std::sort(found.begin(), found.end());
  throw ldm::InvalidInput(scans.string() + ": several tables of nuScenes, " + joined(found) +
                          ": allowed: one, or --poses FILE");
}

NuscenesPoses read_nuscenes_poses(const fs::path& tables, const std::vector<std::string>& names) {
  NuscenesPoses poses;
  poses.T_world_vehicle.resize(names.size());
  std::unordered_map<std::string, std::size_t> scan_of_name, scan_of_token;
  for (std::size_t k = 0; k < names.size(); ++k) scan_of_name[names[k]] = k;
  std::vector<std::string> mounts;
  read_table(tables / "sample_data.json", [&](const Row& row) {
    const auto scan = scan_of_name.find(fs::path(text_in(row, "filename")).filename().string());
    if (scan == scan_of_name.end()) return;
    scan_of_token[text_in(row, "ego_pose_token")] = scan->second;
    const std::string mount = text_in(row, "calibrated_sensor_token");
    if (std::find(mounts.begin(), mounts.end(), mount) == mounts.end()) mounts.push_back(mount);
  });
  if (scan_of_token.empty()) {
    throw ldm::InvalidInput((tables / "sample_data.json").string() +
                            ": has none of the scans: allowed: the tables that belong to them");
  }
  read_table(tables / "ego_pose.json", [&](const Row& row) {
    const auto scan = scan_of_token.find(text_in(row, "token"));
    if (scan == scan_of_token.end()) return;
    poses.T_world_vehicle[scan->second] = pose_in(row, tables / "ego_pose.json");
  });
  std::optional<ldm::Pose> T_vehicle_sensor;
  read_table(tables / "calibrated_sensor.json", [&](const Row& row) {
    if (std::find(mounts.begin(), mounts.end(), text_in(row, "token")) == mounts.end()) return;
    const ldm::Pose mount = pose_in(row, tables / "calibrated_sensor.json");
    if (T_vehicle_sensor && (!mount.rotation.isApprox(T_vehicle_sensor->rotation, 1e-6) ||
                             !mount.translation.isApprox(T_vehicle_sensor->translation, 1e-6))) {
      throw ldm::InvalidInput((tables / "calibrated_sensor.json").string() +
                              ": the scans' sensor sits in several places: allowed: scans of one "
                              "car and day");
    }
    T_vehicle_sensor = mount;
  });
  if (!T_vehicle_sensor) {
    throw ldm::InvalidInput((tables / "calibrated_sensor.json").string() +
                            ": has no row of the scans' sensor");
  }
  poses.T_vehicle_sensor = *T_vehicle_sensor;
  return poses;
}

}  // namespace datasets
