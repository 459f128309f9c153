#include "shadow/hit_model/paper_test.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "camera/lenticular.h"
#include "core/material/pigments.h"
#include "core/object/leaf.h"
#include "core/render/frame.h"
#include "core/shape/box.h"
#include "core/shape/polygon.h"
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
  core::Attributes attributes;
  attributes.texture = texture;
  attributes.no_image = no_image;
  leaf->set_attributes(attributes);
  return leaf;
}

std::unique_ptr<core::Scene> make_scene(const PaperSheet& sheet, const Enumeration& shadow,
                                        double distance) {
  core::SceneParts parts;
  core::TextureLayer white;
  white.pigment = core::make_plain_pigment({core::Rgb(1.0f), 0, 0});
  white.finish = std::make_shared<core::Finish>();
  parts.textures.push_back(std::make_shared<core::LayeredTexture>(std::vector{white}));
  const core::Texture* texture = parts.textures.front().get();

  double reach = 0.5 * sheet.height();
  for (std::uint32_t k = 0; k < sheet.width(); ++k) {
    reach = std::max(reach, std::fabs(sheet.column_place(k, distance)));
  }
  reach += kMargin;
  parts.objects.push_back(
      object_of(std::make_unique<core::Polygon>(std::vector<Vec3>{{-reach, -reach, distance},
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

/// A camera's picture from a column and a row on.
class Window final : public core::RaySource {
 public:
  Window(const core::RaySource& camera, std::uint32_t left, std::uint32_t top)
      : m_camera(camera), m_left(left), m_top(top) {}
  bool ray(double column, double row, core::Ray& ray) const override {
    return m_camera.ray(column + m_left, row + m_top, ray);
  }

 private:
  const core::RaySource& m_camera;
  const std::uint32_t m_left, m_top;
};

/// Orders of the sheet's columns for the window's.
class WindowOrders final : public core::BandOrders {
 public:
  using Make = std::function<std::unique_ptr<core::PixelOrder>(std::uint32_t, std::uint32_t)>;
  WindowOrders(Make make, std::uint32_t left) : m_make(std::move(make)), m_left(left) {}
  std::unique_ptr<core::PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    return std::make_unique<Moved>(m_make(top, bottom), m_left);
  }

 private:
  class Moved final : public core::PixelOrder {
   public:
    Moved(std::unique_ptr<core::PixelOrder> order, std::uint32_t left)
        : m_order(std::move(order)), m_left(left) {}
    std::size_t jobs() const override { return m_order->jobs(); }
    void pixels(std::size_t job, std::vector<core::Pixel>& out) const override {
      m_order->pixels(job, out);
      for (core::Pixel& p : out) p.column -= m_left;
    }

   private:
    const std::unique_ptr<core::PixelOrder> m_order;
    const std::uint32_t m_left;
  };

  const Make m_make;
  const std::uint32_t m_left;
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

PaperTest::Part PaperTest::rendered(std::uint32_t group) const {
  const auto blocked = [](const std::vector<Enumeration::Ray>& rays) {
    const auto is = [](Enumeration::Ray r) { return r == Enumeration::kBlocked; };
    const auto first = std::find_if(rays.begin(), rays.end(), is) - rays.begin();
    const auto end = rays.rend() - std::find_if(rays.rbegin(), rays.rend(), is);
    return Strip{static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
  };
  Part part{0, m_sheet.width(), 0, std::min(group, m_sheet.rows())};
  const Strip rows = blocked(m_shadow.rows()), columns = blocked(m_shadow.columns());
  if (rows.end > 0) {
    // Whole groups, so that strips are cut as in the whole picture.
    part.top = (rows.begin > 0 ? rows.begin - 1 : 0) / group * group;
    const std::uint64_t below = (std::uint64_t{rows.end} / group + 1) * group;
    part.bottom = static_cast<std::uint32_t>(std::min<std::uint64_t>(below, m_sheet.rows()));
  }
  const std::uint32_t n = m_sheet.columns().views();
  if (columns.end > 0 && n > 0) {
    part.left = columns.begin / n * n;
    part.left -= std::min(part.left, n);
    const std::uint64_t beyond = (std::uint64_t{columns.end - 1} / n + 2) * n;
    part.right = static_cast<std::uint32_t>(std::min<std::uint64_t>(beyond, m_sheet.width()));
  }
  return part;
}

Measurement PaperTest::measure(const Style& style, const std::string& cache) const {
  const bool listed = style.is_ideal() &&
                      (style.kind == Style::Kind::kCombined || style.kind == Style::Kind::kStrips);
  const Part part = rendered(std::max(1u, style.height));
  const std::uint32_t width = part.right - part.left, height = part.bottom - part.top;
  const WindowOrders orders(
      [&](std::uint32_t top, std::uint32_t bottom) {
        if (!listed) {
          return make_order(style.name(), {part.left, top, part.right, bottom}, &m_sheet.columns());
        }
        return make_ideal_orders(m_shadow, style.kind, part.left, part.right, part.top)
            ->band(top, bottom);
      },
      part.left);
  const camera::Lenticular camera = camera_of(m_sheet);
  const Window window(camera, part.left, part.top);
  const auto testers = make_tester_factory(cache);
  const RunLog log(*testers);
  NoPicture nowhere;
  core::FrameOptions frame;
  frame.threads = 1;
  const core::Counters counters = core::render_frame(*m_scene, window, {width, height, height},
                                                     orders, log, frame, nowhere, nullptr);
  const LightRuns& runs = log.lights().at(0);
  const auto bright = static_cast<std::uint64_t>(
      std::count_if(m_shadow.columns().begin() + part.left, m_shadow.columns().begin() + part.right,
                    [](Enumeration::Ray r) { return r != Enumeration::kNone; }));
  if (runs.rays != bright * height) {
    throw std::logic_error("the paper's test: not every pixel cast a shadow ray");
  }
  return {runs.longest, runs.rays, runs.blocked, counters.lights.at(0).hits};
}

}  // namespace lentray::shadow
