#include "experiments/runs/view.h"

#include <chrono>
#include <thread>

#include "datasets/files/loaded_library.h"
#include "experiments/pictures/window/picture_window.h"
#include "experiments/runs/picture_stream.h"

namespace experiments {
namespace {

using Clock = std::chrono::steady_clock;

std::unique_ptr<PictureWindow> open_window(const std::string& title) {
  auto* const open =
      datasets::loaded_function<OpenPictureWindow>(kPictureWindowLibrary, kOpenPictureWindow);
  if (open == nullptr) {
    throw ldm::InvalidInput(
        "view: this program was built without a window: allowed: after `make view`, which installs "
        "Debian's libmrpt-gui-dev and builds one");
  }
  std::string error;
  std::unique_ptr<PictureWindow> window(open(title.c_str(), error));
  if (!window) throw ldm::InvalidInput("view: " + error);
  return window;
}

/// What the user asks for: space pauses or goes on, n and the right arrow step, q ends.
class Controls {
 public:
  Controls(PictureWindow& window, bool paused) : window_(window), paused_(paused) {}

  /// Waits until the next frame may be shown, which is not before `due`; false: end.
  bool await(Clock::time_point due) {
    while (window_.is_open()) {
      const std::optional<char> key = window_.key();
      if (key == 'q') return false;
      if (key == ' ') paused_ = !paused_;
      if (key == 'n' || key == '>') {
        paused_ = true;
        return true;
      }
      if (!key && !paused_ && Clock::now() >= due) return true;
      if (!key) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

  void pause() { paused_ = true; }

 private:
  PictureWindow& window_;
  bool paused_;
};

}  // namespace

void view(const ViewRequest& request, const DataFolders& folders) {
  PictureStream stream(request, folders);
  const std::unique_ptr<PictureWindow> window = open_window("ldm view: " + stream.input());
  Controls controls(*window, request.paused);
  Clock::time_point due = Clock::now();
  std::optional<double> shown;  // time of the last frame [s]
  while (stream.next()) {
    if (shown) {
      const std::chrono::duration<double> step((stream.time() - *shown) / request.rate);
      // What took too long is not caught up: after a pause, all that was missed would rush by.
      due = std::max(Clock::now(), due + std::chrono::duration_cast<Clock::duration>(step));
      if (!controls.await(due)) return;
    }
    window->show(stream.picture());
    shown = stream.time();
  }
  controls.pause();  // the last frame stays
  while (controls.await(due)) {
  }
}

}  // namespace experiments
