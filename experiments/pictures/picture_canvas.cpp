#include "experiments/pictures/picture_canvas.h"

#include <mrpt/opengl/CArrow.h>
#include <mrpt/opengl/CCylinder.h>
#include <mrpt/opengl/CFBORender.h>
#include <mrpt/opengl/COctoMapVoxels.h>
#include <mrpt/opengl/CPointCloud.h>
#include <mrpt/opengl/CSetOfLines.h>
#include <mrpt/opengl/CSetOfTriangles.h>
#include <mrpt/opengl/CSphere.h>
#include <mrpt/opengl/CText.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

#include "experiments/pictures/png_file.h"

namespace experiments {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using mrpt::img::CImage;
using mrpt::img::TColor;

constexpr double kCubeOpacity = 0.72;
constexpr Colour kCubeEdge{60, 60, 60};
constexpr double kDotSize = 2;  // [pixel]
constexpr int kSlices = 32;     // of round solids
constexpr double kHalo = 3;     // [fine pixel]: white around letters
constexpr char kFont[] = "sans";

TColor mrpt_colour(const Colour& c) {
  return {c.red, c.green, c.blue};
}

mrpt::math::TPoint3Df mrpt_point(const Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

mrpt::poses::CPose3D mrpt_pose(const ldm::Pose& pose) {
  mrpt::math::CMatrixDouble44 T;
  T.setIdentity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) T(row, column) = pose.rotation(row, column);
    T(row, 3) = pose.translation(row);
  }
  return mrpt::poses::CPose3D(T);
}

mrpt::opengl::CCamera mrpt_camera(const PictureCamera& camera, int fine) {
  mrpt::img::TCamera pinhole;
  pinhole.ncols = static_cast<uint32_t>(fine) * Picture::kWidth;
  pinhole.nrows = static_cast<uint32_t>(fine) * Picture::kHeight;
  const Vector2d centre = fine * camera.principal_point();
  const double focal_length = fine * camera.focal_length();
  pinhole.setIntrinsicParamsFromValues(focal_length, focal_length, centre.x(), centre.y());
  mrpt::opengl::CCamera result;
  result.setProjectiveFromPinhole(pinhole);
  result.set6DOFMode(true);
  result.setPose(mrpt_pose(camera.T_world_camera()));
  return result;
}

void append(mrpt::opengl::CSetOfLines& lines, const Vector3d& from, const Vector3d& to) {
  lines.appendLine(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
}

template <class Draw>
void for_each_edge(const Eigen::AlignedBox3d& box, Draw&& draw) {
  const auto corner = [&](int bits) {
    return Vector3d(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(bits)));
  };
  for (int i = 0; i < 8; ++i) {
    for (const int axis : {1, 2, 4}) {
      if (!(i & axis)) draw(corner(i), corner(i | axis));
    }
  }
}

std::unique_ptr<mrpt::opengl::CFBORender> make_renderer(int fine) {
  try {
    return std::make_unique<mrpt::opengl::CFBORender>(fine * Picture::kWidth,
                                                      fine * Picture::kHeight);
  } catch (const std::exception&) {  // MRPT's words are for its own authors
    throw std::runtime_error(
        "cannot draw: EGL offers no device; Debian's libegl1 and libgl1-mesa-dri have one");
  }
}

/// `top` becomes opacity * top + (1 - opacity) * bottom.
void blend(CImage& top, const CImage& bottom, double opacity) {
  const std::size_t bytes = top.getWidth() * static_cast<std::size_t>(top.getChannelCount());
  for (unsigned row = 0; row < top.getHeight(); ++row) {
    auto* above = top.ptrLine<std::uint8_t>(row);
    const auto* below = bottom.ptrLine<std::uint8_t>(row);
    for (std::size_t i = 0; i < bytes; ++i) {
      const double mixed = opacity * above[i] + (1 - opacity) * below[i];
      above[i] = static_cast<std::uint8_t>(std::lround(mixed));
    }
  }
}

}  // namespace

/// MRPT's objects: one for all cubes, and one for all dots or lines of a look.
class PictureCanvas::Scene {
 public:
  Scene(double depth, int fine) : fine_(fine) {
    view().setViewportClipDistances(static_cast<float>(0.2 * depth),
                                    static_cast<float>(10 * depth));
    view().setCustomBackgroundColor({1.0F, 1.0F, 1.0F});
    mrpt::opengl::TLightParameters& light = view().lightParameters();
    light.ambient = {0.62F, 0.62F, 0.62F, 1.0F};
    light.diffuse = {0.5F, 0.5F, 0.5F, 1.0F};
    light.specular = {0.0F, 0.0F, 0.0F, 1.0F};
    const mrpt::math::TPoint3Df down = mrpt_point(Vector3d(-0.15, 0.55, -0.8).normalized());
    light.direction = {down.x, down.y, down.z};
    cubes_->resizeVoxelSets(1);
    cubes_->showVoxels(0, true);
    cubes_->enableLights(true);
    cube_edges_->setColor_u8(mrpt_colour(kCubeEdge));
    squares_->enableLight(false);
    scene_->insert(squares_);
  }

