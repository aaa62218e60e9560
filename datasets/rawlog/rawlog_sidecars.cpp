#include "datasets/rawlog/rawlog_sidecars.h"

#include <limits>
#include <span>

#include "datasets/files/text.h"
#include "datasets/files/toml_reader.h"

namespace datasets {
namespace {

constexpr std::int64_t kFormat = 1;
constexpr std::int64_t kMaxId = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kMaxPerFrame = 100000;  // objects, or solids of one: guards against garbage
constexpr std::int64_t kMaxImageEdge = std::numeric_limits<std::uint16_t>::max();  // MRPT's limit

constexpr std::string_view kShapes[] = {"box", "cylinder", "sphere"};  // as in Solid::Shape

constexpr char kFramesHeader[] = "frame,time_s,x_m,y_m,z_m,qw,qx,qy,qz,objects";
constexpr char kTruthHeader[] =
    "frame,time_s,id,dynamic,x_m,y_m,z_m,vx_mps,vy_mps,vz_mps,ax_mps2,ay_mps2,az_mps2,"
    "sx_m,sy_m,sz_m,solids";
constexpr char kSolidsHeader[] =
    "frame,id,shape,x_m,y_m,z_m,r00,r01,r02,r10,r11,r12,r20,r21,r22,sx_m,sy_m,sz_m";

Eigen::Vector3d read_vector(CsvReader& csv) {
  const double x = csv.number(), y = csv.number(), z = csv.number();
  return {x, y, z};
}

std::string toml_list(std::span<const double> numbers) {
  std::string text = "[";
  for (std::size_t i = 0; i < numbers.size(); ++i) text += (i ? ", " : "") + decimal(numbers[i]);
  return text + "]";
}

}  // namespace

LogFiles::LogFiles(const std::filesystem::path& name) : rawlog(name) {
  if (name.extension() != ".rawlog") {
    throw ldm::InvalidInput(name.string() + ": allowed: a file name that ends in .rawlog");
  }
  const auto beside = [&name](const char* extension) {
    return std::filesystem::path(name).replace_extension(extension);
  };
  description = beside(".log.toml");
  frames = beside(".frames.csv");
  truth = beside(".truth.csv");
  solids = beside(".solids.csv");
}

void write_description(const LogDescription& description, std::ostream& out) {
  const LidarModel& lidar = description.lidar;
  const ldm::Pose& mount = description.T_uav_sensor;
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rotation = mount.rotation;
  out << "format = " << kFormat << "\nframes = " << description.frames  //
      << "\n\n[lidar]\nelevations_rad = " << toml_list(lidar.elevations)
      << "\nazimuths = " << lidar.azimuths << "\nrate_hz = " << decimal(lidar.rate)
      << "\nmin_range_m = " << decimal(lidar.min_range)
      << "\nmax_range_m = " << decimal(lidar.max_range)
      << "\nrange_sigma_m = " << decimal(lidar.range_sigma)
      << "\n\n[T_uav_sensor]\ntranslation_m = " << toml_list({mount.translation.data(), 3})
      << "\nrotation = " << toml_list({rotation.data(), 9}) << "\n";
}

LogDescription read_description(const std::filesystem::path& file) {
  const TomlTable table = TomlTable::open(file);
  table.integer("format", {kFormat, kFormat});
  LogDescription description;
  description.frames = table.integer("frames", {.min = 0});

  const TomlTable lidar = table.table("lidar");
  LidarModel& model = description.lidar;
  model.elevations = lidar.numbers("elevations_rad", {-2, 2}, {1, kMaxImageEdge});
  model.azimuths = static_cast<std::int32_t>(lidar.integer("azimuths", {1, kMaxImageEdge}));
  model.rate = lidar.number("rate_hz", {.min = 0});
  model.min_range = lidar.number("min_range_m", {.min = 0});
  model.max_range = lidar.number("max_range_m", {.min = 0});
  model.range_sigma = lidar.number("range_sigma_m", {.min = 0});

  const TomlTable mount = table.table("T_uav_sensor");
  const std::vector<double> t = mount.numbers("translation_m", {}, {3, 3});
  const std::vector<double> r = mount.numbers("rotation", {}, {9, 9});
  description.T_uav_sensor.translation << t[0], t[1], t[2];
  description.T_uav_sensor.rotation << r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8];
  table.reject_unknown_keys();
  return description;
}

