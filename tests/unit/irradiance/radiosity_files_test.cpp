// Radiosity in files: a whole pass bit for bit, POV-Ray's lines of samples, and what is refused and why.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "core/irradiance/cache_bytes.h"
#include "core/irradiance/rca_samples.h"
#include "parser/options/options.h"
#include "tools/common/process.h"
#include "tools/session/radiosity_store.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

core::RadiositySettings kept_settings() {
  core::RadiositySettings settings;
  settings.recursion_limit = 2;
  return settings;
}

core::IrradianceSample kept_sample(double x) {
  return {core::Vec3(x, 1.0 / 3.0, -2.5e-7),
          core::Vec3(0, 1, 0),
          core::Vec3(0.6, 0, -0.8),
          core::Rgb(0.25f, 0.5f, 1.0f / 3.0f),
          0.125f,
          2e10f,
          0.7f};
}

core::IrradianceCache kept_cache() {
  core::IrradianceCache cache(kept_settings(), core::Vec3(0, 1, -4));
  for (const double x : {0.1, 0.2, 0.3}) cache.store(0).add(kept_sample(x));
  cache.store(1).add(kept_sample(7.0));
  cache.begin_sights(3, 2);
  cache.see({0, 0}, 1, {});
  cache.see({2, 1}, 3, {{core::Rgb(1, 2, 3), 0.5, true}, {core::Rgb(4, 5, 6), 0.25, false}});
  return cache;
}

core::RadiosityReport kept_report() {
  core::RadiosityReport report;
  report.levels = {{40, {{9, 2, 70, 1.5, 1}, {4, 1, 17, 0.0, 0}}}, {6, {{6, 1, 35, 2.0, 0}, {}}}};
  report.sees_pixels = true;
  return report;
}

TEST(UnitRadiosityBytes, APassComesBackBitForBit) {
  const std::string bytes = core::bytes_of(kept_cache());
  const auto back = core::cache_of(bytes, kept_settings(), core::Vec3(0, 1, -4));
  ASSERT_TRUE(back);
  EXPECT_EQ(core::bytes_of(*back), bytes);
  ASSERT_EQ(back->store(0).samples().size(), 3u);
  EXPECT_EQ(back->store(0).samples()[1].point.x, 0.2);
  EXPECT_EQ(back->sight({0, 0}).samples, 1u);
  EXPECT_EQ(back->sight({1, 0}).samples, 0u);
  const core::PixelSight sight = back->sight({2, 1});
  ASSERT_TRUE(sight.gathered);
  ASSERT_EQ(sight.gathered->size(), 2u);
  EXPECT_EQ((*sight.gathered)[1].light.g, 5.0f);
  EXPECT_EQ((*sight.gathered)[1].quality, 0.25);
  EXPECT_TRUE((*sight.gathered)[0].is_kept);
}

TEST(UnitRadiosityBytes, WhatIsCutOffIsNone) {
  const std::string bytes = core::bytes_of(kept_cache());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(core::cache_of({bytes.data(), size}, kept_settings(), {})) << size;
  EXPECT_FALSE(core::cache_of(bytes + "x", kept_settings(), {}));
}

TEST(UnitRadiosityLines, AreStocks) {
  const std::string text = core::rca_samples_text(kept_cache(), {2, 0});
  EXPECT_EQ(text,
            "C1\t0.3\t0.333333\t-2.5e-07\t7ffe7f\t0.2500\t0.5000\t0.3333\t0.125\t2e+10\tcb7f19\n"
            "C2\t7\t0.333333\t-2.5e-07\t7ffe7f\t0.2500\t0.5000\t0.3333\t0.125\t2e+10\tcb7f19\n");
  const core::RcaSamples read = core::read_rca_samples(text + "\n");
  EXPECT_EQ(read.passed_over, 0u);
  ASSERT_EQ(read.samples.size(), 2u);
  EXPECT_EQ(read.samples[1].depth, 1);
  EXPECT_EQ(read.samples[0].sample.normal.y, 1.0);
  EXPECT_NEAR(read.samples[0].sample.to_nearest.z, -0.8, 0.01);
  EXPECT_EQ(read.samples[0].sample.quality, 1.0f);
  EXPECT_EQ(core::read_rca_samples(text).samples.size(), 1u) << "stock loses the last line";
}

TEST(UnitRadiosityLines, OthersArePassedOver) {
  const char* const good = "C1\t0\t0\t0\t7ffe7f\t0.1\t0.1\t0.1\t1\t2\t7f7f7f";
  const core::RcaSamples read = core::read_rca_samples(
      std::string(good) +
      "\n\nP\nC1 0 0 0 7ffe7f .1 .1 .1 1 2\nC0 0 0 0 7ffe7f .1 .1 .1 1 2 7f7f7f\n" +
      "C1 0 0 0 7f7f7f .1 .1 .1 1 2 7f7f7f\nC1 0 0 0 7ffe7f .1 .1 .1 0 2 7f7f7f\n" +
      "C1 0 0 nan 7ffe7f .1 .1 .1 1 2 7f7f7f\nC1 1e30 0 0 7ffe7f .1 .1 .1 1e-9 2 7f7f7f\n" +
      "C1 0 0 0 7ffe7x .1 .1 .1 1 2 7f7f7f\nC1 0 0 0 7ffe7f .1 .1 .1 1 2 7f7f7f 3\n" + good +
      "\n\n");
  EXPECT_EQ(read.samples.size(), 2u);
  EXPECT_EQ(read.passed_over, 9u);
  EXPECT_EQ(read.first_passed_over, 3u);
}

