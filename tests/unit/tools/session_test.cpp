// A session: read once, rendered often, with the bits of a fresh one each time; what it notes of
// its scene, and how it is stopped.
#include "tools/session/session.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "parser/options/options.h"
#include "parser/source/cancelled.h"
#include "tests/fuzz/memory_files.h"

namespace lentray::tool {
namespace {

constexpr const char* kSessionScene =
    "#version 3.7; global_settings { assumed_gamma 1 }\n"
    "camera { location <0,1,-5> look_at 0 } light_source { <3,5,-5>, 1 }\n"
    "sphere { <.5,0,1>, 1 pigment { checker rgb 1 rgb <1,.2,0> scale .3 } }\n";

struct SessionBands final : core::BandSink {
  void put(const core::Image& band, std::uint32_t) override {
    pixels.insert(pixels.end(), band.rgba.begin(), band.rgba.end());
  }
  std::vector<float> pixels;
};

/// Counts how often the scene is read.
class SessionFiles final : public parser::Files {
 public:
  explicit SessionFiles(const std::string& sdl) { m_files.add("scene.pov", sdl); }
  bool exists(const std::string& path) const override { return m_files.exists(path); }
  std::optional<std::string> find_loosely(const std::string& folder,
                                          const std::string& name) const override {
    return m_files.find_loosely(folder, name);
  }
  std::optional<std::string> read(const std::string& path) const override {
    ++reads;
    return m_files.read(path);
  }
  bool may_write(const std::string& path) const override { return m_files.may_write(path); }
  std::unique_ptr<parser::FileWriter> open(const std::string& path, bool append) override {
    return m_files.open(path, append);
  }
  mutable int reads = 0;

