#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"
#include "core/base/memory_limit.h"
#include "core/object/csg.h"
#include "core/object/gated.h"
#include "core/object/leaf.h"
#include "core/scene/explain.h"
#include "core/scene/scene.h"
#include "core/shape/box.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"

using namespace lentray::core;

namespace {

struct OneColour final : Pigment {
  explicit OneColour(const Colour& c) : m_colour(c) {}
  Colour colour(const Vec3&, const SurfaceContext&) const override { return m_colour; }
  bool is_opaque() const override { return m_colour.is_opaque(); }
  const Colour* constant() const override { return &m_colour; }
  Colour m_colour;
};

/// Builds small scenes part by part.
class SceneBuilder {
 public:
  SceneParts parts;

  const Texture* texture(float transmit, const Finish& finish = {}, int layers = 1) {
    std::vector<TextureLayer> stack(static_cast<std::size_t>(layers));
    for (TextureLayer& layer : stack) {
      layer.pigment = std::make_shared<OneColour>(Colour{Rgb(0.5f), 0.0f, transmit});
      layer.finish = std::make_shared<Finish>(finish);
    }
    parts.textures.push_back(std::make_shared<LayeredTexture>(std::move(stack)));
    return parts.textures.back().get();
  }
  const Interior* interior(double ior) {
    auto made = std::make_shared<Interior>();
    made->ior = ior;
    parts.interiors.push_back(made);
    return made.get();
  }
  static std::unique_ptr<Object> leaf(std::unique_ptr<Shape> shape, const Texture* texture,
                                      const Interior* interior = nullptr) {
    auto made = std::make_unique<Leaf>(std::move(shape), Transform());
    Attributes a;
    a.texture = texture;
    a.interior = interior;
    made->set_attributes(a);
    return made;
  }
  static std::unique_ptr<Object> ball(double x, const Texture* texture,
                                      const Interior* interior = nullptr) {
    return leaf(std::make_unique<Sphere>(Vec3{x, 0, 0}, 1.0), texture, interior);
  }
  static std::unique_ptr<Csg> csg(CsgKind kind, std::unique_ptr<Object> a,
                                  std::unique_ptr<Object> b) {
    std::vector<std::unique_ptr<Object>> children;
    children.push_back(std::move(a));
    children.push_back(std::move(b));
    return std::make_unique<Csg>(kind, std::move(children));
  }
  std::unique_ptr<Scene> compile(const CompileOptions& options = {}) {
    return std::make_unique<Scene>(std::move(parts), options);
  }
};

TEST(UnitCoreScene, SmallPicturesOfManyObjectsHaveNoLightBuffers) {
  const auto has_buffer = [](int balls, std::uint64_t pixels) {
    SceneBuilder b;
    const Texture* t = b.texture(0);
    for (int i = 0; i < balls; ++i) b.parts.objects.push_back(b.ball(3.0 * i, t));
    Light light;
    light.position = {1.5 * balls, 2000, 0};
    b.parts.lights.push_back(light);
    const auto scene = b.compile();
    EXPECT_EQ(scene->light_buffer(0), nullptr);
    scene->build_light_buffers(pixels);
    return scene->light_buffer(0) != nullptr;
  };
  EXPECT_TRUE(has_buffer(200, 1000));
  EXPECT_TRUE(has_buffer(1500, 15000));
  EXPECT_FALSE(has_buffer(1500, 14999));
}

TEST(UnitCoreScene, ManyLightsShareTheCellsOfFewAndVeryManyHaveNone) {
  const auto bytes = [](int lights) {
    SceneBuilder b;
    b.parts.objects.push_back(b.ball(0, b.texture(0)));
    Light light;
    for (int i = 0; i < lights; ++i) {
      light.position = {5.0 + i, 20, 0};
      b.parts.lights.push_back(light);
    }
    const auto scene = b.compile();
    scene->build_light_buffers(10'000'000);
    std::size_t sum = 0;
    for (std::size_t i = 0; i < scene->lights().size(); ++i) {
      if (const LightBuffer* buffer = scene->light_buffer(i)) sum += buffer->memory();
    }
    return sum;
  };
  EXPECT_GT(bytes(16), 15 * bytes(1));
  EXPECT_LT(bytes(160), 3 * bytes(16));
  EXPECT_EQ(bytes(600), 0u);
}

TEST(UnitCoreScene, LightBuffersLeaveHalfOfWhatMaxMemoryLeaves) {
  const auto has_buffers = [](double room) {
    SceneBuilder b;
    const Texture* t = b.texture(0);
    for (int i = 0; i < 400; ++i) b.parts.objects.push_back(b.ball(3.0 * i, t));
    Light light;
    for (int i = 0; i < 16; ++i) {
      light.position = {600, 2000, 1.0 * i};
      b.parts.lights.push_back(light);
    }
    const auto scene = b.compile();
    limit_memory(resident_bytes() + room);
    scene->build_light_buffers(10'000'000);
    limit_memory(Bounds::kInf);
    return scene->light_buffer(0) != nullptr;
  };
  EXPECT_TRUE(has_buffers(Bounds::kInf));
  EXPECT_TRUE(has_buffers(1e8));
  EXPECT_FALSE(has_buffers(1e7));
}

TEST(UnitCoreScene, UnionsAreSplitWhereTheirSurfaceIsThatOfTheirParts) {
  SceneBuilder b;
  const Texture* t = b.texture(0);
  b.parts.objects.push_back(b.ball(0, t));
  b.parts.objects.push_back(
      b.csg(CsgKind::kUnion, b.ball(3, t), b.csg(CsgKind::kUnion, b.ball(6, t), b.ball(9, t))));
  b.parts.objects.push_back(b.csg(CsgKind::kMerge, b.ball(12, t), b.ball(12.5, t)));
  auto clipped = b.csg(CsgKind::kUnion, b.ball(15, t), b.ball(18, t));
  clipped->set_clips({b.ball(15, t)});
  b.parts.objects.push_back(std::move(clipped));
  b.parts.objects.push_back(std::make_unique<Gated>(
      b.csg(CsgKind::kUnion, b.ball(21, t), b.ball(24, t)), Object::Regions{b.ball(21, t)}));
  const auto scene = b.compile();
  ASSERT_EQ(scene->objects().size(), 7u);
  const std::vector<double> expected{0, 3, 6, 9};  // scene order is kept
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const auto* leaf = dynamic_cast<const Leaf*>(scene->objects()[i].get());
    ASSERT_NE(leaf, nullptr) << i;
    EXPECT_NEAR(leaf->bounds().centre().x, expected[i], 1e-9);
  }
  EXPECT_EQ(scene->needs().primitives.at("sphere"), 10u);
  EXPECT_TRUE(scene->needs().csg);
  EXPECT_TRUE(scene->needs().clipping);
}

