#include "experiments/pictures/video_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <string>
#include <vector>

#include "datasets/files/text.h"
#include "ldm/types.h"

extern char** environ;

namespace experiments {
namespace {

std::vector<std::string> ffmpeg_command(const std::filesystem::path& file, int width, int height,
                                        double rate) {
  const std::string size = std::to_string(width) + "x" + std::to_string(height);
  return {"ffmpeg",   "-loglevel", "error",     "-y",         "-f",         "rawvideo",
          "-pix_fmt", "rgb24",     "-s",        size,         "-r",         datasets::decimal(rate),
          "-i",       "-",         "-c:v",      "libx264",    "-crf",       "20",
          "-pix_fmt", "yuv420p",   "-movflags", "+faststart", file.string()};
}

/// Start `command` with `input` as its standard input and what it complains of going to `errors`;
/// the error number, 0 if it runs.
int start(std::vector<std::string> command, int input, int errors, pid_t& process) {
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  // Of its own group: Ctrl-C is for this program, which then ends the film in order.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  const int error =
      posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error;
}

}  // namespace

void check_ending(const char* option, const std::filesystem::path& file, const char* ending) {
  if (file.extension() == ending) return;
  throw ldm::InvalidInput(std::string(option) + " " + file.string() + ": allowed: FILE" + ending);
}

VideoFile::VideoFile(const std::filesystem::path& file, int width, int height, double rate)
    : name_(file.string()), file_(file) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe to ffmpeg can be made");
  errors_ = memfd_create("ffmpeg's complaints", MFD_CLOEXEC);
  const int error =
      start(ffmpeg_command(file_.temporary_name(), width, height, rate), ends[0], errors_, ffmpeg_);
  close(ends[0]);
  to_ffmpeg_ = ends[1];
  std::signal(SIGPIPE, SIG_IGN);  // an early end of ffmpeg is an error of write
  if (error == 0) return;
  close(to_ffmpeg_);
  close(errors_);
  if (error == ENOENT) {
    throw ldm::InvalidInput(
        "--video " + file.string() +
        ": there is no ffmpeg: allowed: with Debian's package ffmpeg installed");
  }
  throw std::runtime_error("ffmpeg cannot be started");
}

VideoFile::~VideoFile() {
  if (ffmpeg_ > 0) ended_well();
  close(errors_);
}

void VideoFile::add(std::span<const std::uint8_t> rgb) {
  while (!rgb.empty()) {
    const ssize_t written = write(to_ffmpeg_, rgb.data(), rgb.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail();
    rgb = rgb.subspan(static_cast<std::size_t>(written));
  }
}

void VideoFile::finish() {
  if (!ended_well()) fail();
  file_.commit();
}

bool VideoFile::ended_well() {
  close(to_ffmpeg_);
  int status = 0;
  while (waitpid(ffmpeg_, &status, 0) < 0 && errno == EINTR) {
  }
  ffmpeg_ = -1;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void VideoFile::fail() {
  if (ffmpeg_ > 0) ended_well();
  std::string said(4096, '\0');
  said.resize(
      static_cast<std::size_t>(std::max<ssize_t>(0, pread(errors_, said.data(), said.size(), 0))));
  const std::string hidden = file_.temporary_name().string();
  for (std::size_t at = said.find(hidden); at != std::string::npos; at = said.find(hidden)) {
    said.replace(at, hidden.size(), "the film");
  }
  throw std::runtime_error(name_ + ": cannot be written: ffmpeg failed" +
                           (said.empty() ? "" : ": " + said));
}

}  // namespace experiments
