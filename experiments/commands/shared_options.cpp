#include "experiments/commands/shared_options.h"

namespace experiments {
namespace {

void add_parameters(Command& command, MethodOnInput& request) {
  command.option("-c,--config", request.config,
                 "TOML file of parameters, or a preset: uav, road, indoor");
  command
      .option("--set", request.settings,
              "name=value of a parameter, or scenario.NAME=VALUE; may be repeated")
      .repeatable();
  command.option("--seed", request.seed, "of a scenario's world (default 1)");
  add_recording_options(command, request);
}

CommandOption add_input(Command& command, MethodOnInput& request) {
  return command.option(
      "INPUT", request.input,
      "scenario (name or .toml file), or recording: .rawlog file of ours or MRPT's, "
      "KITTI folder, folder of PCD or .bin files, bag of ROS, .pcap of a Velodyne or Ouster "
      "sensor (docs/recordings.md)");
}

}  // namespace

void add_method_and_input(Command& command, MethodOnInput& request) {
  command.option("METHOD", request.method, "a method that `ldm methods` lists").required();
  add_input(command, request).required();
  add_parameters(command, request);
}

void add_run_or_method(Command& command, MethodOnInput& request) {
  command
      .option("METHOD", request.method,
              "a method that `ldm methods` lists; or, without INPUT, the output folder of `ldm "
              "run`, which is repeated")
      .required();
  add_input(command, request);
  add_parameters(command, request);
}

void add_recording_options(Command& command, MethodOnInput& request) {
  command.option("--format", request.format,
                 "of a recording: kitti, kitti-raw, bin, pcd, bag, pcap, mrpt-rawlog, ldm-rawlog "
                 "(default: recognised)");
  command.option(
      "--poses", request.recording.poses,
      "trajectory, TUM's or KITTI's, or a folder with KISS-ICP's results (default: that of "
      "the recording)");
  command.option("--points", request.recording.points, "topic of a bag with the scans");
  command.option("--poses-topic", request.recording.poses_topic,
                 "topic of a bag with the poses: TF, odometry or poses");
  command.option("--sensor-frame", request.recording.sensor_frame,
                 "frame that the scans of a bag are in, whatever they say");
  command.option("--times", request.recording.times,
                 "times of a folder of scans, one a line (default: its times.txt)");
  command.option("--time-unit", request.time_unit,
                 "of those two files: s, ms, us or ns (default: s)");
  command.flag("--keep-going", request.recording.keep_going,
               "skip and count the frames of a log that are broken");
}

void add_study_options(Command& command, std::string& study, StudyOptions& options) {
  command.option("STUDY", study, "name or .toml file").required();
  command.option("--seeds", options.seeds, "replicates, instead of the study's").within(1, 100000);
  command.option("--frames", options.frames, "per trial, instead of the study's")
      .within(1, 1000000);
  command.option("--method", options.methods, "instead of the study's methods; may be repeated")
      .repeatable();
}

}  // namespace experiments
