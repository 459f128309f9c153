#include "core/render/film.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include "core/object/leaf.h"
#include "core/render/frame.h"
#include "core/shape/sphere.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/random_key.h"

using namespace lentray::core;

namespace {

TEST(UnitCoreRandomKey, PixelsSamplesAndUsesHaveNumbersOfTheirOwn) {
  std::set<std::uint64_t> keys;
  for (std::int32_t column = -2; column < 20; ++column) {
    for (std::int32_t row = -2; row < 20; ++row) {
      for (std::uint32_t sample = 0; sample < 12; ++sample)
        keys.insert(sample_key(column, row, sample));
    }
  }
  EXPECT_EQ(keys.size(), 22u * 22 * 12);
  EXPECT_EQ(sample_key(7, 3, 0), std::uint64_t{3} << 32 | 7);
  RandomSequence crand(5, RandomSequence::Use::kCrand), film(5, RandomSequence::Use::kFilm);
  EXPECT_NE(crand.next(), film.next());
  double sum = 0.0;
  for (std::uint32_t i = 0; i < 4000; ++i) {
    const double value = RandomSequence(sample_key(1, 1, i), RandomSequence::Use::kFilm).next();
    ASSERT_GE(value, 0.0);
    ASSERT_LT(value, 1.0);
    sum += value;
  }
  EXPECT_NEAR(sum / 4000, 0.5, 0.02);
}

/// All keys of a tree of rays of so many levels, and of the lights of each ray's surface.
void add_branches(std::uint64_t key, int levels, std::multiset<std::uint64_t>& keys) {
  keys.insert(RandomSequence::use_key(key, RandomSequence::Use::kMedia));
  for (std::uint64_t light = 0; light < 4; ++light) {
    keys.insert(RandomSequence::use_key(branch_key(key, light), RandomSequence::Use::kLightArea));
  }
  for (std::uint64_t branch = 0; levels > 0 && branch < 4; ++branch) {
    add_branches(branch_key(key, branch), levels - 1, keys);
  }
}

TEST(UnitCoreRandomKey, RaysOfATreeHaveNumbersOfTheirOwn) {
  std::multiset<std::uint64_t> keys;
  for (std::int32_t pixel = 0; pixel < 4; ++pixel) add_branches(sample_key(pixel, 9, 0), 4, keys);
  EXPECT_EQ(keys.size(), 4u * 5 * (1 + 4 + 16 + 64 + 256));
  EXPECT_EQ(std::set<std::uint64_t>(keys.begin(), keys.end()).size(), keys.size());
}

TEST(UnitCorePixelLattice, OfAnOrdinaryPicture) {
  const PixelLattice lattice = PixelLattice::in_rows(300);
  EXPECT_EQ(lattice.width(), 300u);
  EXPECT_EQ(lattice.left[0], -1);
  EXPECT_EQ(lattice.left[299], 298);
  EXPECT_EQ(lattice.tiles, (std::vector<std::uint32_t>{0, 128, 256, 300}));
  EXPECT_EQ(lattice.leftmost(), -1);
  EXPECT_EQ(PixelLattice::in_rows(0).leftmost(), 0);
}

TEST(UnitCoreComparedSpace, SumsChannelsAtTheGammaOfTheEye) {
  const ComparedSpace eye(2.5, 1.0);
  const Compared a = eye.of({{0.5f, 0.25f, 4.0f}, 0.25f}), b = eye.of({{0.5f, 0.5f, -1.0f}, 0.0f});
  EXPECT_NEAR(a.distance(b), std::pow(0.5, 0.4) - std::pow(0.25, 0.4) + std::pow(4.0, 0.4) + 0.25,
              1e-5);
  EXPECT_NEAR(ComparedSpace(2.5, 2.0).of({Rgb(0.5f), 0.0f}).rgb.g, std::pow(0.25, 0.4), 1e-5);
  const double decoded = std::pow((0.5 + 0.055) / 1.055, 2.4);
  EXPECT_NEAR(ComparedSpace(2.5, 0.0).of({Rgb(0.5f), 0.0f}).rgb.b, std::pow(decoded, 0.4), 1e-5);
  EXPECT_EQ(ComparedSpace(0.0, 2.2).of({Rgb(-0.5f), 0.0f}).rgb.r, -0.5f);
}

/// Parallel rays along z; the picture is 4 units wide and high about the origin.
struct Window final : RaySource {
  explicit Window(double pixels) : size(pixels) {}
  bool ray(double column, double row, Ray& ray) const override {
    ray = {{4.0 * column / size - 2, 2 - 4.0 * row / size, -5}, {0, 0, 1}};
    return true;
  }
  double size;
};

struct Rows final : PixelOrder {
  Rows(std::uint32_t columns, std::uint32_t first, std::uint32_t end)
      : width(columns), top(first), bottom(end) {}
  std::size_t jobs() const override { return bottom - top; }
  void pixels(std::size_t job, std::vector<Pixel>& out) const override {
    out.clear();
    for (std::uint32_t i = 0; i < width; ++i)
      out.push_back({i, top + static_cast<std::uint32_t>(job)});
  }
  std::uint32_t width, top, bottom;
};

struct RowBands final : BandOrders {
  explicit RowBands(std::uint32_t columns) : width(columns) {}
  std::unique_ptr<PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    return std::make_unique<Rows>(width, top, bottom);
  }
  std::uint32_t width;
};

