// The tracer on small hand-made scenes: figures known from the formulae, paths that agree bit by
// bit, and shadow caches that never change the picture.
#include "core/trace/integrator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "core/object/leaf.h"
#include "core/shape/box.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"
#include "shadow/cache_policy.h"
#include "shadow/direction_policy.h"
#include "shadow/neighbourhood.h"
#include "shadow/pixel_orders.h"
#include "shadow/tester_factory.h"

using namespace lentray;
using namespace lentray::core;

namespace {

class PlainPigment final : public Pigment {
 public:
  explicit PlainPigment(const Colour& c) : m_colour(c) {}
  Colour colour(const Vec3&, const SurfaceContext&) const override { return m_colour; }
  bool is_opaque() const override { return m_colour.is_opaque(); }
  const Colour* constant() const override { return &m_colour; }

 private:
  Colour m_colour;
};

/// Stripes along x, so that neighbours differ.
class StripedPigment final : public Pigment {
 public:
  StripedPigment(const Colour& a, const Colour& b) : m_a(a), m_b(b) {}
  Colour colour(const Vec3& p, const SurfaceContext&) const override {
    return static_cast<long>(std::floor(p.x * 3.0)) % 2 == 0 ? m_a : m_b;
  }
  bool is_opaque() const override { return m_a.is_opaque() && m_b.is_opaque(); }

 private:
  Colour m_a, m_b;
};

Finish dull() {
  Finish f;
  f.ambient = Rgb(0.0f);
  f.diffuse = 1.0;
  return f;
}

struct Builder {
  SceneParts parts;

  const Texture* texture(std::vector<TextureLayer> layers) {
    parts.textures.push_back(std::make_shared<LayeredTexture>(std::move(layers)));
    return parts.textures.back().get();
  }
  const Texture* plain(const Colour& c, const Finish& f = dull()) {
    return texture({{std::make_shared<PlainPigment>(c), std::make_shared<Finish>(f)}});
  }
  const Interior* interior(const Interior& i) {
    parts.interiors.push_back(std::make_shared<Interior>(i));
    return parts.interiors.back().get();
  }
  Attributes& add(std::unique_ptr<Shape> shape, const Texture* t, const Interior* i = nullptr) {
    auto leaf = std::make_unique<Leaf>(std::move(shape), Transform());
    Attributes a;
    a.texture = t;
    a.interior = i;
    leaf->set_attributes(a);
    parts.objects.push_back(std::move(leaf));
    return m_last = a;
  }
  Light& light(const Vec3& at, const Rgb& colour = Rgb(1.0f)) {
    Light l;
    l.position = at;
    l.colour = colour;
    parts.lights.push_back(l);
    return parts.lights.back();
  }
  std::unique_ptr<Scene> compile(bool general = false) {
    CompileOptions options;
    options.general_path = general;
    return std::make_unique<Scene>(std::move(parts), options);
  }

