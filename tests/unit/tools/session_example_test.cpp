// The program of docs/architecture.md, "How a program uses a session": what stands between the two
// lines of dashes is what stands on the page.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "tools/common/process.h"

// ---
#include "parser/files/files.h"
#include "tools/session/session.h"

/// Keeps the bands of a picture; core/render/band_sink.h.
struct Bands final : lentray::core::BandSink {
  void put(const lentray::core::Image& band, std::uint32_t) override { list.push_back(band); }
  std::vector<lentray::core::Image> list;
};

/// The scene's own picture, then three views of a lens sheet: one reading, four pictures.
void render_four(const std::string& scene, std::vector<Bands>& pictures) {
  lentray::tool::Reading reading;
  reading.scene = scene;
  lentray::tool::Session session(reading, lentray::parser::disk_files());
  const lentray::tool::FilmSettings film;

  lentray::tool::CameraOptions look;
  look.width = 64;
  look.height = 48;
  const lentray::tool::CameraSetup own = session.camera(look);
  session.render(session.plan(own, film), {.sink = pictures[0]});

  look.lenticular = true;
  look.views.count = 3;
  const lentray::tool::CameraSetup sheet = session.camera(look);
  for (std::uint32_t view = 0; view < 3; ++view) {
    look.view = view;
    const lentray::tool::CameraSetup eye = session.another_view(sheet, look);
    session.render(session.plan(eye, film), {.sink = pictures[1 + view]});
  }
}
// ---

namespace lentray {
namespace {

std::string session_example_between(const std::string& text, const std::string& first,
                                    const std::string& last) {
  const std::size_t begin = text.find(first) + first.size();
  return text.substr(begin, text.find(last, begin) - begin);
}

TEST(UnitSessionExample, StandsOnThePage) {
  const std::filesystem::path root = LENTRAY_SOURCE_DIR;
  const std::string own = session_example_between(
      tool::read_text(root / "tests/unit/tools/session_example_test.cpp"), "// ---\n", "// ---\n");
  const std::string page = tool::read_text(root / "docs/architecture.md");
  ASSERT_NE(page.find("```cpp\n"), std::string::npos);
  EXPECT_EQ(session_example_between(page, "```cpp\n", "```"), own);
}

TEST(UnitSessionExample, RendersFourPictures) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov",
                   "#version 3.7; global_settings { assumed_gamma 1 }\n"
                   "camera { location <0,1,-5> look_at 0 } light_source { <3,5,-5>, 1 }\n"
                   "sphere { <.5,0,1>, 1 pigment { checker rgb 1 rgb <1,.2,0> scale .3 } }\n");
  std::vector<Bands> pictures(4);
  render_four((folder / "a.pov").string(), pictures);
  for (const Bands& picture : pictures) {
    ASSERT_FALSE(picture.list.empty());
    EXPECT_EQ(picture.list[0].width, 64u);
  }
  EXPECT_NE(pictures[1].list[0].rgba, pictures[3].list[0].rgba);
  // The middle eye is the scene's own.
  const std::vector<float>&own = pictures[0].list[0].rgba, &middle = pictures[2].list[0].rgba;
  ASSERT_EQ(own.size(), middle.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < own.size(); ++i) different += std::fabs(own[i] - middle[i]) > 1e-3f;
  EXPECT_LT(different, own.size() / 100);
}

}  // namespace
}  // namespace lentray
