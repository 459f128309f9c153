#include "shadow/report.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "camera/sheet_views.h"
#include "shadow/tester_factory.h"
#include "tools/session/statistics.h"

using namespace lentray;

namespace {

shadow::RunReport shadow_report_sample() {
  shadow::RunReport r;
  r.scene = "a.pov";
  r.width = 30;
  r.height = 20;
  r.counters.camera_rays = 600;
  r.counters.reflected_rays = 5;
  r.counters.refracted_rays = 7;
  r.counters.bounds_tests = 11;
  r.counters.primitive_tests = 13;
  r.counters.tests_by_type["sphere"] = 13;
  r.counters.lights = {{100, 40, 50, 30, 20}, {10, 4, 5, 3, 2}};
  r.tests_counted = true;
  r.band_height = 7;
  r.bands = 3;
  r.threads = 2;
  r.peak_bytes = 1 << 20;
  r.memory = {{"descriptions", 3000}, {"light_buffers", 200}};
  r.wall_s = 1.5;
  return r;
}

TEST(UnitShadowReport, HasTheKeysOfTheStatistics) {
  const nlohmann::json j = shadow::to_json(shadow_report_sample());
  EXPECT_EQ(j["image"]["width"], 30);
  EXPECT_EQ(j["image"]["height"], 20);
  EXPECT_EQ(j["bands"]["height"], 7);
  EXPECT_EQ(j["bands"]["count"], 3);
  EXPECT_EQ(j["rays"]["camera"], 600);
  EXPECT_EQ(j["rays"]["reflected"], 5);
  EXPECT_EQ(j["rays"]["refracted"], 7);
  EXPECT_EQ(j["rays"]["shadow"], 110);
  EXPECT_EQ(j["shadow"]["rays"], 110);
  EXPECT_EQ(j["shadow"]["blocked"], 44);
  EXPECT_EQ(j["shadow"]["cache"]["probes"], 55);
  EXPECT_EQ(j["shadow"]["cache"]["hits"], 33);
  EXPECT_EQ(j["shadow"]["cache"]["misses"], 22);
  ASSERT_EQ(j["lights"].size(), 2u);
  EXPECT_EQ(j["lights"][1]["shadow"]["cache"]["hits"], 3);
  EXPECT_EQ(j["tests"]["bounds"], 11);
  EXPECT_EQ(j["tests"]["primitives"], 13);
  EXPECT_EQ(j["tests"]["by_type"]["sphere"], 13);
  EXPECT_EQ(j["threads"], 2);
  EXPECT_EQ(j["memory"]["peak_bytes"], 1 << 20);
  EXPECT_EQ(j["memory"]["stages"]["descriptions"], 3000);
  EXPECT_EQ(j["memory"]["stages"]["light_buffers"], 200);
  for (const char* key :
       {"parse_cpu_s", "compile_cpu_s", "render_cpu_s", "write_cpu_s", "wall_s"}) {
    EXPECT_TRUE(j["time"][key].is_number()) << key;
  }
  EXPECT_FALSE(j.contains("lens"));
  EXPECT_FALSE(j.contains("passes"));
}

TEST(UnitShadowReport, PassesHaveTheirNumbers) {
  shadow::RunReport r = shadow_report_sample();
  r.passes = {{"first", 1.5, 2.5, {{"samples", 12.0}, {"share", 0.25}}}, {"second", 0.5, 0.5, {}}};
  const nlohmann::json j = shadow::to_json(r);
  ASSERT_EQ(j["passes"].size(), 2u);
  EXPECT_EQ(j["passes"][0]["name"], "first");
  EXPECT_EQ(j["passes"][0]["wall_s"], 1.5);
  EXPECT_EQ(j["passes"][0]["cpu_s"], 2.5);
  EXPECT_EQ(j["passes"][0]["numbers"]["samples"], 12);
  EXPECT_EQ(j["passes"][0]["numbers"]["share"], 0.25);
  EXPECT_EQ(j["passes"][1]["name"], "second");
}

TEST(UnitShadowReport, LensKeysAndTheInfiniteViewingDistance) {
  tool::CameraSetup camera;
  const auto lens_of = [&] {
    return tool::statistics(shadow_report_sample(), camera, {}).at("lens");
  };
  camera::LensParameters lens;
  camera.sheet = std::make_shared<camera::Lenticular>(lens, camera::SheetPlacement{}, 30, 20);
  EXPECT_DOUBLE_EQ(lens_of()["pitch_mm"], 1.124);
  EXPECT_DOUBLE_EQ(lens_of()["pixels"], 15.0);
  EXPECT_EQ(lens_of()["view_distance_mm"], 0.0);
  // A quilt of a cone's views says nothing of lenses itself.
  const auto quilt_of = [&] {
    return std::make_shared<camera::Quilt>(
        std::vector<std::shared_ptr<const camera::Camera>>{
            camera::make_view(*camera.sheet, 0, 3, 4, 5)},
        1, camera::Properties{});
  };
  camera.view = quilt_of();
  EXPECT_TRUE(lens_of()["view_distance_mm"].is_null());
  lens.view_distance = 400.0;
  camera.sheet = std::make_shared<camera::Lenticular>(lens, camera::SheetPlacement{}, 30, 20);
  camera.view = quilt_of();
  EXPECT_DOUBLE_EQ(lens_of()["view_distance_mm"], 400.0);
}

TEST(ErrorShadowTesters, UnknownNameListsWhatThereIs) {
  try {
    shadow::make_tester_factory("magic");
    FAIL() << "no exception";
  } catch (const std::invalid_argument& e) {
    EXPECT_STREQ(
        e.what(),
        "unknown shadow cache 'magic': there are auto, off, last, depth, tree, neighbourhood, "
        "grid, cascade");
  }
}

}  // namespace