TEST(UnitCoreScene, OpacityLooksAtEveryTexture) {
  SceneBuilder b;
  const Texture *solid = b.texture(0), *glass = b.texture(0.5f);
  b.parts.objects.push_back(b.ball(0, solid));
  b.parts.objects.push_back(b.ball(3, glass));
  b.parts.objects.push_back(b.csg(CsgKind::kIntersection, b.ball(6, solid), b.ball(6.5, glass)));
  auto lined = b.ball(9, solid);
  Attributes a = lined->attributes();
  a.interior_texture = glass;
  lined->set_attributes(a);
  b.parts.objects.push_back(std::move(lined));
  const auto scene = b.compile();
  EXPECT_TRUE(scene->objects()[0]->is_opaque());
  EXPECT_FALSE(scene->objects()[1]->is_opaque());
  EXPECT_FALSE(scene->objects()[2]->is_opaque());
  EXPECT_FALSE(scene->objects()[3]->is_opaque());
  EXPECT_TRUE(scene->needs().interior_textures);
  EXPECT_TRUE(scene->needs().transparent_shadows);
}

TEST(UnitCoreScene, APlainSceneNeedsNothing) {
  SceneBuilder b;
  b.parts.settings.max_trace_level = 7;
  b.parts.objects.push_back(b.ball(0, b.texture(0)));
  b.parts.lights.emplace_back();
  const auto scene = b.compile();
  const Needs& n = scene->needs();
  for (const bool needed :
       {n.infinite_objects, n.csg, n.clipping, n.transparency, n.transparent_shadows,
        n.shadows_begin_anew, n.refraction, n.interiors, n.reflection, n.layered_textures,
        n.textures_by_place, n.interior_textures, n.highlights, n.area_lights, n.spot_lights,
        n.fading_lights, n.shadowless_lights, n.visibility_flags, n.sky_sphere}) {
    EXPECT_FALSE(needed);
  }
  EXPECT_EQ(n.greatest_depth, 1);
}