 private:
  Attributes m_last;
};

struct Kit {
  explicit Kit(const Scene& s, const std::string& cache = "off")
      : scene(s), context(s, false), tester(shadow::make_tester_factory(cache)->make(context)),
        tracer(context, *tester) {}
  Radiance look(const Vec3& from, const Vec3& along, Pixel pixel = {}) {
    return tracer.trace({from, normalized(along)}, pixel);
  }
  const Scene& scene;
  ThreadContext context;
  Counters& counters = context.counters;
  std::unique_ptr<ShadowTester> tester;
  Integrator tracer;
};

Colour rgb(float r, float g, float b) { return {{r, g, b}, 0.0f, 0.0f}; }
Colour clear(float filter, float transmit) { return {Rgb(1.0f), filter, transmit}; }

// A room of everything: floor, mirror, glass, filter, layers, area light; with glass comes haze.
void furnish(Builder& b, bool transparency, bool reflection, bool layers, bool area) {
  b.parts.settings.max_trace_level = 7;
  b.parts.settings.background = rgb(0.2f, 0.3f, 0.5f);
  Finish floor = dull();
  floor.ambient = Rgb(0.1f);
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0),
        b.texture({{std::make_shared<StripedPigment>(rgb(0.9f, 0.8f, 0.7f), rgb(0.3f, 0.4f, 0.6f)),
                    std::make_shared<Finish>(floor)}}));
  Finish shiny = dull();
  shiny.diffuse = 0.4;
  shiny.specular = 0.5;
  if (reflection) shiny.reflection_min = shiny.reflection_max = Rgb(0.6f);
  b.add(std::make_unique<Sphere>(Vec3{-1, 1, 0}, 0.9), b.plain(rgb(0.9f, 0.5f, 0.2f), shiny));
  if (transparency) {
    Interior glass;
    glass.ior = 1.4;
    glass.fade_distance = 2;
    glass.fade_power = 2;
    glass.fade_colour = {0.8f, 0.9f, 0.7f};
    Finish smooth = dull();
    smooth.diffuse = 0.1;
    if (reflection) {
      smooth.reflection_max = Rgb(1.0f);
      smooth.reflection_fresnel = true;
      smooth.conserve_energy = true;
    }
    b.add(std::make_unique<Sphere>(Vec3{0.6, 0.8, -0.4}, 0.7), b.plain(clear(0.3f, 0.6f), smooth),
          b.interior(glass));
  }
  if (layers) {
    b.add(std::make_unique<Box>(Vec3{0.5, 0, 0.8}, Vec3{1.8, 1.4, 1.5}),
          b.texture({{std::make_shared<PlainPigment>(rgb(0.3f, 0.9f, 0.3f)),
                      std::make_shared<Finish>(dull())},
                     {std::make_shared<StripedPigment>(Colour{{1, 0.2f, 0.2f}, 0.6f, 0.1f},
                                                       rgb(0.1f, 0.1f, 0.7f)),
                      std::make_shared<Finish>(shiny)}}));
  }
  b.light({-4, 6, -5}, Rgb(0.8f));
  Light& second = b.light({4, 7, -3}, {0.4f, 0.4f, 0.5f});
  if (transparency) {
    auto haze = std::make_shared<Medium>();
    haze->scattering = haze->absorption = Rgb(0.01f);
    haze->sampling.min_samples = 4;
    haze->sampling.jitter = 0.5;
    haze->densities = {std::make_shared<StripedPigment>(rgb(1, 1, 1), rgb(0.2f, 0.3f, 2.0f))};
    b.parts.atmosphere.media.push_back(haze);
    second.dimmed_by_air = true;
  }
  if (area) {
    second.has_area = true;
    second.area.axis1 = {1, 0, 0};
    second.area.axis2 = {0, 0, 1};
    second.area.size1 = second.area.size2 = 4;
    second.area.adaptive = 1;
    second.area.jitter = true;
  }
}

constexpr std::uint32_t kWide = 48, kHigh = 36;

std::vector<Radiance> integrator_picture(Integrator& tracer,
                                         const std::string& order_name = "rows") {
  std::vector<Radiance> out(kWide * kHigh);
  std::vector<Pixel> pixels;
  const auto order = shadow::make_order(order_name, kWide, kHigh);
  for (std::size_t job = 0; job < order->jobs(); ++job) {
    order->pixels(job, pixels);
    for (const Pixel p : pixels) {
      const Vec3 along{(p.column + 0.5) / kWide - 0.5, 0.15 - 0.75 * (p.row + 0.5) / kHigh, 1.1};
      out[p.row * kWide + p.column] = tracer.trace({{0, 2, -5}, normalized(along)}, p);
    }
  }
  return out;
}

bool integrator_same(const std::vector<Radiance>& a, const std::vector<Radiance>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!(a[i].rgb == b[i].rgb) || a[i].transmit != b[i].transmit) return false;
  }
  return a.size() == b.size();
}

TEST(UnitCoreIntegrator, DiffuseLightOfAKnownAngle) {
  Builder b;
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(rgb(0.5f, 0.25f, 1.0f)));
  b.light({3, 4, 0});
  const auto scene = b.compile();
  const Radiance seen = Kit(*scene).look({0, 2, 0}, {0, -1, 0});
  EXPECT_NEAR(seen.rgb.r, 0.5 * 0.8, 1e-6);
  EXPECT_NEAR(seen.rgb.g, 0.25 * 0.8, 1e-6);
  EXPECT_FLOAT_EQ(seen.transmit, 0.0f);
}

TEST(UnitCoreIntegrator, NothingIsHit) {
  Builder b;
  b.parts.settings.background = rgb(0.1f, 0.2f, 0.3f);
  const auto scene = b.compile();
  const Radiance seen = Kit(*scene).look({0, 2, 0}, {0, -1, 0});
  EXPECT_EQ(seen.rgb, Rgb(0.1f, 0.2f, 0.3f));
  EXPECT_FLOAT_EQ(seen.transmit, 0.0f);
  // With +UA a background is a layer, and colours are premultiplied.
  Builder clear;
  clear.parts.settings.alpha = true;
  clear.parts.settings.background = {Rgb(0.1f, 0.2f, 0.3f), 0, 0.75f};
  const auto clear_scene = clear.compile();
  const Radiance layer = Kit(*clear_scene).look({0, 2, 0}, {0, -1, 0});
  EXPECT_EQ(layer.rgb, Rgb(0.1f, 0.2f, 0.3f) * 0.25f);
  EXPECT_FLOAT_EQ(layer.transmit, 0.75f);
}

