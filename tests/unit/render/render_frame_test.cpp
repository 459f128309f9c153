#include "core/render/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/object/leaf.h"
#include "core/shape/sphere.h"
#include "core/trace/illumination.h"
#include "core/trace/plain_shadow_tester.h"
#include "core/trace/thread_context.h"

using namespace lentray::core;

namespace {

/// A wavy colour, so that each pixel is different.
struct Wavy final : Pigment {
  Colour colour(const Vec3& p, const SurfaceContext&) const override {
    return {Rgb(static_cast<float>(std::sin(p.x * 7) + 1),
                static_cast<float>(std::cos(p.y * 5) + 1), static_cast<float>(p.z * p.z)),
            0, 0};
  }
  bool is_opaque() const override { return true; }
};

/// Parallel rays along z; the last column shows nothing.
struct RenderFrameWindow final : RaySource {
  bool ray(double column, double row, Ray& ray) const override {
    ray = {{column / 16 - 2, 2 - row / 16, -5}, {0, 0, 1}};
    return column < 63;
  }
};

/// Jobs of rows; forwards or backwards.
struct RenderFrameRows final : PixelOrder {
  RenderFrameRows(std::uint32_t first, std::uint32_t end, bool back)
      : top(first), bottom(end), backwards(back) {}
  std::size_t jobs() const override { return bottom - top; }
  void pixels(std::size_t job, std::vector<Pixel>& out) const override {
    out.clear();
    const auto step = static_cast<std::uint32_t>(job);
    const std::uint32_t row = backwards ? bottom - 1 - step : top + step;
    for (std::uint32_t i = 0; i < 64; ++i) out.push_back({backwards ? 63 - i : i, row});
  }
  std::uint32_t top, bottom;
  bool backwards;
};

struct RenderFrameRowBands final : BandOrders {
  explicit RenderFrameRowBands(bool back = false) : backwards(back) {}
  std::unique_ptr<PixelOrder> band(std::uint32_t top, std::uint32_t bottom) const override {
    return std::make_unique<RenderFrameRows>(top, bottom, backwards);
  }
  bool backwards;
};

/// Puts the bands together again.
struct RenderFrameWhole final : BandSink {
  void put(const Image& band, std::uint32_t top) override {
    EXPECT_FALSE(busy.exchange(true)) << "two bands at a time";
    EXPECT_EQ(top, next);
    ASSERT_LE(top + band.height, image.height);
    std::copy_n(band.pixel(0, 0), std::size_t{4} * band.width * band.height, image.pixel(0, top));
    next = top + band.height;
    ++bands;
    busy = false;
  }
  Image image{64, 64};
  std::uint32_t next = 0;
  int bands = 0;
  std::atomic<bool> busy{false};
};

struct Bar final : Progress {
  void advance(double fraction, double) override {
    const std::lock_guard lock(mutex);
    last = std::max(last, fraction);
    ++calls;
  }
  std::mutex mutex;
  double last = 0.0;
  int calls = 0;
};

/// `clear`: for +UA, with a background that is clear.
std::unique_ptr<Scene> ball_scene(bool clear = false) {
  SceneParts parts;
  parts.settings.alpha = clear;
  parts.settings.background = {Rgb(0.25f, 0.5f, 0.75f), 0, clear ? 1.0f : 0.0f};
  TextureLayer layer;
  layer.pigment = std::make_shared<Wavy>();
  layer.finish = std::make_shared<Finish>();
  parts.textures.push_back(std::make_shared<LayeredTexture>(std::vector{layer}));
  for (const Vec3& c : {Vec3{0, 0, 0}, Vec3{0.8, 0.8, -0.8}}) {
    auto leaf = std::make_unique<Leaf>(std::make_unique<Sphere>(c, 1.0), Transform());
    Attributes a;
    a.texture = parts.textures.front().get();
    leaf->set_attributes(a);
    parts.objects.push_back(std::move(leaf));
  }
  Light light;
  light.position = {5, 8, -10};
  light.colour = Rgb(1.0f);
  parts.lights.push_back(light);
  return std::make_unique<Scene>(std::move(parts), CompileOptions{});
}

TEST(UnitCoreFrame, SameBitsForAnyOrderBandAndNumberOfThreads) {
  const auto scene = ball_scene();
  const PlainShadowTesterFactory shadows;
  RenderFrameWhole first;
  Bar bar;
  const Counters one = render_frame(*scene, RenderFrameWindow(), {64, 64, 64},
                                    RenderFrameRowBands(), shadows, {.threads = 1}, first, &bar);
  EXPECT_EQ(bar.last, 1.0);
  EXPECT_EQ(bar.calls, 1) << "a frame of less than a second";
  EXPECT_EQ(first.bands, 1);
  EXPECT_EQ(one.camera_rays, 63u * 64);
  EXPECT_EQ(one.dark_pixels, 64u);
  ASSERT_EQ(one.lights.size(), 1u);
  EXPECT_GT(one.lights[0].rays, 0u);
  EXPECT_EQ(one.bounds_tests, 0u);
  EXPECT_GT(std::set<float>(first.image.rgba.begin(), first.image.rgba.end()).size(), 500u);
  for (const int threads : {1, 2, 5}) {
    for (const std::uint32_t height : {1u, 7u, 32u, 63u, 64u}) {
      RenderFrameWhole whole;
      const Counters c =
          render_frame(*scene, RenderFrameWindow(), {64, 64, height}, RenderFrameRowBands(true),
                       shadows, {.threads = threads, .count_tests = true}, whole, nullptr);
      EXPECT_EQ(whole.image.rgba, first.image.rgba) << threads << " threads, bands of " << height;
      EXPECT_EQ(whole.next, 64u);
      EXPECT_EQ(whole.bands, static_cast<int>((64 + height - 1) / height));
      EXPECT_EQ(c.camera_rays, one.camera_rays);
      EXPECT_EQ(c.lights[0].rays, one.lights[0].rays);
      EXPECT_EQ(c.lights[0].blocked, one.lights[0].blocked);
      EXPECT_GT(c.bounds_tests, 0u);
      EXPECT_EQ(c.tests_by_type.at("sphere"), c.primitive_tests);
    }
  }
}

TEST(UnitCoreFrame, ThreadsHaveWhatPassesLeft) {
  struct Spy final : ShadowTesterFactory {
    std::unique_ptr<ShadowTester> make(ThreadContext& context) const override {
      const std::lock_guard lock(mutex);
      seen.push_back(context.illumination);
      return std::make_unique<PlainShadowTester>(context);
    }
    mutable std::mutex mutex;
    mutable std::vector<const Illumination*> seen;
  };
  const auto scene = ball_scene();
  const Illumination light;
  for (const Illumination* given : {&light, static_cast<const Illumination*>(nullptr)}) {
    Spy spy;
    RenderFrameWhole whole;
    render_frame(*scene, RenderFrameWindow(), {64, 64, 20}, RenderFrameRowBands(), spy,
                 {.threads = 2, .illumination = given}, whole, nullptr);
    EXPECT_EQ(spy.seen, (std::vector<const Illumination*>{given, given}));
  }
}

TEST(UnitCoreFrame, PixelsWithoutRayAreBlackAndAlphaLeavesTheBackgroundOut) {
  const auto scene = ball_scene(), clear_scene = ball_scene(true);
  RenderFrameWhole opaque, alpha;
  const PlainShadowTesterFactory shadows;
  render_frame(*scene, RenderFrameWindow(), {64, 64, 20}, RenderFrameRowBands(), shadows, {},
               opaque, nullptr);
  render_frame(*clear_scene, RenderFrameWindow(), {64, 64, 20}, RenderFrameRowBands(), shadows,
               {.alpha = true}, alpha, nullptr);
  EXPECT_EQ(opaque.image.pixel(63, 5)[0], 0.0f);
  EXPECT_EQ(opaque.image.pixel(63, 5)[3], 1.0f);
  EXPECT_EQ(opaque.image.pixel(0, 0)[2], 0.75f);
  EXPECT_EQ(opaque.image.pixel(0, 0)[3], 1.0f);
  EXPECT_EQ(alpha.image.pixel(0, 0)[2], 0.0f);
  EXPECT_EQ(alpha.image.pixel(0, 0)[3], 0.0f);
  EXPECT_EQ(alpha.image.pixel(32, 32)[3], 1.0f);
  EXPECT_EQ(alpha.image.pixel(32, 32)[0], opaque.image.pixel(32, 32)[0]);
}

TEST(UnitCoreFrame, AFrameCanBeCancelled) {
  struct Stopper final : RaySource {
    explicit Stopper(std::atomic<bool>& c) : cancel(c) {}
    bool ray(double column, double row, Ray& out) const override {
      if (row > 3) cancel = true;
      return RenderFrameWindow().ray(column, row, out);
    }
    std::atomic<bool>& cancel;
  };
  const auto scene = ball_scene();
  const PlainShadowTesterFactory shadows;
  for (const std::uint32_t height : {8u, 64u}) {
    std::atomic<bool> cancel{false};
    Stopper stopper(cancel);
    RenderFrameWhole whole;
    Bar bar;
    const Counters c = render_frame(*scene, stopper, {64, 64, height}, RenderFrameRowBands(),
                                    shadows, {.threads = 2, .cancel = &cancel}, whole, &bar);
    EXPECT_LT(bar.last, 1.0);
    EXPECT_GT(c.camera_rays, 0u);
    EXPECT_LT(c.camera_rays, 10u * 64);
    EXPECT_EQ(whole.bands, 0) << "an unfinished band was passed on";
  }
}

TEST(UnitCoreFrame, WhatAThreadThrowsReachesTheCaller) {
  struct Broken final : RaySource {
    bool ray(double, double row, Ray&) const override {
      if (row > 40) throw std::runtime_error("no such ray");
      return false;
    }
  };
  const auto scene = ball_scene();
  for (const std::uint32_t height : {1u, 16u, 64u}) {
    RenderFrameWhole whole;
    EXPECT_THROW(render_frame(*scene, Broken(), {64, 64, height}, RenderFrameRowBands(),
                              PlainShadowTesterFactory(), {.threads = 3}, whole, nullptr),
                 std::runtime_error);
    EXPECT_LE(whole.next, 41u);
  }
}

TEST(UnitCoreFrame, WhatTheSinkThrowsEndsTheFrame) {
  struct Full final : BandSink {
    void put(const Image&, std::uint32_t top) override {
      ++calls;
      if (top >= 8) throw std::runtime_error("no space left");
    }
    int calls = 0;
  };
  const auto scene = ball_scene();
  for (const int threads : {1, 2, 5}) {
    Full full;
    EXPECT_THROW(render_frame(*scene, RenderFrameWindow(), {64, 64, 4}, RenderFrameRowBands(),
                              PlainShadowTesterFactory(), {.threads = threads}, full, nullptr),
                 std::runtime_error);
    EXPECT_EQ(full.calls, 3);
  }
}

TEST(UnitCoreFrame, ASlowSinkHoldsTheThreadsBackButNotTheNextBand) {
  struct Slow final : BandSink {
    void put(const Image&, std::uint32_t top) override {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      most_ahead = std::max(most_ahead, newest.load() - static_cast<int>(top));
    }
    std::atomic<int> newest{0};
    int most_ahead = 0;
  };
  struct Watched final : RaySource {
    explicit Watched(Slow& s) : sink(s) {}
    bool ray(double, double row, Ray&) const override {
      int seen = sink.newest;
      while (row > seen && !sink.newest.compare_exchange_weak(seen, static_cast<int>(row))) {
      }
      return false;
    }
    Slow& sink;
  };
  const auto scene = ball_scene();
  Slow sink;
  const Watched camera(sink);
  render_frame(*scene, camera, {64, 64, 4}, RenderFrameRowBands(), PlainShadowTesterFactory(),
               {.threads = 2}, sink, nullptr);
  EXPECT_GE(sink.most_ahead, 4) << "nobody rendered while a band was written";
  EXPECT_LT(sink.most_ahead, 8) << "more bands in memory than two";
}

TEST(UnitCoreFrame, AnEmptyImageIsNoTrouble) {
  const auto scene = ball_scene();
  RenderFrameWhole whole;
  render_frame(*scene, RenderFrameWindow(), {0, 0, 1}, RenderFrameRowBands(),
               PlainShadowTesterFactory(), {}, whole, nullptr);
  EXPECT_EQ(whole.bands, 0);
}

TEST(UnitCoreFrame, AsManyThreadsAsAskedForReallyRun) {
  struct Meeting final : RaySource {
    bool ray(double, double, Ray&) const override {
      std::unique_lock lock(mutex);
      threads.insert(std::this_thread::get_id());
      all_there.notify_all();
      // The first wait for the others, however slowly these start.
      all_there.wait_for(lock, std::chrono::seconds(20), [this] { return threads.size() >= 5; });
      return false;
    }
    mutable std::mutex mutex;
    mutable std::condition_variable all_there;
    mutable std::set<std::thread::id> threads;
  };
  struct Single final : PixelOrder {
    std::size_t jobs() const override { return 200; }
    void pixels(std::size_t job, std::vector<Pixel>& out) const override {
      out.assign(1, {static_cast<std::uint32_t>(job % 64), static_cast<std::uint32_t>(job / 64)});
    }
  };
  struct SingleBand final : BandOrders {
    std::unique_ptr<PixelOrder> band(std::uint32_t, std::uint32_t) const override {
      return std::make_unique<Single>();
    }
  };
  const auto scene = ball_scene();
  RenderFrameWhole whole;
  const Meeting camera;
  render_frame(*scene, camera, {64, 64, 64}, SingleBand(), PlainShadowTesterFactory(),
               {.threads = 5}, whole, nullptr);
  EXPECT_EQ(camera.threads.size(), 5u);
}

}  // namespace
