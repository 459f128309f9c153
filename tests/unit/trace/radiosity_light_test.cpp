// What a gather makes of its rays: brightness, greys, limits, importance and quality, worked out from the
// directions; and that a ray whose questions are noted brings the same light once they are answered.
#include "core/trace/radiosity_light.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <vector>

#include "core/object/leaf.h"
#include "core/shape/plane.h"
#include "core/shape/sphere.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/random_key.h"
#include "core/trace/thread_context.h"

using namespace lentray::core;

namespace {

class RadiosityColour final : public Pigment {
 public:
  explicit RadiosityColour(const Colour& c) : m_colour(c) {}
  Colour colour(const Vec3&, const SurfaceContext&) const override { return m_colour; }
  bool is_opaque() const override { return m_colour.is_opaque(); }
  const Colour* constant() const override { return &m_colour; }

 private:
  Colour m_colour;
};

Finish mat(double diffuse, float emission = 0.0f) {
  Finish finish;
  finish.ambient = Rgb(0.0f);
  finish.diffuse = diffuse;
  finish.emission = Rgb(emission);
  return finish;
}

struct GatherStage {
  GatherStage() {
    parts.settings.background = Colour{Rgb(1.0f)};
    parts.settings.radiosity.emplace();
    settings().count = 41;
    settings().recursion_limit = 1;
  }
  RadiositySettings& settings() { return *parts.settings.radiosity; }
  void add(std::unique_ptr<Shape> shape, const Finish& finish, double importance = 1.0,
           const Colour& colour = Colour{Rgb(1.0f)}) {
    parts.textures.push_back(std::make_shared<LayeredTexture>(std::vector<TextureLayer>{
        {std::make_shared<RadiosityColour>(colour), std::make_shared<Finish>(finish)}}));
    Attributes attributes;
    attributes.texture = parts.textures.back().get();
    PassFlags flags;
    flags.importance = importance;
    attributes.pass_flags = static_cast<std::uint32_t>(parts.pass_flags.size());
    parts.pass_flags.push_back(flags);
    auto leaf = std::make_unique<Leaf>(std::move(shape), Transform());
    leaf->set_attributes(attributes);
    parts.objects.push_back(std::move(leaf));
  }
  /// A wall at x = 5.
  void add_wall(const Finish& finish, double importance = 1.0) {
    add(std::make_unique<Plane>(Vec3(1, 0, 0), 5.0), finish, importance);
  }
  /// At the origin, with y upwards. `prepare`: the samples there are.
  Rgb ask(const std::function<void(IrradianceCache&)>& prepare = {}) {
    const RadiositySettings wanted = settings();
    const Scene scene(std::move(parts), {});
    IrradianceCache cache(wanted, {0, 0, -10});
    if (prepare) prepare(cache);
    ThreadContext context(scene, false);
    PlainShadowTester shadows(context);
    RadiosityLight light(context, shadows, static_cast<const IrradianceCache&>(cache));
    context.indirect = &light;
    const Vec3 up(0, 1, 0);
    light.begin({}, true, 0);
    return light.at({{}, up, up, 1.0}).light;
  }
  SceneParts parts;
};

/// The mean over the gather's rays of `light` weighed by `share`, told whether they meet the wall.
struct Expected {
  double light = 0.0, share = 0.0;
  void add(double one, double weight) {
    light += one * weight;
    share += weight;
  }
  double mean() const { return light / share; }
};
Expected over_rays(const std::function<void(Expected&, std::size_t, bool)>& add) {
  // The first gather of a pixel of key 0 begins there in the cycle.
  const auto directions = cosine_weighted_directions(1600);
  const std::size_t first = mixed(0) % 1600;
  Expected sum;
  for (std::size_t i = 0; i < 41; ++i) add(sum, i, directions[(first + i) % 1600].x > 0.0);
  return sum;
}

}  // namespace

TEST(UnitRadiosityLight, BrightnessGreyAndLimit) {
  GatherStage plain;
  EXPECT_EQ(plain.ask(), Rgb(1.0f));
  GatherStage bright;
  bright.settings().brightness = 1.5;
  EXPECT_EQ(bright.ask(), Rgb(1.5f));
  GatherStage grey_one;
  grey_one.parts.settings.background = Colour{Rgb(1.0f, 0.0f, 0.0f)};
  grey_one.settings().gray_threshold = 0.5;
  const Rgb half = grey_one.ask();
  EXPECT_NEAR(half.r, 0.5 + 0.5 * 0.297, 1e-6);
  EXPECT_NEAR(half.g, 0.5 * 0.297, 1e-6);
  GatherStage bright_grey;
  bright_grey.settings().gray_threshold = 0.5;
  bright_grey.settings().brightness = 1.5;
  EXPECT_EQ(bright_grey.ask(), Rgb(1.5f));
  GatherStage limited;
  limited.parts.settings.background = Colour{Rgb(4.0f, 2.0f, 0.0f)};
  limited.settings().max_sample = 1.0;
  const Rgb most = limited.ask();
  EXPECT_NEAR(most.r, 1.0, 1e-6);
  EXPECT_NEAR(most.g, 0.5, 1e-6);
}