TEST(UnitCoreIntegrator, ShadowsAreColouredByWhatTheyPass) {
  Builder b;
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(rgb(1, 1, 1)));
  b.add(std::make_unique<Box>(Vec3{-1, 1, -1}, Vec3{1, 1.5, 1}),
        b.plain({{1.0f, 0.5f, 0.0f}, 0.5f, 0.25f}));
  b.light({0, 10, 0});
  const auto scene = b.compile();
  Kit kit(*scene);
  const Radiance seen = kit.look({0, 0.5, 0}, {0, -1, 0});
  EXPECT_NEAR(seen.rgb.r, 0.75 * 0.75, 1e-5) << "two surfaces of filter 0.5 and transmit 0.25";
  EXPECT_NEAR(seen.rgb.g, 0.5 * 0.5, 1e-5);
  EXPECT_NEAR(seen.rgb.b, 0.25 * 0.25, 1e-5);
  EXPECT_EQ(kit.counters.lights[0].rays, 1u);
  EXPECT_EQ(kit.counters.lights[0].blocked, 0u);
}

TEST(UnitCoreIntegrator, SurfacesWithinTheToleranceFilterOnce) {
  Builder b;
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(rgb(1, 1, 1)));
  b.add(std::make_unique<Box>(Vec3{-1, 1, -1}, Vec3{1, 1.0005, 1}), b.plain({Rgb(0.5f), 1, 0}));
  b.light({0, 10, 0});
  const auto scene = b.compile();
  EXPECT_NEAR(Kit(*scene).look({0, 0.5, 0}, {0, -1, 0}).rgb.r, 0.5, 1e-5);
}

TEST(UnitCoreIntegrator, TotalReflectionBeyondTheCriticalAngle) {
  // From within glass that fills y < 0, looking up at 60 degrees from the normal: ior 2 mirrors.
  Builder b;
  b.parts.settings.background = rgb(1, 0, 0);
  Interior glass;
  glass.ior = 2.0;
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(clear(0, 0.5f), dull()),
        b.interior(glass));
  Finish glow = dull();
  glow.emission = Rgb(1.0f);
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, -5.0), b.plain(rgb(0, 1, 0), glow));
  const auto scene = b.compile();
  Kit kit(*scene);
  const Radiance mirrored = kit.look({0, -1, 0}, {std::sqrt(3.0), 1, 0});
  EXPECT_FLOAT_EQ(mirrored.rgb.g, 1.0f) << "not filtered";
  EXPECT_FLOAT_EQ(mirrored.rgb.r, 0.0f);
  const Radiance out = kit.look({0, -1, 0}, {0.3, 1, 0});
  EXPECT_FLOAT_EQ(out.rgb.r, 0.5f) << "filtered";
}

TEST(UnitCoreIntegrator, RefractionFollowsSnell) {
  // Down through glass whose floor glows in stripes of one third: find where the ray lands.
  for (const double x : {0.2, 0.5, 0.7}) {
    Builder b;
    Interior glass;
    glass.ior = 1.5;
    b.add(std::make_unique<Box>(Vec3{-9, -1, -9}, Vec3{9, 0, 9}), b.plain(clear(0, 1.0f), dull()),
          b.interior(glass));
    Finish glow = dull();
    glow.emission = Rgb(1.0f);
    glow.diffuse = 0;
    const double sine = x, inside = sine / 1.5;
    const double lands = inside / std::sqrt(1 - inside * inside);
    // Within the slab, just above its lower face, stands a small marker where Snell's law says.
    b.add(std::make_unique<Sphere>(Vec3{lands * 0.95, -0.95, 0}, 0.01),
          b.plain(rgb(1, 1, 1), glow));
    const auto scene = b.compile();
    Kit kit(*scene);
    const Vec3 along{sine, -std::sqrt(1 - sine * sine), 0};
    EXPECT_FLOAT_EQ(kit.look(along * -1.0, along).rgb.r, 1.0f) << x;
    EXPECT_FLOAT_EQ(kit.look(along * -1.0 + Vec3{0.05, 0, 0}, along).rgb.r, 0.0f) << x;
  }
}

