#include "experiments/pictures/window/picture_window.h"

#include <mrpt/gui/CDisplayWindow3D.h>
#include <mrpt/opengl/COpenGLScene.h>
#include <mrpt/opengl/CText.h>

#include <cctype>
#include <cmath>
#include <numbers>

#include "experiments/pictures/picture_solids.h"
#include "experiments/pictures/window/display.h"

namespace experiments {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr char kHelp[] =
    "space: pause or go on    n or right arrow: one frame    q: quit    "
    "mouse: turn, zoom, move";

mrpt::opengl::TFontParams font(float size) {
  mrpt::opengl::TFontParams params;
  params.vfont_name = "sans";
  params.vfont_scale = size;
  params.color = {0.1F, 0.1F, 0.1F};
  return params;
}

class MrptWindow : public PictureWindow {
 public:
  explicit MrptWindow(const char* title)
      : window_(mrpt::gui::CDisplayWindow3D::Create(title, Picture::kWidth, Picture::kHeight)) {}

  void show(const Picture& picture) override {
    PictureCanvas canvas(camera_of(picture), 1);
    draw_solids(picture, canvas);
    const auto scene = canvas.take_scene();
    add_labels(picture, *scene);
    add_lines(picture, *scene);
    window_->get3DSceneAndLock() = scene;
    window_->unlockAccess3DScene();
    if (!shown_) look_at(picture);
    follow(picture);
    window_->forceRepaint();
    shown_ = true;
  }

  std::optional<char> key() override {
    if (!window_->keyHit()) return {};
    const int code = window_->getPushedKey();
    if (code == mrpt::gui::MRPTK_RIGHT) return '>';
    if (code == mrpt::gui::MRPTK_ESCAPE) return 'q';
    if (code <= 0 || code > 127) return {};
    return static_cast<char>(std::tolower(code));  // MRPT tells the key, a capital
  }

  bool is_open() override { return window_->isOpen(); }

 private:
  /// Words beside the tips of arrows, which turn with the scene.
  static void add_labels(const Picture& picture, mrpt::opengl::COpenGLScene& scene) {
    for (const Picture::Arrow& arrow : picture.arrows) {
      auto text = mrpt::opengl::CText::Create(arrow.label);
      text->setFont("sans", 22);
      text->setColor_u8({kArrowColour.red, kArrowColour.green, kArrowColour.blue});
      text->setLocation(static_cast<double>(arrow.to.x()), static_cast<double>(arrow.to.y()),
                        static_cast<double>(arrow.to.z()) + 0.15);
      scene.insert(text);
    }
  }

  static void add_lines(const Picture& picture, mrpt::opengl::COpenGLScene& scene) {
    const auto view = scene.getViewport();
    double row = 30;
    std::size_t number = 0;
    for (const std::string& line : picture.heading) {
      view->addTextMessage(15, -row, line, number++, font(row == 30 ? 18.0F : 14.0F));
      row += 26;
    }
    view->addTextMessage(15, 12, kHelp, number, font(12));
  }

  void look_at(const Picture& picture) {
    const PictureCamera camera = camera_of(picture);
    const Eigen::Vector3d from = camera.T_world_camera().translation - picture.border.center();
    window_->setCameraProjective(true);
    window_->setFOV(static_cast<float>(2 * kDegrees * std::atan(360 / camera.focal_length())));
    window_->setCameraAzimuthDeg(static_cast<float>(kDegrees * std::atan2(from.y(), from.x())));
    window_->setCameraElevationDeg(
        static_cast<float>(kDegrees * std::asin(from.z() / from.norm())));
    window_->setCameraZoom(static_cast<float>(from.norm()));
  }

  /// Keeps the map in the middle, unless the user looks elsewhere.
  void follow(const Picture& picture) {
    const Eigen::Vector3f centre = picture.border.center().cast<float>();
    Eigen::Vector3f now = centre;
    if (shown_) {
      window_->getCameraPointingToPoint(now.x(), now.y(), now.z());
      now += centre - centre_;
    }
    centre_ = centre;
    window_->setCameraPointingToPoint(now.x(), now.y(), now.z());
  }

  mrpt::gui::CDisplayWindow3D::Ptr window_;
  bool shown_ = false;
  Eigen::Vector3f centre_ = Eigen::Vector3f::Zero();  ///< of the last map
};

}  // namespace

extern "C" __attribute__((visibility("default"))) PictureWindow* ldm_open_picture_window(
    const char* title, std::string& error) {
  if (!has_display()) {
    error = "no display can be opened: allowed: where DISPLAY names an X server";
    return nullptr;
  }
  auto window = std::make_unique<MrptWindow>(title);
  if (window->is_open()) return window.release();
  error = "no window can be opened: allowed: a display that GTK can use";
  return nullptr;
}

}  // namespace experiments
