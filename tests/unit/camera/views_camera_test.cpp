// Views of lens sheets: which column of a lens a view has, the rays of views of any size, quilts.
#include <gtest/gtest.h>
#include <array>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "camera/lenticular.h"
#include "camera/sheet_views.h"
#include "camera/thick_lenticular.h"

namespace lentray::camera {
namespace {

using core::Ray;
using core::Vec3;

SheetPlacement views_placement() {
  SheetPlacement place;
  place.centre = {0.5, -0.25, 2.0};
  place.width = 6.0;
  place.height = 4.0;
  place.front = 1.0;
  return place;
}

LensParameters views_lens(double pixels, double distance, LensModel model) {
  LensParameters lens;
  lens.pixels = pixels;
  lens.view_distance = distance;
  lens.model = model;
  lens.rays = 4;
  return lens;
}

std::unique_ptr<Lenticular> views_sheet(const LensParameters& lens, std::uint32_t width,
                                        std::uint32_t height) {
  if (lens.model == LensModel::kThick)
    return std::make_unique<ThickLenticular>(lens, views_placement(), width, height);
  return std::make_unique<Lenticular>(lens, views_placement(), width, height);
}

TEST(UnitViewsCamera, ColumnsOfWholeLenses) {
  for (std::uint32_t n = 1; n <= 20; ++n) {
    for (std::uint32_t j = 0; j < n; ++j) {
      for (const std::int64_t lens : {-3, 0, 1, 7, 100'003})
        EXPECT_EQ(view_column(n, j, n, lens), lens * n + j);
    }
  }
}

/// By looking at every column of the lens.
TEST(UnitViewsCamera, ColumnsOfOtherLensesAreTheNearest) {
  for (const double n : {1.0, 1.5, 2.75, 7.37, 12.5, 15.0, 20.01}) {
    for (const std::uint32_t views : {1u, 2u, 7u, 12u, 31u}) {
      for (std::int64_t lens = 0; lens < 60; ++lens) {
        for (std::uint32_t j = 0; j < views; ++j) {
          const double wanted = (j + 0.5) / views - 0.5;
          double least = 1e9;
          for (std::int64_t k = static_cast<std::int64_t>((lens - 1) * n); k < (lens + 2) * n;
               ++k) {
            const double cell = std::floor((k + 0.5) / n);
            if (cell != lens) continue;
            least = std::min(least, std::fabs((k + 0.5) / n - cell - 0.5 - wanted));
          }
          const std::int64_t got = view_column(n, j, views, lens);
          ASSERT_EQ(std::floor((got + 0.5) / n), lens) << n << " " << views << " " << j;
          EXPECT_NEAR(std::fabs((got + 0.5) / n - lens - 0.5 - wanted), least, 1e-9)
              << n << " " << views << " " << j << " " << lens;
        }
      }
    }
  }
}

TEST(UnitViewsCamera, ALastLensThatIsCutLacksViews) {
  const LensSheet whole(views_lens(5.0, 400.0, LensModel::kParaxial), 12);  // 2.4 lenses
  EXPECT_EQ(view_width(whole, 1, 5), 3u);
  EXPECT_EQ(view_width(whole, 2, 5), 2u);
  const LensSheet part(views_lens(2.5, 400.0, LensModel::kParaxial), 6);  // 2.4 lenses
  EXPECT_EQ(usual_views(part), 2u);
  EXPECT_EQ(view_width(part, 0, 2), 3u);
  EXPECT_EQ(view_width(part, 1, 2), 2u);
}

/// With as many columns as lenses and as many views as pixels, a sized view has the rays of the
/// sheet.
TEST(UnitViewsCamera, SizedViewsMeetTheSheet) {
  constexpr double kInf = LensParameters::kInfinity;
  for (const auto& lens :
       {views_lens(5.0, 300.0, LensModel::kParaxial), views_lens(5.0, kInf, LensModel::kPinhole),
        views_lens(5.0, 300.0, LensModel::kPinhole), views_lens(5.0, kInf, LensModel::kThick),
        views_lens(5.0, 300.0, LensModel::kThick)}) {
    const auto sheet = views_sheet(lens, 60, 9);
    for (std::uint32_t view = 0; view < 5; ++view) {
      const SheetView strip(*sheet, view);
      const SizedView sized(*sheet, view, 5, 12, 9);
      ASSERT_EQ(sized.rays_a_place(), strip.rays_a_place());
      for (std::uint32_t i = 0; i < 12; ++i) {
        for (std::uint32_t ray = 0; ray < sized.rays_a_place(); ++ray) {
          Ray a, b;
          core::PixelPlace place;
          place.column = static_cast<std::int32_t>(i);
          place.row = static_cast<std::int32_t>(i % 9);
          place.across = 0.2;
          place.down = -0.3;
          const core::EyePlace at = strip.eye_place(i, i % 9);
          const bool shown = strip.one_ray_at(place, strip.ray_of(at, ray), a);
          ASSERT_EQ(sized.one_ray_at(place, strip.ray_of(at, ray), b), shown);
          if (!shown) continue;
          EXPECT_LT(core::length(a.origin - b.origin), 1e-12);
          EXPECT_LT(core::length(a.direction - b.direction), 1e-12);
        }
      }
    }
  }
}

/// A thick lens's rays lie in the row of the view's own pixel, however high the sheet's rows are.
TEST(UnitViewsCamera, RaysOfThickLensesStayInTheirRow) {
  const auto sheet = views_sheet(views_lens(5.0, 300.0, LensModel::kThick), 60, 9);
  const SizedView view(*sheet, 2, 5, 24, 36);
  for (const double down : {-0.5, 0.2}) {
    Ray a, b;
    ASSERT_TRUE(view.one_ray_at({.column = 7, .row = 14}, {1, {0.1, down}}, a));
    ASSERT_TRUE(view.one_ray_at({.column = 7, .row = 14, .down = down}, {1, {0.1, 0.0}}, b));
    EXPECT_LT(core::length(a.origin - b.origin), 1e-12);
    EXPECT_LT(core::length(a.direction - b.direction), 1e-12);
  }
}

/// Paraxial from a finite distance: all rays of a view run from its eye to the pixel's place in the
/// sheet.
TEST(UnitViewsCamera, AParaxialViewIsThePictureOfItsEye) {
  const LensParameters lens = views_lens(7.37, 350.0, LensModel::kParaxial);
  const auto sheet = views_sheet(lens, 100, 30);
  for (const std::uint32_t views : {4u, 7u}) {
    for (std::uint32_t j = 0; j < views; ++j) {
      const SizedView view(*sheet, j, views, 40, 25);
      const double e = ((j + 0.5) / views - 0.5) * lens.print_pitch(), s = sheet->scale();
      EXPECT_NEAR(view.print_offset(), e, 1e-15);
      const Vec3 middle = views_placement().centre;
      const Vec3 eye = middle + Vec3(-350.0 * 1.6 * e / 3.03 * s, 0.0, -350.0 * s);
      for (const double column : {0.0, 0.5, 13.3, 39.5, 40.0}) {
        for (const double row : {0.5, 11.9, 24.5}) {
          Ray ray;
          ASSERT_TRUE(view.ray(column, row, ray));
          const Vec3 at = middle + Vec3((column / 40.0 - 0.5) * 6.0, (0.5 - row / 25.0) * 4.0, 0.0);
          const Vec3 wanted = core::normalized(at - eye);
          EXPECT_LT(core::length(ray.direction - wanted), 1e-12);
          EXPECT_LT(core::length(core::cross(ray.origin - eye, wanted)), 1e-11);
        }
      }
    }
  }
}

TEST(UnitViewsCamera, ViewsKnowTheirSheet) {
  const auto sheet = views_sheet(views_lens(5.0, 300.0, LensModel::kParaxial), 60, 9);
  const auto number = [](const Camera& camera, std::string_view name) {
    for (const auto& [key, value] : camera.describe()) {
      if (key == name) return std::get<double>(value);
    }
    return -1.0;
  };
  EXPECT_EQ(number(SheetView(*sheet, 3), "lens.view"), 3.0);
  EXPECT_EQ(number(SheetView(*sheet, 3), "lens.view_count"), 5.0);
  const SizedView sized(*sheet, 1, 8, 30, 9);
  EXPECT_EQ(number(sized, "lens.view"), 1.0);
  EXPECT_EQ(number(sized, "lens.view_count"), 8.0);
  EXPECT_EQ(number(sized, "lens.pixels"), 5.0);
  EXPECT_EQ(sized.width(), 30u);
  EXPECT_EQ(sized.name(), "lenticular");
}

TEST(UnitViewsCamera, QuiltsHaveTheirTilesFromLowerLeft) {
  const auto sheet = views_sheet(views_lens(6.0, 300.0, LensModel::kParaxial), 60, 8);
  std::vector<std::shared_ptr<const Camera>> tiles;
  for (std::uint32_t i = 0; i < 6; ++i) tiles.push_back(make_view(*sheet, 5 - i, 6, 10, 8));
  const Quilt quilt(tiles, 3, {});
  EXPECT_EQ(quilt.width(), 30u);
  EXPECT_EQ(quilt.height(), 16u);
  for (std::uint32_t tile = 0; tile < 6; ++tile) {
    const double left = tile % 3 * 10.0, top = (1 - tile / 3) * 8.0;
    for (const double column : {0.5, 3.25, 9.5}) {
      Ray a, b;
      ASSERT_TRUE(quilt.ray(left + column, top + 5.5, a));
      ASSERT_TRUE(tiles[tile]->ray_at(
          {static_cast<std::int32_t>(column), 5, column - std::floor(column) - 0.5}, b));
      EXPECT_EQ(core::length(a.origin - b.origin), 0.0);
      EXPECT_EQ(core::length(a.direction - b.direction), 0.0);
    }
    // What lies beyond the tile's left edge.
    Ray a, b;
    const auto lattice = quilt.lattice(30);
    ASSERT_TRUE(quilt.ray_at({lattice.left[tile % 3 * 10], static_cast<std::int32_t>(top)}, a));
    ASSERT_TRUE(tiles[tile]->ray_at({-1, 0}, b));
    EXPECT_EQ(core::length(a.origin - b.origin), 0.0);
    EXPECT_EQ(core::length(a.direction - b.direction), 0.0);
  }
  EXPECT_EQ(quilt.lattice(30).tiles, (std::vector<std::uint32_t>{0, 10, 20, 30}));
}

TEST(UnitViewsCamera, TheConeReachesFromTheFirstToTheLastCamera) {
  for (const double distance : {LensParameters::kInfinity, 250.0}) {
    const LensParameters lens = lens_of_cone(35.0, 48, 1.124, distance);
    const double last = (47.5 / 48.0 - 0.5) * lens.print_pitch();
    EXPECT_NEAR(lens.ior * last / lens.focal_length, std::tan(17.5 * std::numbers::pi / 180.0),
                1e-12);
    EXPECT_EQ(complaint(lens), "");
  }
}

}  // namespace
}  // namespace lentray::camera