TEST(UnitCoreIntegrator, LevelsEndInBlack) {
  Builder b;
  Finish mirror = dull();
  mirror.diffuse = 0;
  mirror.emission = Rgb(0.25f);
  mirror.reflection_min = mirror.reflection_max = Rgb(1.0f);
  b.parts.settings.max_trace_level = 3;
  b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(rgb(1, 1, 1), mirror));
  b.add(std::make_unique<Plane>(Vec3{0, -1, 0}, -4.0), b.plain(rgb(1, 1, 1), mirror));
  const auto scene = b.compile();
  Kit kit(*scene);
  EXPECT_FLOAT_EQ(kit.look({0, 2, 0}, {0, -1, 0.1}).rgb.r, 0.75f);
  EXPECT_EQ(kit.counters.camera_rays, 1u);
  EXPECT_EQ(kit.counters.reflected_rays, 3u) << "the last one is stopped before it is traced";
}

TEST(UnitCoreIntegrator, GeneralAndSpecialisedScenesGiveTheSameBits) {
  for (unsigned what = 0; what < 16; ++what) {
    std::vector<Radiance> seen[2];
    for (const bool general : {false, true}) {
      Builder b;
      furnish(b, what & 1, what & 2, what & 4, what & 8);
      const auto scene = b.compile(general);
      Kit kit(*scene);
      seen[general] = integrator_picture(kit.tracer);
    }
    EXPECT_TRUE(integrator_same(seen[0], seen[1])) << what;
  }
}

/// Every cache in one order, every order with one cache; Slow/ImageIdentical has all pairs.
TEST(UnitShadowCache, NeverChangesThePictureAndCountsAddUp) {
  for (const bool transparency : {false, true}) {
    Builder b;
    furnish(b, transparency, true, true, true);
    const auto scene = b.compile();
    Kit plain(*scene);
    const std::vector<Radiance> reference = integrator_picture(plain.tracer);
    for (const auto cache : shadow::tester_names()) {
      for (const auto order : shadow::order_names()) {
        if (order != "rows" && cache != "neighbourhood") continue;
        Kit kit(*scene, std::string(cache));
        EXPECT_TRUE(integrator_same(integrator_picture(kit.tracer, std::string(order)), reference))
            << cache << " " << order;
        for (std::size_t i = 0; i < 2; ++i) {
          const ShadowCounts& mine = kit.counters.lights[i];
          EXPECT_EQ(mine.rays, plain.counters.lights[i].rays);
          EXPECT_EQ(mine.blocked, plain.counters.lights[i].blocked);
          EXPECT_EQ(mine.probes, mine.hits + mine.misses);
          EXPECT_LE(mine.hits, mine.blocked);
          if (cache == "auto") continue;  // may do without
          EXPECT_EQ(mine.probes > 0, cache != "off");
          EXPECT_EQ(mine.hits > 0, cache != "off");
        }
      }
    }
  }
}

// A wedge over a floor, from 0.1 to 3 thousandths above it: part of it is too near to count as a
// blocker. A cached test with another tolerance than the search's would blacken that part too.
TEST(UnitShadowCache, BlockerThatIsTooNearInPlaces) {
  std::vector<std::vector<Radiance>> seen;
  for (const char* cache : {"off", "last", "depth"}) {
    for (const char* order : {"rows", "columns"}) {
      Builder b;
      b.add(std::make_unique<Plane>(Vec3{0, 1, 0}, 0.0), b.plain(rgb(1, 1, 1)));
      auto wedge = std::make_unique<Leaf>(
          std::make_unique<Box>(Vec3{0, 0, -1}, Vec3{3, 1e-5, 1}),
          Transform::rotation({0, 0, 0.055}).then(Transform::translation({-1.5, 1e-4, 0})));
      Attributes attributes;
      attributes.texture = b.plain(rgb(1, 0, 0));
      attributes.no_image = true;
      wedge->set_attributes(attributes);
      b.parts.objects.push_back(std::move(wedge));
      b.light({0, 30, 0});
      const auto scene = b.compile();
      Kit kit(*scene, cache);
      seen.push_back(integrator_picture(kit.tracer, order));
      EXPECT_TRUE(integrator_same(seen.back(), seen.front())) << cache << " " << order;
      const ShadowCounts& counts = kit.counters.lights[0];
      EXPECT_GT(counts.blocked, 50u) << "where the wedge is far enough";
      EXPECT_GT(counts.rays - counts.blocked, 50u);
    }
  }
}