  mrpt::opengl::COpenGLViewport& view() { return *scene_->getViewport(); }
  mrpt::opengl::COctoMapVoxels& cubes() { return *cubes_; }
  mrpt::opengl::CSetOfLines& cube_edges() { return *cube_edges_; }
  mrpt::opengl::CSetOfTriangles& squares() { return *squares_; }

  template <class Object>
  void insert(const std::shared_ptr<Object>& object, const Colour& colour) {
    object->setColor_u8(mrpt_colour(colour));
    scene_->insert(object);
  }

  mrpt::opengl::CPointCloud& dots(const Colour& colour) {
    auto& dots = dots_[{colour.red, colour.green, colour.blue}];
    if (!dots) {
      dots = mrpt::opengl::CPointCloud::Create();
      dots->enableVariablePointSize(false);
      dots->setPointSize(static_cast<float>(kDotSize * fine_));
      insert(dots, colour);
    }
    return *dots;
  }

  mrpt::opengl::CSetOfLines& lines(const Colour& colour) {
    auto& lines = lines_[{colour.red, colour.green, colour.blue}];
    if (!lines) {
      lines = mrpt::opengl::CSetOfLines::Create();
      insert(lines, colour);
    }
    return *lines;
  }

  void add_text(const Vector2d& at, const std::string& text,
                const mrpt::opengl::TFontParams& font) {
    view().addTextMessage(at.x(), at.y(), text, number_of_texts_++, font);
  }

  CImage draw(const PictureCamera& camera) {
    CImage below = render(camera);
    insert_cubes();
    CImage above = render(camera);
    // MRPT's own translucent objects hide what happens to be drawn after them.
    blend(above, below, kCubeOpacity);
    CImage reduced;
    above.scaleImage(reduced, Picture::kWidth, Picture::kHeight, mrpt::img::IMG_INTERP_AREA);
    return reduced;
  }

  mrpt::opengl::COpenGLScene::Ptr take() {
    insert_cubes();
    return std::move(scene_);
  }

 private:
  void insert_cubes() {
    scene_->insert(cubes_);
    scene_->insert(cube_edges_);
  }

  CImage render(const PictureCamera& camera) {
    // MRPT draws with the first renderer of a process only.
    static const std::unique_ptr<mrpt::opengl::CFBORender> renderer = make_renderer(fine_);
    renderer->setCamera(*scene_, mrpt_camera(camera, fine_));
    CImage image;
    renderer->render_RGB(*scene_, image);
    return image;
  }

  int fine_;
  mrpt::opengl::COpenGLScene::Ptr scene_ = mrpt::opengl::COpenGLScene::Create();
  mrpt::opengl::COctoMapVoxels::Ptr cubes_ = mrpt::opengl::COctoMapVoxels::Create();
  mrpt::opengl::CSetOfLines::Ptr cube_edges_ = mrpt::opengl::CSetOfLines::Create();
  mrpt::opengl::CSetOfTriangles::Ptr squares_ = mrpt::opengl::CSetOfTriangles::Create();
  std::map<std::tuple<int, int, int>, mrpt::opengl::CPointCloud::Ptr> dots_;
  std::map<std::tuple<int, int, int>, mrpt::opengl::CSetOfLines::Ptr> lines_;
  std::size_t number_of_texts_ = 0;
};

PictureCanvas::PictureCanvas(const PictureCamera& camera, int fine)
    : camera_(camera), fine_(fine), scene_(std::make_unique<Scene>(camera.depth(), fine)) {}

PictureCanvas::~PictureCanvas() = default;

void PictureCanvas::cube(const Vector3d& centre, double edge, const Colour& colour) {
  scene_->cubes().push_back_Voxel(0, {mrpt_point(centre), edge, mrpt_colour(colour)});
  const Vector3d half = Vector3d::Constant(0.505 * edge);  // before the faces
  for_each_edge({centre - half, centre + half}, [&](const Vector3d& from, const Vector3d& to) {
    append(scene_->cube_edges(), from, to);
  });
}

