// Every kind of shape, alone, in CSG and cut, under two lights and in a mirror: with the hierarchy,
// light buffers and the specialised tracer the same bits as without any of them.
#include <bit>

#include "core/trace/integrator.h"
#include "core/trace/thread_context.h"
#include "shadow/tester_factory.h"
#include "tests/unit/parser/scene_text.h"
#include "tests/unit/shape/shape_cases_of_many.h"

namespace lentray::parser::test {
namespace {

struct Way {
  const char* name;
  core::CompileOptions options;
  std::uint64_t light_buffer_rays = 0;
};

std::vector<core::Radiance> shape_identical_picture(const std::string& sdl, const Way& way,
                                                    int width, int height) {
  SceneText text(sdl, with_fonts());
  core::Scene scene(text.build(), way.options);
  if (way.light_buffer_rays > 0) scene.build_light_buffers(way.light_buffer_rays);
  core::ThreadContext context(scene, false);
  const auto tester = shadow::make_tester_factory("off")->make(context);
  core::Integrator integrator(context, *tester);
  std::vector<core::Radiance> seen;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3 along{(x + 0.5) / width - 0.5, -0.55 - ((y + 0.5) / height - 0.5) * 0.7, 1.0};
      seen.push_back(integrator.trace({{0.3, 7.0, -11.0}, core::normalized(along)}, {}));
    }
  }
  return seen;
}

bool shape_identical_same(const core::Radiance& a, const core::Radiance& b) {
  const auto equal = [](float x, float y) {
    return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
  };
  return equal(a.rgb.r, b.rgb.r) && equal(a.rgb.g, b.rgb.g) && equal(a.rgb.b, b.rgb.b) &&
         equal(a.transmit, b.transmit);
}

class UnitShapeIdentical : public ::testing::TestWithParam<ShapeCase> {};

TEST_P(UnitShapeIdentical, WithEveryOptimisationAndWithNone) {
  const std::string shape = std::string("object { ") + GetParam().sdl;
  std::string sdl =
      "light_source { <-7,12,-9>, 1 } light_source { <9,8,3>, <.5,.4,.3> }"
      "plane { y, -2.5 pigment { checker rgb 1 rgb .5 } finish { reflection .3 } }"
      "#default { pigment { rgb <.8,.6,.3> } finish { specular .4 } }";
  for (int i = 0; i < 3; ++i) {
    sdl +=
        shape + " " + kPlacings[i].sdl + " translate <" + std::to_string(i * 3 - 3) + ",0,0> }\n";
  }
  sdl += "difference { " + shape +
         " translate <-3,0,-4> } sphere { <-2.6,.6,-4.4>, .8 } }\n"
         "union { " +
         shape +
         " scale .5 } box { <-.2,-1,.3>, .6 } pigment { rgbf <.7,.9,1,.6> }"
         " clipped_by { plane { y, .7 } } translate <2,0,-4> }\n";
  const bool slow = GetParam().surface != nullptr;
  const int width = slow ? 10 : 60, height = slow ? 7 : 40;
  core::CompileOptions grid, none;
  grid.accelerator = core::Accelerator::kGrid;
  none.accelerator = core::Accelerator::kList;
  none.general_path = true;
  const auto expected = shape_identical_picture(sdl, {"none", none}, width, height);
  for (const Way& way :
       {Way{"all", {}, 2400}, Way{"without light buffers", {}}, Way{"grid", grid}}) {
    const auto seen = shape_identical_picture(sdl, way, width, height);
    std::size_t different = 0;
    for (std::size_t i = 0; i < seen.size(); ++i)
      different += !shape_identical_same(seen[i], expected[i]);
    EXPECT_EQ(different, 0u) << way.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, UnitShapeIdentical, ::testing::ValuesIn(kShapeCases),
                         [](const auto& one) { return std::string(one.param.name); });

INSTANTIATE_TEST_SUITE_P(OfMany, UnitShapeIdentical, ::testing::ValuesIn(shapes_of_many()),
                         [](const auto& one) { return std::string(one.param.name); });

}  // namespace
}  // namespace lentray::parser::test