TEST(UnitRadiosityLight, UnimportantThingsGetFewRaysThatCountMore) {
  struct Few {
    double importance;
    std::size_t rays;  ///< of the 41
  };
  for (const Few& few : {Few{0.25, 11}, Few{0.91, 37}, Few{0.94, 38}}) {
    GatherStage stage;
    stage.add_wall(mat(0.0, 2.0f), few.importance);
    const Expected expected = over_rays([&](Expected& sum, std::size_t i, bool wall) {
      if (!wall) sum.add(1.0, 1.0);
      if (wall && i < few.rays) sum.add(2.0, 41.0 / static_cast<double>(few.rays));
    });
    EXPECT_NEAR(stage.ask().r, expected.mean(), 1e-5) << few.importance;
  }
}

TEST(UnitRadiosityLight, RaysThatUsePoorSamplesCountLess) {
  GatherStage stage;
  stage.settings().recursion_limit = 2;
  stage.add_wall(mat(1.0));
  const auto prepare = [](IrradianceCache& cache) {
    IrradianceSample sample;
    sample.point = {5, 0, 0};
    sample.normal = {-1, 0, 0};
    sample.light = Rgb(3.0f);
    sample.radius = 1e9f;  // so that all places are as near
    sample.nearest = 1e9f;
    sample.quality = 0.1f;
    cache.store(1).add(sample);
  };
  // Two samples are wanted; a weight of 0.1 counts as 0.4.
  const Expected expected = over_rays(
      [](Expected& sum, std::size_t, bool wall) { sum.add(wall ? 3.0 : 1.0, wall ? 0.2 : 1.0); });
  EXPECT_NEAR(stage.ask(prepare).r, expected.mean(), 1e-4);
}

namespace {

/// Answers the same to everybody.
class EverywhereAlike final : public IndirectLight {
 public:
  void begin(Pixel, bool, std::uint64_t) override {}
  bool is_wanted() const override { return true; }
  IndirectAnswer at(const IndirectQuery&) override { return {Rgb(0.5f, 0.25f, 1.0f)}; }
};

}  // namespace

TEST(UnitRadiosityLight, NotedQuestionsAddUpToTheSameLight) {
  GatherStage stage;
  stage.settings().recursion_limit = 2;
  Finish mirror = mat(0.4);
  mirror.reflection_min = mirror.reflection_max = Rgb(0.5f);
  stage.add(std::make_unique<Plane>(Vec3(0, 1, 0), 0.0), mat(0.7), 1.0,
            Colour{Rgb(0.8f, 0.6f, 0.4f)});
  stage.add(std::make_unique<Sphere>(Vec3(-1, 1, 0), 0.8), mirror);
  stage.add(std::make_unique<Sphere>(Vec3(1, 1, 0), 0.8), mat(0.5), 1.0,
            Colour{Rgb(0.9f, 0.5f, 0.5f), 0.4f, 0.2f});
  const Scene scene(std::move(stage.parts), {});
  ThreadContext context(scene, false);
  PlainShadowTester shadows(context);
  Integrator rays = make_gatherer(context, shadows);
  QueryRecorder recorder;
  EverywhereAlike light;
  int whole = 0, others = 0;
  for (const Vec3& direction : cosine_weighted_directions(200)) {
    const GatherRay ray{
        {{0, 4, -3}, normalized(Vec3(direction.x, -direction.y, direction.z + 1))}, 0.5f, 1};
    GatherRecord record;
    recorder.record_to(record, true);
    context.indirect = &recorder;
    record.seen = rays.gather(ray);
    for (const RecordedQuery& asked : record.queries) {
      record.seen.light += asked.share * light.at(asked.query).light;
    }
    ++(record.is_whole ? whole : others);
    if (!record.is_whole) continue;
    context.indirect = &light;
    const Rgb direct = rays.gather(ray).light;
    EXPECT_NEAR(record.seen.light.r, direct.r, 1e-6);
    EXPECT_NEAR(record.seen.light.g, direct.g, 1e-6);
    EXPECT_NEAR(record.seen.light.b, direct.b, 1e-6);
  }
  EXPECT_GT(whole, 50);
  EXPECT_GT(others, 10) << "behind the mirror and the clear ball surfaces ask, too";
}
