// A radiosity pass that is stopped and gone on with: as often as one likes, with the bits of one that was not.
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/damaged_record.h"
#include "core/irradiance/cache_bytes.h"
#include "parser/options/options.h"
#include "tests/fuzz/memory_files.h"
#include "tools/common/process.h"
#include "tools/session/pass_file.h"
#include "tools/session/session.h"

namespace lentray::tool {
namespace {

constexpr const char* kStoppedScene =
    "#version 3.7; global_settings { assumed_gamma 1 radiosity { count 30 error_bound 0.5 "
    "recursion_limit 3 } }\ncamera { location <0, 1.2, -4.5> look_at <0, 0.9, 0> }\n"
    "light_source { <1.5, 3, -2> rgb 0.6 } background { rgb <0.3, 0.4, 0.6> }\n"
    "plane { y, 0 pigment { rgb <0.8, 0.8, 0.7> } } plane { -z, -2 pigment { rgb x } }\n"
    "sphere { <0.2, 0.5, 0.3>, 0.5 pigment { rgb 0.9 } finish { reflection 0.2 } }\n";

struct StoppedBands final : core::BandSink {
  void put(const core::Image& band, std::uint32_t) override {
    pixels.insert(pixels.end(), band.rgba.begin(), band.rgba.end());
  }
  std::vector<float> pixels;
};

/// Hands on to a file, and asks the run to stop after so many records.
class StoppingLedger final : public core::PassLedger {
 public:
  StoppingLedger(core::PassLedger& file, int records, std::atomic<bool>& stop)
      : m_file(file), m_left(records), m_stop(stop) {}
  void begin(std::size_t pass) override { m_file.begin(pass); }
  bool recall(std::string& record) override {
    const bool is_there = m_file.recall(record);
    recalled += is_there ? 1 : 0;
    return is_there;
  }
  void keep(std::string_view record) override {
    ++kept;
    m_file.keep(record);
    if (--m_left == 0) m_stop = true;
  }
  void finish() override { m_file.finish(); }
  int recalled = 0, kept = 0;

 private:
  core::PassLedger& m_file;
  int m_left;
  std::atomic<bool>& m_stop;
};

struct StoppedRun {
  StoppedRun() {
    files.add("scene.pov", kStoppedScene);
    Reading reading;
    reading.scene = "scene.pov";
    session.emplace(reading, files, [](parser::Diagnostics& diagnostics) {
      diagnostics.connect(parser::Stream::kWarning, {});
    });
    CameraOptions look;
    look.width = 48;
    look.height = 36;
    camera.emplace(session->camera(look));
  }
  std::vector<float> render(core::PassLedger* ledger, std::atomic<bool>& stop, int threads) {
    FilmSettings film;
    film.threads = threads;
    StoppedBands out;
    session->render(session->plan(*camera, film), {.sink = out, .passes = ledger, .cancel = &stop});
    return out.pixels;
  }
  const test::MemoryFiles::Library library;
  test::MemoryFiles files{library};
  std::optional<Session> session;
  std::optional<CameraSetup> camera;
};

TEST(UnitRadiosityGoingOn, StoppedTwentyTimesItHasTheBitsOfOneRun) {
  const TemporaryFolder folder;
  const std::string picture = (folder / "a.png").string();
  const Identity identity{"program", "option\n", {}};
  std::atomic<bool> stop{false};
  const std::vector<float> whole = StoppedRun().render(nullptr, stop, 1);
  ASSERT_FALSE(whole.empty());
  int known = 0;
  for (int run = 0; run < 20; ++run) {
    stop = false;
    PassFile file(picture, identity, std::chrono::milliseconds(0));
    file.go_on();
    StoppingLedger ledger(file, 3 + run, stop);
    StoppedRun().render(&ledger, stop, 1 + run % 3);
    ASSERT_TRUE(stop.load()) << "run " << run << " came to its end";
    EXPECT_EQ(ledger.recalled, known) << run;
    EXPECT_EQ(ledger.kept, 3 + run);
    known += ledger.kept;
    EXPECT_TRUE(file.write());
  }
  stop = false;
  PassFile file(picture, identity, std::chrono::milliseconds(0));
  file.go_on();
  StoppingLedger ledger(file, -1, stop);
  EXPECT_EQ(StoppedRun().render(&ledger, stop, 2), whole);
  EXPECT_EQ(ledger.recalled, known);
  EXPECT_GT(ledger.kept, 0);
}

TEST(UnitRadiosityGoingOn, RecordsOfAnotherKindAreRefused) {
  const TemporaryFolder folder;
  const std::string picture = (folder / "a.png").string();
  const Identity identity{"program", "option\n", {}};
  {
    PassFile file(picture, identity, std::chrono::milliseconds(0));
    file.begin(0);
    file.keep("no gather");
  }
  std::atomic<bool> never{false};
  PassFile file(picture, identity, std::chrono::milliseconds(0));
  file.go_on();
  EXPECT_THROW(StoppedRun().render(&file, never, 1), core::DamagedRecord);
}

}  // namespace
}  // namespace lentray::tool
