#pragma once
/// A window on the screen that shows pictures, through MRPT's 3D window (no paper section;
/// docs/pictures.md).
#include <memory>
#include <optional>
#include <string>

#include "experiments/pictures/picture.h"

namespace experiments {

/// The mouse turns, moves and zooms what it shows.
class PictureWindow {
 public:
  virtual ~PictureWindow() = default;

  /// The first one is seen from where `camera_of` stands; later ones leave the view as the user set
  /// it, and follow the map.
  virtual void show(const Picture& picture) = 0;
  /// The key that was pressed since the last call: ' ', 'n', ..., '>' for the right arrow, 'q' also
  /// for Escape; none if none.
  virtual std::optional<char> key() = 0;
  /// False once the user has closed it.
  virtual bool is_open() = 0;
};

/// The one function of the library that `ldm view` loads: only that command pays for MRPT's window,
/// whose libraries take longer to load than a short trial to run.
using OpenPictureWindow = PictureWindow*(const char* title, std::string& error);
inline constexpr char kPictureWindowLibrary[] = "ldm_window.so";
inline constexpr char kOpenPictureWindow[] = "ldm_open_picture_window";

}  // namespace experiments
