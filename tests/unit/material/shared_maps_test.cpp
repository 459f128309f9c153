// Objects that move a nested pigment, normal, texture or density share all but its place.
#include <string>

#include "core/base/memory_stages.h"
#include "tests/unit/parser/scene_text.h"

namespace lentray::parser::test {
namespace {

constexpr const char* kNested =
    "#macro Pigment(Depth) bozo pigment_map {"
    "  #if (Depth > 0) [0 Pigment(Depth - 1) scale .6] [1 Pigment(Depth - 1)]"
    "  #else [0 rgb 0] [1 rgb 1] #end } #end "
    "#macro Normal(Depth) wood normal_map {"
    "  #if (Depth > 0) [0 Normal(Depth - 1) scale .6] [1 Normal(Depth - 1)]"
    "  #else [0 bumps 1] [1 dents .5] #end } #end "
    "#macro Texture(Depth) #if (Depth > 0) radial texture_map {"
    "    [0 Texture(Depth - 1) scale .6] [1 Texture(Depth - 1)] } rotate x*20"
    "  #else pigment { wood } normal { bumps .2 } #end #end "
    "#macro Density(Depth) boxed density_map {"
    "  #if (Depth > 0) [0 Density(Depth - 1) scale .6] [1 Density(Depth - 1)]"
    "  #else [0 rgb 0] [1 rgb 1] #end } #end ";

/// What is on the heap once the scene is compiled: `looks` on boxes that are moved.
std::uint64_t bytes_of(int boxes, const std::string& looks, const std::string& before) {
  SceneText text(std::string(kNested) + before + " #declare I = 0; #while (I < " +
                 std::to_string(boxes) + ") box { 0, 1 " + looks +
                 " translate <I, I*I, 1> } #declare I = I + 1; #end");
  const std::uint64_t before_building = core::heap_bytes();
  const core::SceneParts parts = text.build();
  EXPECT_EQ(parts.objects.size(), static_cast<std::size_t>(boxes));
  return core::heap_bytes_since(before_building);
}

struct SharedLooks {
  const char* name;
  const char* looks;
  const char* before;
};

class UnitSharedMaps : public ::testing::TestWithParam<SharedLooks> {};

TEST_P(UnitSharedMaps, AnotherObjectTakesLittle) {
  // A tree of 256 ends takes ten times as much, even of the smallest parts.
  constexpr int kFew = 10, kMany = 74;
  constexpr double kMostAnObject = 4096.0;
  const auto [name, looks, before] = GetParam();
  const std::uint64_t few = bytes_of(kFew, looks, before), many = bytes_of(kMany, looks, before);
  EXPECT_GT(few, 0u);
  EXPECT_LT((static_cast<double>(many) - static_cast<double>(few)) / (kMany - kFew), kMostAnObject);
}

constexpr SharedLooks kSharedLooks[] = {
    {"pigment", "texture { T }", "#declare T = texture { pigment { Pigment(7) } }"},
    {"pigment_scaled", "pigment { P scale 1 + I }", "#declare P = pigment { Pigment(7) }"},
    {"layers", "texture { pigment { P rotate x*I } } texture { pigment { P translate I } }",
     "#declare P = pigment { Pigment(7) }"},
    {"average", "texture { T }",
     "#declare T = texture { pigment { average pigment_map { [1 Pigment(6)] [2 Pigment(6)] } } }"},
    {"uv", "texture { T }", "#declare T = texture { pigment { uv_mapping Pigment(7) } }"},
    {"pigment_pattern", "texture { T }",
     "#declare T = texture { pigment { pigment_pattern { Pigment(7) } } }"},
    {"normal", "pigment { rgb 1 } normal { N }", "#declare N = normal { Normal(7) }"},
    {"normal_average", "pigment { rgb 1 } normal { N }",
     "#declare N = normal { average normal_map { [1 Normal(6)] [1 Normal(6)] } }"},
    {"texture", "texture { T }", "#declare T = texture { Texture(7) }"},
    {"texture_turned", "texture { T rotate y*I scale 2 }", "#declare T = texture { Texture(7) }"},
    {"texture_average", "texture { T }",
     "#declare T = texture { average texture_map { [1 Texture(6)] [1 Texture(6)] } }"},
    {"texture_uv", "texture { T }", "#declare T = texture { uv_mapping Texture(7) }"},
    {"map_around", "texture { checker texture { T scale 1 + I } texture { T } rotate y*I }",
     "#declare T = texture { Texture(7) }"},
    {"interior_texture", "texture { pigment { rgb 1 } } interior_texture { T }",
     "#declare T = texture { Texture(7) }"},
    {"density", "pigment { rgbt 1 } interior { M } hollow",
     "#declare M = interior { media { density { Density(7) } } }"},
};

std::string shared_looks_name(const ::testing::TestParamInfo<SharedLooks>& info) {
  return info.param.name;
}
INSTANTIATE_TEST_SUITE_P(, UnitSharedMaps, ::testing::ValuesIn(kSharedLooks), shared_looks_name);

}  // namespace
}  // namespace lentray::parser::test
