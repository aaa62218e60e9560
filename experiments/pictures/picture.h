#pragma once
/// A picture of a local map, and its drawing without a display (in the manner of Figures 12 and
/// 13 of the paper).
#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "datasets/files/partial_file.h"
#include "experiments/pictures/picture_camera.h"
#include "ldm/types.h"

namespace experiments {

/// sRGB.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Colour&) const = default;
};

/// What a picture shows. World frame, lengths in metres.
struct Picture {
  struct Cube {
    ldm::Point centre;
    Colour colour;
  };
  struct Arrow {
    ldm::Point from, to;
    std::string label;  ///< beside its tip
  };
  /// A row of small balls, explained in the legend.
  struct Path {
    std::vector<ldm::Point> points;
    Colour colour;
    std::string text;
  };
  /// One line of the legend: a small cube of each colour, then the text.
  struct CubeKey {
    std::vector<Colour> colours;
    std::string text;
  };

  static constexpr int kWidth = 1280, kHeight = 720;  ///< [pixel]

  std::vector<std::string> heading;  ///< lines at the upper left; the first is larger
  Eigen::AlignedBox3d border;        ///< of the map; fills the picture, with a metre grid as floor
  std::vector<ldm::Point> points;    ///< small dots
  double cube_edge = 0;
  std::vector<Cube> cubes;  ///< translucent; each throws a shadow on the floor
  std::vector<CubeKey> cube_keys;
  std::vector<Arrow> arrows;  ///< red
  std::string arrow_key;      ///< what arrows mean; empty: no such line in the legend
  std::vector<Path> paths;
  ldm::Pose T_world_uav;
};

/// The camera that `write_png` looks through.
PictureCamera camera_of(const Picture& picture);

/// Draw to a file, whose name must end in `.png`. Text: ASCII. Same picture, same machine: same
/// file. Needs EGL, but no display. To be called from one thread only. About 1 s.
/// @throws std::runtime_error if the file cannot be written, or if there is no EGL.
void write_png(const Picture& picture, datasets::PartialFile& file);

/// The same as pixels: rows from the top, each of kWidth times red, green, blue.
std::vector<std::uint8_t> pixels(const Picture& picture);

}  // namespace experiments