/// A scene of nothing but so many lights, the last one parallel.
std::unique_ptr<Scene> lights_alone(int count) {
  Builder b;
  for (int i = 0; i < count; ++i) b.light({10.0 * i, 30, 0});
  b.parts.lights.back().parallel = true;
  b.parts.lights.back().direction = {0, -1, 0};
  return b.compile();
}

TEST(UnitShadowCache, DepthKeepsMirroredPointsApart) {
  const auto scene = lights_alone(3);
  const shadow::DepthPolicy policy(*scene);
  ShadowQuery query;
  query.light = 1;
  query.level = 1;
  EXPECT_EQ(policy.homes(query), (shadow::Keys<1>{1}));
  EXPECT_EQ(policy.keys(query), (shadow::Keys<2>{1, 4}));
  query.level = 2;
  EXPECT_EQ(policy.homes(query), (shadow::Keys<1>{4}));
  EXPECT_EQ(policy.keys(query), (shadow::Keys<2>{4, 4}));
  query.level = 5;
  EXPECT_EQ(policy.homes(query)[0], 4u);
  EXPECT_EQ(policy.slots(), 6u);
}

TEST(UnitShadowCache, TreeKeepsTheWaysOfRaysApart) {
  const auto scene = lights_alone(2);
  const shadow::TreePolicy policy(*scene);
  std::set<std::size_t> slots;
  for (std::uint32_t light = 0; light < 2; ++light) {
    for (std::uint32_t place = 1; place < kTreePlaces; ++place) {
      ShadowQuery query;
      query.light = light;
      query.tree_place = place;
      slots.insert(policy.homes(query)[0]);
    }
  }
  EXPECT_EQ(slots.size(), 2 * (kTreePlaces - 1));
  EXPECT_LT(*slots.rbegin(), policy.slots());
}

/// Two points that a light sees in one direction share a cell wherever the picture has them; points
/// it sees far apart do not. For parallel lights it is the place across the rays that counts.
TEST(UnitShadowCache, GridGoesByTheLightsView) {
  const auto scene = lights_alone(2);
  const shadow::DirectionPolicy policy(*scene);
  const auto fine = [&](std::uint32_t light, const Vec3& origin, const Vec3& direction) {
    ShadowQuery query;
    query.light = light;
    query.ray = {origin, normalized(direction)};
    query.column = static_cast<std::uint32_t>(100 + origin.y);
    const std::size_t slot = policy.keys(query)[0];
    EXPECT_LT(slot, policy.slots());
    return slot;
  };
  EXPECT_EQ(fine(0, {1, 2, 3}, {0.3, 1, 0.2}), fine(0, {1.3, 3, 3.2}, {0.3, 1, 0.2}));
  EXPECT_NE(fine(0, {1, 2, 3}, {0.3, 1, 0.2}), fine(0, {1, 2, 3}, {0.4, 1, 0.2}));
  EXPECT_EQ(fine(1, {0.1, 2, 0.3}, {0, 1, 0}), fine(1, {0.1, 9, 0.3}, {0, 1, 0}));
  EXPECT_NE(fine(1, {0.1, 2, 0.3}, {0, 1, 0}), fine(1, {0.2, 2, 0.3}, {0, 1, 0}));
}

/// What blocked a pixel is worth a probe in those below and to its right, at the same place in the
/// ray tree and for the same light, until a pixel was light.
TEST(UnitShadowCache, NeighbourhoodForgetsWhatIsLight) {
  const auto scene = lights_alone(2);
  shadow::Neighbourhood cache(*scene);
  const auto at = [](std::uint32_t column, std::uint32_t row, std::uint32_t light = 0,
                     std::uint32_t place = 1) {
    ShadowQuery query;
    query.column = column;
    query.row = row;
    query.light = light;
    query.tree_place = place;
    return query;
  };
  const auto empty = [&](const ShadowQuery& query) { return cache.empty(cache.spot(query)); };
  const auto seen = [&](const ShadowQuery& query, const void* blocker) {
    cache.searched(query, cache.spot(query), static_cast<const Object*>(blocker));
  };
  const int object = 0;  // only its address counts
  EXPECT_TRUE(empty(at(5, 7)));
  seen(at(5, 7), &object);
  for (const auto& query : {at(5, 8), at(6, 7), at(4, 8), at(6, 6)}) EXPECT_FALSE(empty(query));
  for (const auto& query : {at(7, 9), at(5, 8, 1), at(5, 8, 0, 2)}) EXPECT_TRUE(empty(query));
  seen(at(5, 8), nullptr);
  EXPECT_TRUE(empty(at(5, 9)));
}

}  // namespace