void PictureCanvas::ball(const Vector3d& centre, double radius, const Colour& colour) {
  auto ball = mrpt::opengl::CSphere::Create(static_cast<float>(radius), kSlices);
  ball->setLocation(centre.x(), centre.y(), centre.z());
  scene_->insert(ball, colour);
}

void PictureCanvas::disc(const ldm::Pose& T_world_disc, double radius, const Colour& colour) {
  const auto r = static_cast<float>(radius);
  auto disc = mrpt::opengl::CCylinder::Create(r, r, 0.1F * r, kSlices);
  disc->setPose(mrpt_pose(T_world_disc));
  scene_->insert(disc, colour);
}

void PictureCanvas::arrow(const Vector3d& from, const Vector3d& to, double radius,
                          const Colour& colour) {
  const double length = (to - from).norm();
  if (length == 0) return;
  const double head = std::min(3 * radius / length, 0.6);
  auto arrow =
      mrpt::opengl::CArrow::Create(mrpt_point(from), mrpt_point(to), static_cast<float>(head),
                                   static_cast<float>(0.3 * radius), static_cast<float>(radius));
  arrow->setSlicesCount(kSlices);
  scene_->insert(arrow, colour);
}

void PictureCanvas::square(const Vector3d& centre, double edge, const Colour& colour) {
  const double h = edge / 2;
  const auto corner = [&](double x, double y) { return mrpt_point(centre + Vector3d(x, y, 0)); };
  for (mrpt::opengl::TTriangle half :
       {mrpt::opengl::TTriangle(corner(-h, -h), corner(h, -h), corner(h, h)),
        mrpt::opengl::TTriangle(corner(-h, -h), corner(h, h), corner(-h, h))}) {
    half.setColor(mrpt_colour(colour));
    scene_->squares().insertTriangle(half);
  }
}

void PictureCanvas::dot(const Vector3d& at, const Colour& colour) {
  const mrpt::math::TPoint3Df p = mrpt_point(at);
  scene_->dots(colour).insertPoint(p.x, p.y, p.z);
}

void PictureCanvas::line(const Vector3d& from, const Vector3d& to, const Colour& colour) {
  append(scene_->lines(colour), from, to);
}

void PictureCanvas::box(const Eigen::AlignedBox3d& box, const Colour& colour) {
  for_each_edge(box, [&](const Vector3d& from, const Vector3d& to) { line(from, to, colour); });
}

double PictureCanvas::width(const std::string& text, double size) const {
  mrpt::opengl::CText measured(text);
  measured.setFont(kFont, 1);
  return size * measured.computeTextExtension().first;  // MRPT measures in heights of the font
}

void PictureCanvas::words(const Vector2d& at, double size, const std::string& text, Align align,
                          const Colour& colour) {
  const double shift = align == Align::kLeft ? 0 : align == Align::kCentre ? 0.5 : 1;
  // MRPT counts from the lower left corner, and takes less than one pixel for a share of the image.
  const Vector2d begin =
      fine_ * Vector2d(at.x() - shift * width(text, size), Picture::kHeight - at.y());
  if ((begin.array() < 1).any()) return;
  mrpt::opengl::TFontParams font;
  font.vfont_name = kFont;
  font.vfont_scale = static_cast<float>(size * fine_);
  font.color = mrpt::img::TColorf(mrpt_colour(colour));
  scene_->add_text(begin, text, font);
  mrpt::opengl::TFontParams halo = font;  // stays behind what was drawn before in the same plane
  halo.color = {1.0F, 1.0F, 1.0F};
  for (const double x : {-kHalo, 0.0, kHalo}) {
    for (const double y : {-kHalo, 0.0, kHalo})
      scene_->add_text(begin + Vector2d(x, y), text, halo);
  }
}

void PictureCanvas::write_png(datasets::PartialFile& file) {
  save_png(scene_->draw(camera_), file);
}

std::vector<std::uint8_t> PictureCanvas::pixels() {
  const CImage image = scene_->draw(camera_);
  std::vector<std::uint8_t> result;
  result.reserve(3 * image.getWidth() * image.getHeight());
  for (unsigned row = 0; row < image.getHeight(); ++row) {
    const auto* bgr = image.ptrLine<std::uint8_t>(row);
    for (std::size_t i = 0; i < 3 * image.getWidth(); i += 3) {
      result.insert(result.end(), {bgr[i + 2], bgr[i + 1], bgr[i]});
    }
  }
  return result;
}

std::shared_ptr<mrpt::opengl::COpenGLScene> PictureCanvas::take_scene() {
  return scene_->take();
}

}  // namespace experiments