struct Whole final : BandSink {
  explicit Whole(std::uint32_t size) : image(size, size) {}
  void put(const Image& band, std::uint32_t top) override {
    std::copy_n(band.pixel(0, 0), std::size_t{4} * band.width * band.height, image.pixel(0, top));
  }
  Image image;
};

/// A white disc that is as bright everywhere, before black.
std::unique_ptr<Scene> disc_scene(float ambient) {
  struct White final : Pigment {
    Colour colour(const Vec3&, const SurfaceContext&) const override { return {Rgb(1.0f), 0, 0}; }
    bool is_opaque() const override { return true; }
  };
  SceneParts parts;
  TextureLayer layer;
  layer.pigment = std::make_shared<White>();
  Finish finish;
  finish.ambient = Rgb(ambient);
  finish.diffuse = 0.0;
  layer.finish = std::make_shared<Finish>(finish);
  parts.textures.push_back(std::make_shared<LayeredTexture>(std::vector{layer}));
  auto leaf = std::make_unique<Leaf>(std::make_unique<Sphere>(Vec3{0, 0, 0}, 1.3), Transform());
  Attributes attributes;
  attributes.texture = parts.textures.front().get();
  leaf->set_attributes(attributes);
  parts.objects.push_back(std::move(leaf));
  return std::make_unique<Scene>(std::move(parts), CompileOptions{});
}

/// Remembers what it is told, but for the jobs whose number is not a multiple of `every`.
struct Memory final : PictureLedger {
  explicit Memory(std::size_t n) : every(n) {}
  const PixelSet* known(std::size_t stage) const override { return sets[stage].get(); }
  void recall(std::size_t stage, std::uint32_t top, std::uint32_t bottom,
              const std::function<void(const Pixel&, const float*)>& tell) override {
    for (const auto& [at, value] : values[stage]) {
      if (at.first >= top && at.first < bottom) tell({at.second, at.first}, value.data());
    }
  }
  bool listens() const override { return every > 0; }
  void add(std::size_t stage, const std::vector<Pixel>& pixels,
           const std::vector<float>& all) override {
    const std::lock_guard lock(mutex);
    ASSERT_EQ(all.size(), pixels.size() * kValues);
    if (count++ % every != 0) return;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      auto& value = values[stage][{pixels[i].row, pixels[i].column}];
      std::copy_n(all.data() + i * kValues, kValues, value.begin());
    }
  }
  /// From now on it knows, and listens no more.
  void turn(std::uint32_t size) {
    every = 0;
    for (std::size_t stage = 0; stage < kStages; ++stage) {
      sets[stage] = std::make_unique<PixelSet>(size, size);
      for (const auto& [at, value] : values[stage]) sets[stage]->add({at.second, at.first});
    }
  }
  std::size_t every, count = 0;
  std::mutex mutex;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<float, kValues>> values[kStages];
  std::unique_ptr<PixelSet> sets[kStages];
};

struct Rendered {
  Image image;
  Counters counters;
};
Rendered render(const Scene& scene, std::uint32_t size, const Antialiasing& aa, int threads = 1,
                std::uint32_t band = 64, PictureLedger* ledger = nullptr) {
  Whole whole(size);
  FrameOptions options{.threads = threads};
  options.antialiasing = aa;
  options.ledger = ledger;
  Counters counters = render_frame(scene, Window(size), {size, size, band}, RowBands(size),
                                   PlainShadowTesterFactory(), options, whole, nullptr);
  return {std::move(whole.image), std::move(counters)};
}

double brightness(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) sum += image.rgba[i];
  return sum * 4.0 * 4.0 / (image.width * image.height);
}

using enum AntialiasingMethod;

TEST(UnitCoreFilm, EveryMethodSeesTheDisc) {
  const auto scene = disc_scene(1.0f);
  const double area = 3.14159265 * 1.3 * 1.3;
  for (const auto method : {kCentres, kCorners, kSpread}) {
    for (const double jitter : {0.0, 1.0}) {
      const Rendered seen = render(*scene, 40, {.method = method, .depth = 4, .jitter = jitter});
      EXPECT_NEAR(brightness(seen.image), area, 0.01 * area) << static_cast<int>(method);
    }
  }
}