TEST(UnitCoreScene, EachNeedIsFound) {
  const auto needs_of = [](auto&& change) {
    SceneBuilder b;
    change(b);
    return b.compile()->needs();
  };
  EXPECT_TRUE(
      needs_of([](SceneBuilder& b) {
        b.parts.objects.push_back(b.leaf(std::make_unique<Plane>(Vec3{1, 1, 1}, 0), b.texture(0)));
      }).infinite_objects);
  const Needs glass = needs_of([](SceneBuilder& b) {
    b.parts.settings.max_trace_level = 9;
    b.parts.objects.push_back(b.ball(0, b.texture(0.7f), b.interior(1.5)));
  });
  EXPECT_TRUE(glass.transparency && glass.transparent_shadows && glass.refraction &&
              glass.interiors);
  EXPECT_EQ(glass.greatest_depth, 9);
  const Needs film = needs_of([](SceneBuilder& b) {
    b.parts.objects.push_back(b.ball(0, b.texture(0.7f), b.interior(1)));
  });
  EXPECT_TRUE(film.transparency);
  EXPECT_FALSE(film.refraction);
  const Needs no_shadow = needs_of([](SceneBuilder& b) {
    auto ball = b.ball(0, b.texture(0.7f));
    Attributes a = ball->attributes();
    a.no_shadow = true;
    ball->set_attributes(a);
    b.parts.objects.push_back(std::move(ball));
  });
  EXPECT_TRUE(no_shadow.visibility_flags);
  EXPECT_FALSE(no_shadow.transparent_shadows);
  const Needs mirror = needs_of([](SceneBuilder& b) {
    Finish finish;
    finish.reflection_max = Rgb(0.5f);
    finish.phong = 1;
    b.parts.objects.push_back(b.ball(0, b.texture(0, finish, 2)));
  });
  EXPECT_TRUE(mirror.reflection && mirror.highlights && mirror.layered_textures);
  EXPECT_EQ(mirror.greatest_depth, 5);
  const Needs lights = needs_of([](SceneBuilder& b) {
    Light light;
    light.kind = Light::Kind::kSpot;
    light.has_area = light.shadowless = true;
    light.fade_distance = light.fade_power = 2;
    b.parts.lights.push_back(light);
  });
  EXPECT_TRUE(lights.spot_lights && lights.area_lights && lights.shadowless_lights &&
              lights.fading_lights);
}

TEST(UnitCoreScene, TheGeneralPathNeedsEverything) {
  SceneBuilder b;
  b.parts.objects.push_back(b.ball(0, b.texture(0)));
  const auto scene = b.compile({.general_path = true});
  EXPECT_TRUE(scene->needs().transparency && scene->needs().reflection &&
              scene->needs().area_lights && scene->needs().layered_textures);
  EXPECT_EQ(scene->needs().greatest_depth, 5);
  EXPECT_EQ(scene->needs().primitives.at("sphere"), 1u);
}