class UnitRadiosityStore : public ::testing::Test {
 protected:
  parser::RenderOptions options(const std::string& name, bool reads, bool writes) const {
    parser::RenderOptions o;
    o.radiosity_file = (folder / name).string() + (name.ends_with('/') ? "/" : "");
    o.radiosity_from_file = reads;
    o.radiosity_to_file = writes;
    return o;
  }
  void keep(const std::string& name, const Identity& of) const {
    RadiosityStore store(options(name, false, true), of);
    store.read();
    store.keep(kept_cache(), kept_report());
    store.finish();
  }
  /// What it refuses to use; empty: it is used.
  std::string refusal(const std::string& name, const Identity& of) const {
    RadiosityStore store(options(name, true, true), of);
    try {
      store.read();
      const SavedRadiosity saved = store.pass(kept_settings(), core::Vec3(0, 1, -4));
      if (!saved.cache) return store.warnings().empty() ? "not there" : store.warnings().front();
      EXPECT_EQ(core::bytes_of(*saved.cache), core::bytes_of(kept_cache()));
      EXPECT_EQ(saved.report.levels.size(), 2u);
      EXPECT_EQ(saved.report.levels[0].depths[1].rays, 17u);
      return "";
    } catch (const parser::OptionError& error) {
      return error.what();
    }
  }
  fs::path only_file(const fs::path& in) const { return fs::directory_iterator(in)->path(); }

  const TemporaryFolder temporary;
  const fs::path folder = temporary.path();
  const Identity identity{"program 1", "Quality=9\nclock 0\n", {{{"", {17}}, {"a.inc", {4}}}}};
};

TEST_F(UnitRadiosityStore, APassIsUsedAgain) {
  EXPECT_EQ(refusal("a.light", identity), "not there");
  keep("a.light", identity);
  EXPECT_EQ(refusal("a.light", identity), "");
}

TEST_F(UnitRadiosityStore, AnotherPassIsRefusedWithTheDifference) {
  keep("a.light", identity);
  const auto expect = [&](const Identity& other, const char* text) {
    const std::string why = refusal("a.light", other);
    EXPECT_NE(why.find(text), std::string::npos) << why;
  };
  Identity other = identity;
  other.seen.files["a.inc"].sum = 5;
  expect(other, "a.inc has changed");
  other = identity;
  other.seen.files[""].sum = 18;
  expect(other, "the scene has changed");
  other = identity;
  other.options = "Quality=9\nclock 1\n";
  expect(other, "clock 0, and now there is clock 1");
  other = identity;
  other.program = "program 2";
  expect(other, "another version of the program");
}

TEST_F(UnitRadiosityStore, ADamagedFileIsRefused) {
  keep("a.light", identity);
  const std::string whole = read_text(folder / "a.light");
  for (const std::size_t at : {std::size_t{30}, whole.size() / 2, whole.size() - 1}) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    write_text(folder / "a.light", bytes);
    EXPECT_NE(refusal("a.light", identity), "") << at;
  }
  write_text(folder / "a.light", whole.substr(0, whole.size() - 1));
  EXPECT_NE(refusal("a.light", identity).find("damaged"), std::string::npos);
  write_text(folder / "a.light", "hello");
  EXPECT_NE(refusal("a.light", identity).find("no radiosity of this program"), std::string::npos);
  write_text(folder / "a.rca", whole);
  EXPECT_NE(refusal("a.rca", identity).find("not POV-Ray's"), std::string::npos);
}

TEST_F(UnitRadiosityStore, AFolderHasAFileForEachPass) {
  Identity other = identity;
  other.options = "Quality=8\n";
  keep("all/", identity);
  const fs::path file = only_file(folder / "all");
  EXPECT_EQ(refusal("all/", other), "not there");
  EXPECT_EQ(refusal("all/", identity), "");
  EXPECT_EQ(refusal("all", identity), "") << "a folder that is there needs no '/'";
  const std::string whole = read_text(file);
  write_text(file, whole.substr(0, 100));
  EXPECT_NE(refusal("all/", identity).find("made anew"), std::string::npos);
  keep("all/", identity);
  EXPECT_EQ(read_text(file), whole) << "equal passes have equal bytes";
}

TEST_F(UnitRadiosityStore, StocksFileGrows) {
  keep("a.rca", identity);
  const std::string first = read_text(folder / "a.rca");
  RadiosityStore store(options("a.rca", true, true), identity);
  store.read();
  ASSERT_EQ(store.samples().size(), 4u);
  core::IrradianceCache cache = kept_cache();
  cache.store(1).add(kept_sample(9.0));
  store.keep(cache, kept_report());
  EXPECT_EQ(read_text(folder / "a.rca"), first) << "not before the picture is there";
  store.finish();
  const std::string more = read_text(folder / "a.rca");
  EXPECT_TRUE(more.starts_with(first));
  EXPECT_TRUE(more.substr(first.size()).starts_with("C2\t9\t")) << more;
}

TEST_F(UnitRadiosityStore, WhatCannotBeKeptIsSaid) {
  RadiosityStore store(options("missing/a.light", false, true), identity);
  store.read();
  store.keep(kept_cache(), kept_report());
  EXPECT_THROW(store.finish(), parser::OptionError);
}

}  // namespace
}  // namespace lentray::tool
