// Pictures have the same bits whether the rays of many samples are traced together or alone: of ordinary cameras and
// lens sheets, in every order of pixels, with each method of antialiasing, with objects that bundles ask one by one.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "camera/lenticular.h"
#include "camera/projected.h"
#include "core/render/frame.h"
#include "core/trace/plain_shadow_tester.h"
#include "shadow/pixel_orders.h"
#include "shadow/tester_factory.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::core::test {
namespace {

constexpr std::uint32_t kWidth = 150, kHeight = 70;

const char* const kBundleScenes[] = {
    R"(
    #for (I, 0, 5) #for (J, 0, 5) sphere { <I - 2.5, J - 2.5, mod(I + J, 3)>, 0.45 pigment { rgb
    <I / 5, J / 5, 0.5> } finish { reflection 0.3 } } triangle { <I - 3, J - 3, 3>, <I - 2, J - 3,
    3>, <I - 3, J - 2, 3.5> pigment { rgb 0.7 } } polygon { 5, <I - 3, J - 3, 4>, <I - 2.2, J - 3,
    4>, <I - 2.2, J - 2.2, 4>, <I - 3, J - 2.2, 4>, <I - 3, J - 3, 4> pigment { rgb <1, 0.5, 0.2>
    } } #end #end plane { y, -3 pigment { checker rgb 1 rgb 0.3 } })",
    R"(
    difference { box { -1, 1 } sphere { <0, 0, -1>, 0.8 } pigment { rgb <0.9, 0.3, 0.2> } rotate
    20*y } torus { 1.5, 0.3 rotate 70*x pigment { rgb <0.2, 0.4, 0.9> } } cylinder { <-3, -1, 1>,
    <3, 2, 1>, 0.2 pigment { rgbt <0.3, 0.9, 0.4, 0.4> } interior { ior 1.3 } } merge { sphere {
    <2, -1, 0>, 0.6 } sphere { <2.5, -1, 0>, 0.6 } pigment { rgb 0.8 } } sphere { <-2, 1, -1>, 0.7
    no_image pigment { rgb 0.5 } } plane { z, 6 pigment { checker rgb 0.8 rgb <0.3, 0.3, 0.6> } }
    polygon { 8, <-3, -2, -1>, <-1, -2, -1>, <-1, -1, -1>, <-1.6, -1.4, -1>, <-2, -1, -1>, <-2.5,
    -1.6, -1>, <-3, -1, -1>, <-3, -2, -1> pigment { rgb <0.9, 0.8, 0.1> } })"};

constexpr const char* kBundleStage =
    "background { rgb <0.2, 0.3, 0.5> } light_source { <-4, 6, -5>, rgb 0.8 } ";

/// Keeps what it gets.
struct Kept final : BandSink {
  void put(const Image& band, std::uint32_t) override {
    for (std::uint32_t row = 0; row < band.height; ++row) {
      for (std::uint32_t k = 0; k < band.width; ++k) {
        const float* p = band.pixel(k, row);
        values.insert(values.end(), p, p + 4);
      }
    }
  }
  std::vector<float> values;
};

std::vector<float> bundle_picture(const Scene& scene, const RaySource& camera,
                                  const camera::LensSheet* sheet, std::string_view order,
                                  const Antialiasing& antialiasing, bool bundles) {
  FrameOptions options;
  options.antialiasing = antialiasing;
  options.threads = 2;
  options.bundles = bundles;
  FrameShape shape;
  shape.width = kWidth;
  shape.height = kHeight;
  shape.band_height = 33;
  const FilmColumns columns = traced_columns(camera, shape, options);
  const auto orders =
      shadow::make_band_orders(order, {columns.left, columns.right}, sheet, nullptr);
  const auto shadows = shadow::make_tester_factory("off");
  Kept kept;
  render_frame(scene, camera, shape, *orders, *shadows, options, kept, nullptr);
  return kept.values;
}

std::vector<std::unique_ptr<camera::Camera>> bundle_cameras() {
  std::vector<std::unique_ptr<camera::Camera>> all;
  camera::Projection projection;
  projection.location = {0.2, 0.4, -7};
  projection.direction = {0, 0, 1};
  projection.right = {1.6, 0, 0};
  projection.up = {0, 0.8, 0};
  for (const camera::ProjectedKind kind :
       {camera::ProjectedKind::kPerspective, camera::ProjectedKind::kOrthographic}) {
    all.push_back(std::make_unique<camera::Projected>(kind, projection, camera::ProjectedAngles{},
                                                      kWidth, kHeight));
  }
  for (const double distance : {Bounds::kInf, 300.0}) {
    camera::LensParameters lens;
    lens.pixels = 15;
    lens.view_distance = distance;
    camera::SheetPlacement place;
    place.width = 8;
    place.height = 4;
    place.front = 6;
    all.push_back(std::make_unique<camera::Lenticular>(lens, place, kWidth, kHeight));
  }
  return all;
}

/// None, then each method.
std::vector<Antialiasing> bundle_antialiasing() {
  using enum AntialiasingMethod;
  std::vector<Antialiasing> all;
  for (const auto method : {kPlain, kCentres, kCorners, kSpread, kGrid}) {
    Antialiasing& each = all.emplace_back();
    each.method = method;
    each.threshold = 0.1;
    each.depth = 2;
    each.jitter = method == kCorners ? 1.0 : 0.0;
  }
  return all;
}

TEST(UnitBundlePicture, HasTheBitsOfRaysThatAreTracedAlone) {
  for (const char* text : kBundleScenes) {
    parser::test::SceneText made(std::string(kBundleStage) + text);
    Scene scene(made.build(), {});
    scene.build_light_buffers(1'000'000);
    for (const auto& camera : bundle_cameras()) {
      const auto* lens = dynamic_cast<const camera::Lenticular*>(camera.get());
      const camera::LensSheet* sheet = lens ? &lens->sheet() : nullptr;
      for (const Antialiasing& each : bundle_antialiasing()) {
        const std::vector<float> alone = bundle_picture(scene, *camera, sheet, "rows", each, false);
        for (const std::string_view order : shadow::order_names()) {
          if (shadow::follows_shadows(order)) continue;
          SCOPED_TRACE(std::string(camera->name()) + " " + std::string(order) + " method " +
                       std::to_string(static_cast<int>(each.method)));
          EXPECT_TRUE(bundle_picture(scene, *camera, sheet, order, each, true) == alone);
        }
      }
    }
  }
}

}  // namespace
}  // namespace lentray::core::test
