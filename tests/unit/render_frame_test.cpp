#include "core/render/frame.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "core/geometry/sphere.h"
#include "core/render/plain_shadow_tester.h"

using namespace lentray::core;

namespace {

/// A wavy colour, so that each pixel is different.
struct Wavy final : Pigment {
  Colour colour(const Vec3& p) const override {
    return {Rgb(static_cast<float>(std::sin(p.x * 7) + 1), static_cast<float>(std::cos(p.y * 5) + 1),
                static_cast<float>(p.z * p.z)), 0, 0};
  }
  bool is_opaque() const override { return true; }
};

/// Parallel rays along z; the last column shows nothing.
struct Window final : RaySource {
  bool ray(double column, double row, Ray& ray) const override {
    ray = {{column / 16 - 2, 2 - row / 16, -5}, {0, 0, 1}};
    return column < 63;
  }
};

/// Jobs of rows; forwards or backwards.
struct Rows final : PixelOrder {
  explicit Rows(bool back) : backwards(back) {}
  std::size_t jobs() const override { return 64; }
  void pixels(std::size_t job, std::vector<Pixel>& out) const override {
    out.clear();
    const auto row = static_cast<std::uint32_t>(backwards ? 63 - job : job);
    for (std::uint32_t i = 0; i < 64; ++i) out.push_back({backwards ? 63 - i : i, row});
  }
  bool backwards;
};

struct Bar final : Progress {
  void advance(double fraction) override {
    const std::lock_guard lock(mutex);
    last = std::max(last, fraction);
    ++calls;
  }
  std::mutex mutex;
  double last = 0.0;
  int calls = 0;
};

std::unique_ptr<Scene> ball_scene() {
  SceneParts parts;
  parts.settings.background = {Rgb(0.25f, 0.5f, 0.75f), 0, 0};
  TextureLayer layer;
  layer.pigment = std::make_shared<Wavy>();
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

TEST(UnitCoreFrame, SameBitsForAnyOrderAndNumberOfThreads) {
  const auto scene = ball_scene();
  const PlainShadowTesterFactory shadows;
  Image first(64, 64);
  Bar bar;
  const Counters one = render_frame(*scene, Window(), Rows(false), shadows, {.threads = 1}, first,
                                    &bar);
  EXPECT_EQ(bar.last, 1.0);
  EXPECT_EQ(bar.calls, 64);
  EXPECT_EQ(one.camera_rays, 63u * 64);
  EXPECT_EQ(one.dark_pixels, 64u);
  ASSERT_EQ(one.lights.size(), 1u);
  EXPECT_GT(one.lights[0].rays, 0u);
  EXPECT_EQ(one.bounds_tests, 0u);
  EXPECT_GT(std::set<float>(first.rgba.begin(), first.rgba.end()).size(), 500u);
  for (const int threads : {2, 5}) {
    Image image(64, 64);
    const Counters c = render_frame(*scene, Window(), Rows(true), shadows,
                                    {.threads = threads, .count_tests = true}, image, nullptr);
    EXPECT_EQ(image.rgba, first.rgba);
    EXPECT_EQ(c.camera_rays, one.camera_rays);
    EXPECT_EQ(c.lights[0].rays, one.lights[0].rays);
    EXPECT_EQ(c.lights[0].blocked, one.lights[0].blocked);
    EXPECT_GT(c.bounds_tests, 0u);
    EXPECT_EQ(c.tests_by_type.at("sphere"), c.primitive_tests);
  }
}

TEST(UnitCoreFrame, PixelsWithoutRayAreBlackAndAlphaLeavesTheBackgroundOut) {
  const auto scene = ball_scene();
  Image opaque(64, 64), alpha(64, 64);
  const PlainShadowTesterFactory shadows;
  render_frame(*scene, Window(), Rows(false), shadows, {}, opaque, nullptr);
  render_frame(*scene, Window(), Rows(false), shadows, {.alpha = true}, alpha, nullptr);
  EXPECT_EQ(opaque.pixel(63, 5)[0], 0.0f);
  EXPECT_EQ(opaque.pixel(63, 5)[3], 1.0f);
  EXPECT_EQ(opaque.pixel(0, 0)[2], 0.75f);
  EXPECT_EQ(opaque.pixel(0, 0)[3], 1.0f);
  EXPECT_EQ(alpha.pixel(0, 0)[2], 0.0f);
  EXPECT_EQ(alpha.pixel(0, 0)[3], 0.0f);
  EXPECT_EQ(alpha.pixel(32, 32)[3], 1.0f);
  EXPECT_EQ(alpha.pixel(32, 32)[0], opaque.pixel(32, 32)[0]);
}

TEST(UnitCoreFrame, AFrameCanBeCancelled) {
  struct Stopper final : Progress {
    explicit Stopper(std::atomic<bool>& c) : cancel(c) {}
    void advance(double) override { cancel = true; }
    std::atomic<bool>& cancel;
  };
  const auto scene = ball_scene();
  const PlainShadowTesterFactory shadows;
  std::atomic<bool> cancel{false};
  Stopper stopper(cancel);
  Image image(64, 64);
  const Counters c = render_frame(*scene, Window(), Rows(false), shadows,
                                  {.threads = 2, .cancel = &cancel}, image, &stopper);
  EXPECT_GT(c.camera_rays, 0u);
  EXPECT_LT(c.camera_rays, 10u * 64);
}

TEST(UnitCoreFrame, WhatAThreadThrowsReachesTheCaller) {
  struct Broken final : RaySource {
    bool ray(double, double row, Ray&) const override {
      if (row > 40) throw std::runtime_error("no such ray");
      return false;
    }
  };
  const auto scene = ball_scene();
  Image image(64, 64);
  EXPECT_THROW(render_frame(*scene, Broken(), Rows(false), PlainShadowTesterFactory(),
                            {.threads = 3}, image, nullptr),
               std::runtime_error);
}

TEST(UnitCoreFrame, AsManyThreadsAsAskedForReallyRun) {
  struct Meeting final : RaySource {
    bool ray(double, double, Ray&) const override {
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
      if (threads.size() < 5) std::this_thread::yield();
      return false;
    }
    mutable std::mutex mutex;
    mutable std::set<std::thread::id> threads;
  };
  struct Slow final : PixelOrder {
    std::size_t jobs() const override { return 200; }
    void pixels(std::size_t job, std::vector<Pixel>& out) const override {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
      out.assign(1, {static_cast<std::uint32_t>(job % 64), static_cast<std::uint32_t>(job / 64)});
    }
  };
  const auto scene = ball_scene();
  Image image(64, 64);
  const Meeting camera;
  render_frame(*scene, camera, Slow(), PlainShadowTesterFactory(), {.threads = 5}, image, nullptr);
  EXPECT_EQ(camera.threads.size(), 5u);
}

}  // namespace