SidecarWriter::SidecarWriter(std::ostream& frames, std::ostream& truth, std::ostream& solids)
    : frames_(frames, kFramesHeader), truth_(truth, kTruthHeader), solids_(solids, kSolidsHeader) {}

void SidecarWriter::write(const FrameRow& row, const std::vector<ObjectState>& objects) {
  const QuaternionPose& pose = row.T_world_uav;
  frames_.add(row.frame).add(row.time).add_vector(pose.translation);
  frames_.add(pose.w).add(pose.x).add(pose.y).add(pose.z);
  frames_.add(static_cast<std::int64_t>(objects.size())).end_row();
  for (const ObjectState& object : objects) {
    const std::int64_t id = object.id;
    truth_.add(row.frame).add(row.time).add(id).add(std::int64_t{object.dynamic});
    for (const auto* v : {&object.position, &object.velocity, &object.acceleration, &object.size}) {
      truth_.add_vector(*v);
    }
    truth_.add(static_cast<std::int64_t>(object.solids.size())).end_row();
    for (const Solid& solid : object.solids) {
      solids_.add(row.frame).add(id).add(kShapes[static_cast<std::size_t>(solid.shape)]);
      solids_.add_vector(solid.T_world_solid.translation);
      for (int r = 0; r < 3; ++r) solids_.add_vector(solid.T_world_solid.rotation.row(r));
      solids_.add_vector(solid.size).end_row();
    }
  }
}

SidecarReader::SidecarReader(const LogFiles& files, std::int64_t frames)
    : count_(frames),
      frames_(files.frames, kFramesHeader),
      truth_(files.truth, kTruthHeader),
      solids_(files.solids, kSolidsHeader) {}

FrameRow SidecarReader::read(std::vector<ObjectState>& objects) {
  FrameRow row;
  row.frame = next_++;
  if (!frames_.next_row()) {
    frames_.reject("the file ends, allowed: " + std::to_string(count_) + " frames");
  }
  frames_.integer(row.frame, row.frame);
  row.time = frames_.number();
  QuaternionPose& pose = row.T_world_uav;
  pose.translation = read_vector(frames_);
  for (double* component : {&pose.w, &pose.x, &pose.y, &pose.z}) *component = frames_.number();
  objects.resize(static_cast<std::size_t>(frames_.integer(0, kMaxPerFrame)));
  for (ObjectState& object : objects) object = read_object(row.frame);
  return row;
}

ObjectState SidecarReader::read_object(std::int64_t frame) {
  if (!truth_.next_row()) {
    truth_.reject("the file ends, but frame " + std::to_string(frame) + " has more objects");
  }
  ObjectState object;
  truth_.integer(frame, frame);
  truth_.number();  // the time, for the convenience of other readers
  object.id = static_cast<std::int32_t>(truth_.integer(0, kMaxId));
  object.dynamic = truth_.integer(0, 1) == 1;
  for (auto* v : {&object.position, &object.velocity, &object.acceleration, &object.size}) {
    *v = read_vector(truth_);
  }
  object.solids.resize(static_cast<std::size_t>(truth_.integer(0, kMaxPerFrame)));
  for (Solid& solid : object.solids) solid = read_solid(frame, object.id);
  return object;
}

Solid SidecarReader::read_solid(std::int64_t frame, std::int64_t id) {
  if (!solids_.next_row()) {
    solids_.reject("the file ends, but object " + std::to_string(id) + " of frame " +
                   std::to_string(frame) + " has more solids");
  }
  Solid solid;
  solids_.integer(frame, frame);
  solids_.integer(id, id);
  solid.shape = static_cast<Solid::Shape>(solids_.choice(kShapes));
  solid.T_world_solid.translation = read_vector(solids_);
  for (int r = 0; r < 3; ++r) solid.T_world_solid.rotation.row(r) = read_vector(solids_);
  solid.size = read_vector(solids_);
  return solid;
}

void SidecarReader::check_end() {
  for (CsvReader* csv : {&frames_, &truth_, &solids_}) {
    if (csv->next_row()) {
      csv->reject("a row too many: the log has " + std::to_string(count_) + " frames");
    }
  }
}

}  // namespace datasets