TEST(UnitCoreScene, ContainingFindsEverySolidInSceneOrder) {
  SceneBuilder b;
  const Texture* t = b.texture(0.5f);
  const Interior* shared = b.interior(1.5);
  b.parts.objects.push_back(
      b.leaf(std::make_unique<Box>(Vec3{-5, -5, -5}, Vec3{5, 5, 5}), t, b.interior(1.3)));
  b.parts.objects.push_back(b.ball(0, t));
  // Below the plane is inside; parts of one union share its interior but count each. What is inverse counts
  // within the box of its surface.
  b.parts.objects.push_back(
      b.leaf(std::make_unique<Plane>(Vec3{0.1, 1, 0}, 2), t, b.interior(1.1)));
  b.parts.objects.push_back(b.csg(CsgKind::kUnion, b.ball(0.5, t, shared), b.ball(0, t, shared)));
  auto inverse = b.ball(20, t, b.interior(2));
  inverse->set_inverse(true);
  b.parts.objects.push_back(std::move(inverse));
  const auto scene = b.compile();
  std::vector<const Object*> in;
  const auto numbers = [&](const Vec3& p) {
    scene->hierarchy().containing(p, in);
    std::string text;
    for (const Object* o : in) {
      for (std::size_t i = 0; i < scene->objects().size(); ++i) {
        if (scene->objects()[i].get() == o) text += std::to_string(i) + " ";
      }
    }
    return text;
  };
  EXPECT_EQ(numbers({0.2, 0, 0}), "0 1 2 3 4 ");
  EXPECT_EQ(numbers({-0.9, 0, 0}), "0 1 2 4 ");
  EXPECT_EQ(numbers({1.4, 0, 0}), "0 2 3 ");
  EXPECT_EQ(numbers({0, 4, 0}), "0 ");
  EXPECT_EQ(numbers({20.5, 0.5, 0}), "");
  EXPECT_EQ(numbers({20.9, 0.9, 0.9}), "5 ");
  EXPECT_EQ(numbers({30, 30, 0}), "");
}

TEST(UnitCoreScene, TolerancesShrinkWithSmallScenes) {
  const auto scale_of = [](std::vector<std::pair<double, double>> spheres, bool plane) {
    SceneBuilder b;
    const Texture* grey = b.texture(0.0f);
    for (const auto& [x, radius] : spheres) {
      b.parts.objects.push_back(
          SceneBuilder::leaf(std::make_unique<Sphere>(Vec3{x, 0, 0}, radius), grey));
    }
    if (plane)
      b.parts.objects.push_back(
          SceneBuilder::leaf(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), grey));
    return Scene(std::move(b.parts), {}).tolerance_scale();
  };
  EXPECT_EQ(scale_of({}, false), 1.0);
  EXPECT_EQ(scale_of({{0.0, 1.0}}, false), 1.0);
  EXPECT_EQ(scale_of({{0.0, 1e6}}, false), 1.0);
  EXPECT_NEAR(scale_of({{5.0, 1e-5}}, false), 2e-5 * std::sqrt(3.0), 1e-9);
  EXPECT_EQ(scale_of({{0.0, 1e-5}, {2.0, 1e-5}}, false), 1.0) << "small things far from each other";
  EXPECT_EQ(scale_of({{0.0, 1e-5}}, true), 1.0) << "with a plane it has no size";
}

TEST(UnitCoreScene, ExplainTellsWhatTheSceneNeeds) {
  SceneBuilder b;
  b.parts.objects.push_back(b.ball(0, b.texture(0.5f), b.interior(1.5)));
  b.parts.objects.push_back(b.ball(4, b.texture(0)));
  b.parts.lights.emplace_back();
  const std::string text = explain(*b.compile());
  EXPECT_NE(text.find("2 sphere"), std::string::npos) << text;
  EXPECT_NE(text.find("transparency, transparent shadows, refraction, interiors"),
            std::string::npos)
      << text;
  EXPECT_LT(text.find("not needed"), text.find("reflection")) << text;
  EXPECT_EQ(text.back(), '\n');
}

TEST(UnitCoreScene, ExplainTellsHowPhotonsAndSubsurfaceLightAreSampled) {
  SceneBuilder b;
  b.parts.objects.push_back(b.ball(0, b.texture(0)));
  b.parts.settings.photons = PhotonSettings{};
  b.parts.settings.photons->spacing = 0.25;
  b.parts.settings.subsurface = SubsurfaceSettings{};
  const std::string text = explain(*b.compile());
  EXPECT_NE(text.find("spacing 0.25, gather 20 to 100\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("subsurface light  "), std::string::npos) << "no finish has any";
  b.parts.settings.photons->count = 5000;
  EXPECT_NE(explain(*b.compile()).find("count 5000, gather"), std::string::npos);
}

}  // namespace