 private:
  const test::MemoryFiles::Library m_library;
  test::MemoryFiles m_files{m_library};
};

void session_silence(parser::Diagnostics& diagnostics) {
  diagnostics.connect(parser::Stream::kWarning, {});
}

struct OpenSession {
  explicit OpenSession(const std::string& sdl, const Reading& how = {}) : files(sdl) {
    Reading reading = how;
    reading.scene = "scene.pov";
    session.emplace(reading, files, session_silence);
  }
  std::vector<float> render(const CameraSetup& camera, const FilmSettings& film = {}) {
    SessionBands out;
    report = session->render(session->plan(camera, film), {.sink = out});
    return out.pixels;
  }
  SessionFiles files;
  std::optional<Session> session;
  shadow::RunReport report;
};

CameraOptions session_view(std::uint32_t view) {
  CameraOptions out;
  out.width = 60;
  out.height = 40;
  out.lenticular = true;
  out.views.count = 5;
  out.view = view;
  out.is_first_view = view == 0;
  return out;
}

TEST(UnitSession, ManyPicturesOfOneReadingHaveTheBitsOfTheirOwn) {
  OpenSession all(kSessionScene);
  const CameraSetup sheet = all.session->camera(session_view(0));
  all.session->drop_text();
  for (const std::uint32_t view : {0u, 3u, 4u}) {
    const CameraOptions options = session_view(view);
    OpenSession alone(kSessionScene);
    EXPECT_EQ(all.render(all.session->another_view(sheet, options)),
              alone.render(alone.session->camera(options)))
        << view;
    EXPECT_GT(alone.report.parse_cpu_s, 0.0);
    EXPECT_EQ(all.report.parse_cpu_s > 0.0, view == 0) << "of one picture alone";
  }
  EXPECT_EQ(all.files.reads, 1);
}

TEST(UnitSession, ThreadsAndBandsChangeNoBit) {
  OpenSession all(kSessionScene);
  const CameraSetup camera = all.session->camera({});
  const std::vector<float> expected = all.render(camera);
  for (const int threads : {1, 2, 5}) {
    FilmSettings film;
    film.threads = threads;
    film.band_height = 7;
    EXPECT_EQ(all.render(camera, film), expected) << threads;
    EXPECT_EQ(all.report.threads, threads);
    EXPECT_EQ(all.report.bands, 18u);
  }
}

TEST(UnitSession, PhotonsAreShotOnceForAllPictures) {
  OpenSession open(
      "#version 3.7; global_settings { assumed_gamma 1 photons { spacing .1 } }\n"
      "camera { location <0,1,-5> look_at 0 } light_source { <3,5,-5>, 1 }\n"
      "plane { y, -1 pigment { rgb 1 } } sphere { 0, 1 pigment { rgbf 1 } "
      "interior { ior 1.5 } photons { target refraction on } }");
  EXPECT_TRUE(open.session->has_passes());
  EXPECT_EQ(open.session->photons(), nullptr);
  const CameraSetup sheet = open.session->camera(session_view(0));
  const std::vector<float> first = open.render(sheet);
  ASSERT_EQ(open.report.passes.size(), 1u);
  EXPECT_EQ(open.report.passes[0].name, "photons");
  open.render(open.session->another_view(sheet, session_view(3)));
  EXPECT_TRUE(open.report.passes.empty());
  EXPECT_EQ(open.render(sheet), first);
}

TEST(UnitSession, LightBuffersAreThoseOfTheLargestPicture) {
  OpenSession all(kSessionScene);
  core::Scene const& scene = all.session->scene();
  CameraOptions options;
  const CameraSetup small = all.session->camera(options);
  options.width = options.height = 2000;
  const CameraSetup large = all.session->camera(options);
  EXPECT_EQ(scene.light_buffer(0), nullptr);
  const std::vector<float> before = all.render(small);
  ASSERT_NE(scene.light_buffer(0), nullptr);
  const auto cells = [&] { return scene.light_buffer(0)->statistics().cells; };
  const std::size_t few = cells();
  all.session->prepare(large.camera());
  const std::size_t many = cells();
  EXPECT_GT(many, few);
  EXPECT_EQ(all.render(small), before);
  EXPECT_EQ(cells(), many) << "finer ones are kept";

  Reading without;
  without.light_buffers = false;
  OpenSession plain(kSessionScene, without);
  EXPECT_EQ(plain.render(plain.session->camera({})), before);
  EXPECT_EQ(plain.session->scene().light_buffer(0), nullptr);
}

/// Of clock, frames, width and height: in which a picture may differ and be of the same reading.
std::string session_serves(const std::string& sdl) {
  const OpenSession all(kSessionScene + sdl);
  parser::ParserOptions clock, frame, width, height;
  clock.frame.clock = 0.5;
  frame.frame.frame_number = 3;
  width.image_width = 999;
  height.image_height = 999;
  std::string out;
  for (const auto& [letter, options] : {std::pair{'c', clock}, std::pair{'f', frame},
                                        std::pair{'w', width}, std::pair{'h', height}}) {
    if (all.session->serves(options)) out += letter;
  }
  return out;
}

TEST(UnitSession, NotesWhatTheSceneAsksForOfItsPicture) {
  EXPECT_EQ(session_serves(""), "cfwh");
  EXPECT_EQ(session_serves("#declare A = clock;"), "fwh");
  EXPECT_EQ(session_serves("#declare A = <1, clock_delta, 2>;"), "fwh");
  EXPECT_EQ(session_serves("#if (frame_number > 3) #end"), "cwh");
  EXPECT_EQ(session_serves("#for (I, 1, final_frame) #end"), "cwh");
  EXPECT_EQ(session_serves("#declare A = image_width / image_height;"), "cf");
  EXPECT_EQ(session_serves("#declare A = function(x) { x * image_width };"), "cfh");
  EXPECT_EQ(session_serves("#debug str(image_height, 0, 0)"), "cfw");
  EXPECT_EQ(session_serves("#macro M(A) #local B = A + 1; #end M(image_width)"), "cfh");
  EXPECT_EQ(session_serves("#macro M(A) sphere { A, 1 } #end M(image_width)"), "cfh");
  EXPECT_EQ(session_serves("sphere { image_width, 1 }"), "cfh");
  EXPECT_EQ(session_serves("#declare A = array[2] { 1, image_width }"), "cfh");
}

TEST(UnitSession, NamesThatAreOnlyMentionedAreNotRead) {
  EXPECT_EQ(session_serves("#ifdef (image_width) #end"), "cfwh");
  EXPECT_EQ(session_serves("#declare image_width = 3; #declare A = image_width;"), "cfwh");
  EXPECT_EQ(session_serves("#macro M() image_width + clock #end"), "cfwh");
  EXPECT_EQ(session_serves("#if (false) #declare A = frame_number; #end"), "cfwh");
}

TEST(UnitSession, AReadingCanBeStopped) {
  for (const char* endless :
       {"#while (1) #end", "#macro M() #end #while (1) M() #end", "#for (I, 1, 1e9) #end"}) {
    std::atomic<bool> cancel{false};
    std::thread other([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      cancel = true;
    });
    Reading reading;
    reading.parser.cancel = &cancel;
    EXPECT_THROW(OpenSession(endless, reading), parser::Cancelled) << endless;
    other.join();
  }
  // Between statements too.
  const std::atomic<bool> now{true};
  Reading reading;
  reading.parser.cancel = &now;
  EXPECT_THROW(OpenSession(kSessionScene, reading), parser::Cancelled);
}

TEST(UnitSession, ErrorsOfFilms) {
  OpenSession all(kSessionScene);
  const CameraSetup camera = all.session->camera({});
  FilmSettings film;
  film.part.start_row = 121;
  EXPECT_THROW(all.session->plan(camera, film), parser::OptionError);
  film.part.start_row = 31;
  EXPECT_EQ(all.session->plan(camera, film).pixels, 160u * 90u);
  film.max_memory = 1000;
  EXPECT_THROW(all.session->plan(camera, film), parser::OptionError);
}

}  // namespace
}  // namespace lentray::tool
