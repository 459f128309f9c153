#include "shadow/hit_model/paper_test.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "camera/lenticular.h"
#include "core/geometry/box.h"
#include "core/geometry/polygon.h"
#include "core/material/pigments.h"
#include "core/render/frame.h"
#include "shadow/hit_model/ideal_orders.h"
#include "shadow/pixel_orders.h"
#include "shadow/run_log.h"
#include "shadow/tester_factory.h"

namespace lentray::shadow {
namespace {

using core::Vec3;

constexpr double kGap = 1.0;      ///< mm between the square and what casts the shadow
constexpr double kThin = 0.1;     ///< mm, how thick that is
constexpr double kFront = 2.0;    ///< mm before the sheet, where rays start
constexpr double kMargin = 10.0;  ///< mm that the square is larger than what the sheet sees

std::unique_ptr<core::Object> object_of(std::unique_ptr<core::Shape> shape,
                                        const core::Texture* texture, bool no_image) {
  auto leaf = std::make_unique<core::Leaf>(std::move(shape), core::Transform());
  core::Attributes looks;
  looks.texture = texture;
  looks.no_image = no_image;
  leaf->set_attributes(looks);
  return leaf;
}

std::unique_ptr<core::Scene> make_scene(const PaperSheet& sheet, const Enumeration& shadow,
                                        double distance) {
  core::SceneParts parts;
  core::TextureLayer white;
  white.pigment = core::make_plain_pigment({core::Rgb(1.0f), 0, 0});
  parts.textures.push_back(std::make_shared<core::LayeredTexture>(std::vector{white}));
  const core::Texture* texture = parts.textures.front().get();

  double reach = 0.5 * sheet.height();
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    reach = std::max(reach, std::fabs(sheet.column_place(k, distance)));
  }
  reach += kMargin;
  parts.objects.push_back(object_of(
      std::make_unique<core::Polygon>(std::vector<Vec3>{{-reach, -reach, distance},
                                                        {reach, -reach, distance},
                                                        {reach, reach, distance},
                                                        {-reach, reach, distance},
                                                        {-reach, -reach, distance}}),
      texture, false));
  // A thin box, for polygons cannot be as small as shadows can.
  parts.objects.push_back(object_of(
      std::make_unique<core::Box>(Vec3{shadow.left(), -shadow.bottom(), distance - kGap - kThin},
                                  Vec3{shadow.right(), -shadow.top(), distance - kGap}),
      texture, true));
  core::Light sun;
  sun.parallel = true;
  sun.position = {0.0, 0.0, -100.0};
  sun.point_at = {0.0, 0.0, 0.0};
  sun.direction = {0.0, 0.0, 1.0};
  sun.colour = core::Rgb(1.0f);
  parts.lights.push_back(sun);
  return std::make_unique<core::Scene>(std::move(parts), core::CompileOptions{});
}

/// The rows of a camera from `top` on.
class RowWindow final : public core::RaySource {
 public:
  RowWindow(const core::RaySource& camera, std::uint32_t top) : m_camera(camera), m_top(top) {}
  bool ray(double column, double row, core::Ray& ray) const override {
    return m_camera.ray(column, row + m_top, ray);
  }

 private:
  const core::RaySource& m_camera;
  const std::uint32_t m_top;
};

struct NoPicture final : core::BandSink {
  void put(const core::Image&, std::uint32_t) override {}
};

camera::Lenticular camera_of(const PaperSheet& sheet) {
  camera::SheetPlacement place;
  place.width = sheet.columns().sheet_width();
  place.height = sheet.height();
  place.front = kFront;
  return {sheet.lens(), place, sheet.width(), sheet.rows()};
}

}  // namespace

PaperTest::PaperTest(const PaperSheet& sheet, const Enumeration& shadow, double distance)
    : m_sheet(sheet), m_shadow(shadow), m_scene(make_scene(sheet, shadow, distance)) {}

PaperTest::Rows PaperTest::rendered_rows(std::uint32_t group) const {
  const std::vector<Enumeration::Ray>& rows = m_shadow.rows();
  const auto blocked = [](Enumeration::Ray r) { return r == Enumeration::kBlocked; };
  const auto first = std::find_if(rows.begin(), rows.end(), blocked) - rows.begin();
  const auto end = rows.rend() - std::find_if(rows.rbegin(), rows.rend(), blocked);
  if (end == 0) return {0, std::min(group, m_sheet.rows())};
  Rows out;
  // Whole groups, so that strips are cut as in the whole picture.
  const auto above = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(0, first - 1));
  out.top = above / group * group;
  const std::uint64_t below = (static_cast<std::uint64_t>(end) / group + 1) * group;
  out.bottom = static_cast<std::uint32_t>(std::min<std::uint64_t>(below, m_sheet.rows()));
  return out;
}

Measurement PaperTest::measure(const Style& style, const std::string& cache) const {
  const bool listed = style.is_ideal() && (style.kind == Style::Kind::kCombined ||
                                           style.kind == Style::Kind::kStrips);
  const Rows rows = rendered_rows(std::max(1u, style.height));
  const std::uint32_t height = rows.bottom - rows.top;
  const auto orders =
      listed ? make_ideal_orders(m_shadow, style.kind, rows.top)
             : make_band_orders(style.name(), m_sheet.width(), &m_sheet.columns());
  const camera::Lenticular camera = camera_of(m_sheet);
  const RowWindow window(camera, rows.top);
  const auto testers = make_tester_factory(cache);
  const RunLog log(*testers);
  NoPicture nowhere;
  core::FrameOptions frame;
  frame.threads = 1;
  const core::Counters counters =
      core::render_frame(*m_scene, window, {m_sheet.width(), height, height}, *orders, log, frame,
                         nowhere, nullptr);
  const LightRuns& runs = log.lights().at(0);
  const std::uint64_t bright = m_sheet.width() - m_sheet.columns().dark_columns();
  if (runs.rays != bright * height) {
    throw std::logic_error("the paper's test: not every pixel cast a shadow ray");
  }
  return {runs.longest, runs.rays, runs.blocked, counters.lights.at(0).hits};
}

}  // namespace lentray::shadow
