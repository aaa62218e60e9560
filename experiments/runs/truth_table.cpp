#include "experiments/runs/truth_table.h"

#include <algorithm>
#include <limits>
#include <set>

#include "datasets/files/csv.h"
#include "datasets/files/text.h"
#include "experiments/metrics/velocity_score.h"

namespace experiments {
namespace {

using Names = std::vector<std::string>;

/// A truth table row by row.
class TruthReader {
 public:
  explicit TruthReader(const std::filesystem::path& file)
      : csv_(file),
        frame_(column({"frame"})),
        id_(column({"id"})),
        position_{column({"x", "x_m"}), column({"y", "y_m"}), column({"z", "z_m"})},
        velocity_{column({"vx", "vx_mps"}), column({"vy", "vy_mps"}), column({"vz", "vz_mps"})},
        time_(find({"time_s"})),
        dynamic_(find({"dynamic"})) {
    const std::optional<std::size_t> edge = find({"size", "size_m"});
    const Names axes[] = {
        {"sx", "sx_m", "size_x_m"}, {"sy", "sy_m", "size_y_m"}, {"sz", "sz_m", "size_z_m"}};
    for (std::size_t i = 0; i < 3; ++i) size_[i] = edge ? *edge : column(axes[i], "size");
  }

  TruthTable read() {
    TruthTable table;
    while (csv_.next_row()) read_row(table);
    if (!dynamic_) find_dynamic_objects(table);
    return table;
  }

 private:
  std::optional<std::size_t> find(const Names& names) const {
    const auto& all = csv_.columns();
    const auto found = std::find_first_of(all.begin(), all.end(), names.begin(), names.end());
    if (found == all.end()) return {};
    return static_cast<std::size_t>(found - all.begin());
  }
  std::size_t column(Names names, const std::string& instead = "") const {
    if (const auto found = find(names)) return *found;
    if (!instead.empty()) names.push_back(instead);
    csv_.reject("no column " + names.front() + ": allowed: a column named " +
                datasets::joined(names, " or "));
  }

  std::int64_t integer(std::size_t column, std::int64_t min, std::int64_t max) {
    csv_.go_to(column);
    return csv_.integer(min, max);
  }
  bool flag(std::size_t column) {
    csv_.go_to(column);
    return csv_.boolean();
  }
  double number(std::size_t column) {
    csv_.go_to(column);
    return csv_.number();
  }
  Eigen::Vector3d vector(const std::size_t (&columns)[3]) {
    return {number(columns[0]), number(columns[1]), number(columns[2])};
  }

  void read_row(TruthTable& table) {
    constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
    const std::int64_t frame = integer(frame_, 0, kMax);
    TruthObject object{.id = integer(id_, -kMax, kMax),
                       .dynamic = dynamic_ && flag(*dynamic_),
                       .position = vector(position_),
                       .velocity = vector(velocity_),
                       .size = vector(size_)};
    if ((object.size.array() < 0).any()) csv_.reject("a negative size: allowed: 0 m or more");
    if (!seen_.insert({frame, object.id}).second) {
      csv_.reject("object " + std::to_string(object.id) + " a second time in frame " +
                  std::to_string(frame) + ": allowed: one row for each");
    }
    TruthFrame& entry = table[frame];
    if (time_) entry.time = number(*time_);
    entry.objects.push_back(object);
  }

  static void find_dynamic_objects(TruthTable& table) {
    std::set<std::int64_t> moving;
    for (const auto& [number, frame] : table) {
      for (const TruthObject& object : frame.objects) {
        if (object.moves()) moving.insert(object.id);
      }
    }
    for (auto& [number, frame] : table) {
      for (TruthObject& object : frame.objects) object.dynamic = moving.contains(object.id);
    }
  }

  datasets::CsvReader csv_;
  std::size_t frame_, id_, position_[3], velocity_[3];
  std::optional<std::size_t> time_, dynamic_;
  std::size_t size_[3] = {};
  std::set<std::pair<std::int64_t, std::int64_t>> seen_;  ///< frame, id
};

}  // namespace

bool TruthObject::moves() const {
  return velocity.norm() > VelocityTally::kStanding;
}

TruthTable read_truth_table(const std::filesystem::path& file) {
  return TruthReader(file).read();
}

}  // namespace experiments