TEST(UnitCoreFilm, OnlyEdgesGetMoreSamples) {
  const auto scene = disc_scene(1.0f);
  const Rendered plain = render(*scene, 64, {});
  EXPECT_EQ(plain.counters.camera_rays, 64u * 64);
  EXPECT_EQ(plain.counters.antialiased_pixels, 0u);
  for (const auto method : {kCentres, kCorners, kSpread}) {
    const Rendered edges = render(*scene, 64, {.method = method});
    EXPECT_GT(edges.counters.antialiased_pixels, 64u) << "about the disc's outline of 130 pixels";
    EXPECT_LT(edges.counters.antialiased_pixels, 500u);
    const Rendered flat = render(*disc_scene(0.0f), 64, {.method = method});
    EXPECT_EQ(flat.counters.antialiased_pixels, 0u);
    // kSpread: every second pixel, and all of the first and last row, which nobody lies above or below.
    const std::uint64_t rays[] = {0, 64u * 64 + 2 * 64, 65u * 65, 64u * 64 / 2 + 2 * 64 / 2};
    EXPECT_EQ(flat.counters.camera_rays, rays[static_cast<int>(method)]);
  }
  // Threshold 0: every pixel, each by its depth.
  EXPECT_EQ(
      render(*scene, 64, {.method = kCentres, .threshold = 0.0, .depth = 2}).counters.camera_rays,
      64u * 64 + 2 * 64 + 64u * 64 * 4);
  EXPECT_EQ(
      render(*scene, 64, {.method = kCorners, .threshold = 0.0, .depth = 2}).counters.camera_rays,
      65u * 65 + 64u * 64 * 5);
  EXPECT_EQ(
      render(*scene, 64, {.method = kSpread, .threshold = 0.0, .depth = 2}).counters.camera_rays,
      64u * 64 * 3);
}

TEST(UnitCoreFilm, SameBitsForAnyBandAndNumberOfThreads) {
  const auto scene = disc_scene(1.0f);
  for (const auto method : {kCentres, kCorners, kSpread}) {
    const Antialiasing aa{.method = method, .threshold = 0.1, .depth = 2};
    const Rendered first = render(*scene, 300, aa, 1, 300);
    for (const int threads : {1, 2, 5}) {
      for (const std::uint32_t band : {1u, 7u, 128u, 200u}) {
        EXPECT_EQ(render(*scene, 300, aa, threads, band).image.rgba, first.image.rgba)
            << "method " << static_cast<int>(method) << ", " << threads << " threads, bands of "
            << band;
      }
    }
  }
}

TEST(UnitCoreFilm, WhatALedgerKnowsIsNotTracedAgain) {
  const auto scene = disc_scene(1.0f);
  for (const auto method : {kPlain, kCentres, kCorners, kSpread}) {
    SCOPED_TRACE("method " + std::to_string(static_cast<int>(method)));
    const Antialiasing aa{.method = method, .threshold = 0.1, .depth = 2};
    const Rendered whole = render(*scene, 300, aa);
    for (const std::size_t every : {1u, 2u, 3u}) {
      Memory memory(every);
      const Rendered first = render(*scene, 300, aa, 2, 64, &memory);
      EXPECT_EQ(first.image.rgba, whole.image.rgba);
      memory.turn(300);
      const Rendered second = render(*scene, 300, aa, 2, 200, &memory);
      EXPECT_EQ(second.image.rgba, whole.image.rgba) << "every " << every;
      const double share = 1.0 * second.counters.camera_rays / whole.counters.camera_rays;
      EXPECT_LT(share, 1.0 - 0.5 / every) << "every " << every;
    }
  }
}

TEST(UnitCoreFilm, PartsOfAPictureTakeNoMoreThanTheirTiles) {
  const auto scene = disc_scene(1.0f);
  for (const auto method : {kPlain, kCentres, kCorners, kSpread}) {
    Whole whole(300);
    FrameOptions options{.threads = 2};
    options.antialiasing = {.method = method, .threshold = 1.0};
    options.region = PixelRegion{140, 140, 150, 150};
    const FilmColumns columns = traced_columns(Window(300), {300, 300, 300}, options);
    EXPECT_LE(columns.left, 140u);
    EXPECT_GE(columns.right, 150u);
    struct Part final : BandOrders {
      explicit Part(const FilmColumns& c) : columns(c) {}
      std::unique_ptr<PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
        struct Columns final : PixelOrder {
          Columns(const FilmColumns& c, std::uint32_t t, std::uint32_t b)
              : columns(c), top(t), bottom(b) {}
          std::size_t jobs() const override { return bottom - top; }
          void pixels(std::size_t job, std::vector<Pixel>& out) const override {
            out.clear();
            for (std::uint32_t k = columns.left; k < columns.right; ++k) {
              out.push_back({k, top + static_cast<std::uint32_t>(job)});
            }
          }
          FilmColumns columns;
          std::uint32_t top, bottom;
        };
        return std::make_unique<Columns>(columns, top, bottom);
      }
      FilmColumns columns;
    };
    const Part orders(columns);
    const Counters c = render_frame(*scene, Window(300), {300, 300, 300}, orders,
                                    PlainShadowTesterFactory(), options, whole, nullptr);
    const std::uint64_t expected[] = {100, 130 * 130, 121, 14 * 14 / 2};
    const auto more = static_cast<std::uint64_t>(options.antialiasing.more_samples());
    EXPECT_EQ(c.camera_rays, expected[static_cast<int>(method)] + more * c.antialiased_pixels);
    EXPECT_EQ(whole.image.pixel(139, 145)[0], 0.0f);
    EXPECT_EQ(whole.image.pixel(145, 145)[0], 1.0f);
  }
}

}  // namespace
