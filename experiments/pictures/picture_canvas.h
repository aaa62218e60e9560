#pragma once
/// What a picture is drawn on: solids, lines and words, through MRPT's renderer (no paper section).
#include <memory>
#include <string>

#include "experiments/pictures/picture.h"

namespace mrpt::opengl {
class COpenGLScene;
}

namespace experiments {

/// World coordinates in metres; words in pixels.
class PictureCanvas {
 public:
  enum class Align { kLeft, kCentre, kRight };

  /// @param fine what is drawn off screen is so many times larger and then reduced, which smooths
  ///   edges; 1 for a window
  explicit PictureCanvas(const PictureCamera& camera, int fine = 2);
  ~PictureCanvas();
  PictureCanvas(const PictureCanvas&) = delete;
  PictureCanvas& operator=(const PictureCanvas&) = delete;

  const PictureCamera& camera() const { return camera_; }

  /// Translucent.
  void cube(const Eigen::Vector3d& centre, double edge, const Colour& colour);
  void ball(const Eigen::Vector3d& centre, double radius, const Colour& colour);
  /// Around the z axis of its pose.
  void disc(const ldm::Pose& T_world_disc, double radius, const Colour& colour);
  /// @param radius of the head; a short arrow is mostly head
  void arrow(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
             const Colour& colour);
  /// A horizontal square without shading.
  void square(const Eigen::Vector3d& centre, double edge, const Colour& colour);
  void dot(const Eigen::Vector3d& at, const Colour& colour);
  /// Thin: software OpenGL knows one width only.
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to, const Colour& colour);
  /// Its twelve edges.
  void box(const Eigen::AlignedBox3d& box, const Colour& colour);

  /// @param at where the base line begins, has its middle or ends
  void words(const Eigen::Vector2d& at, double size, const std::string& text, Align align,
             const Colour& colour);
  /// [pixel]
  double width(const std::string& text, double size) const;

  /// @throws as the free function write_png.
  void write_png(datasets::PartialFile& file);
  /// See the free function pixels.
  std::vector<std::uint8_t> pixels();
  /// What was drawn, for MRPT's window; nothing may be drawn afterwards.
  std::shared_ptr<mrpt::opengl::COpenGLScene> take_scene();

 private:
  class Scene;
  PictureCamera camera_;
  int fine_;
  std::unique_ptr<Scene> scene_;
};

}  // namespace experiments
