// Options of lentray about views and quilts: values, contradictions, sizes, the loop of pictures.
#include <gtest/gtest.h>

#include "parser/options/create_ini.h"
#include "parser/options/options.h"

namespace lentray::parser {
namespace {

RenderOptions views_read(const std::vector<std::string>& words) { return read_options(words, {}); }

std::string views_message(const std::vector<std::string>& words) {
  try {
    (void)views_read(words);
  } catch (const OptionError& error) {
    return error.what();
  }
  return {};
}

TEST(UnitViewsOptions, PicturesOfViewsAreALoop) {
  const RenderOptions all = views_read({"a.pov", "Views=12", "View_Size=80x60"});
  EXPECT_EQ(all.views.count, 12u);
  EXPECT_EQ(all.views.size, (PixelSize{80, 60}));
  ASSERT_TRUE(is_animation(all.animation));
  const auto frames = frames_of(all.animation);
  ASSERT_EQ(frames.size(), 12u);
  EXPECT_EQ(frames[3].digits, "03");
  EXPECT_FALSE(frames[3].clock.clock_on);
  RenderOptions one = all;
  one.frame_digits = "07";
  EXPECT_EQ(rendered_view(one), 7u);
  const RenderOptions alone = views_read({"a.pov", "Views=12", "View=5"});
  EXPECT_FALSE(is_animation(alone.animation));
  EXPECT_EQ(rendered_view(alone), 5u);
  EXPECT_FALSE(rendered_view(views_read({"a.pov"})).has_value());
}

TEST(UnitViewsOptions, ASubsetOfTheViews) {
  const auto digits = [](const std::vector<std::string>& words) {
    std::string out;
    for (const AnimationFrame& frame : frames_of(views_read(words).animation))
      out += frame.digits + " ";
    return out;
  };
  EXPECT_EQ(digits({"a.pov", "Views=12", "+SF3", "+EF5"}), "03 04 05 ");
  EXPECT_EQ(digits({"a.pov", "Views=12", "+SF10"}), "10 11 ");
  EXPECT_EQ(digits({"a.pov", "Views=12", "+EF0"}), "00 ");
  EXPECT_EQ(digits({"a.pov", "Views=12", "+SF0.5", "+STP3", "+EF90"}), "06 09 ");
  const auto clocks =
      frames_of(views_read({"a.pov", "Views=5", "View_Clock=0..1", "+SF3"}).animation);
  EXPECT_EQ(clocks.front().clock.clock, 0.75);
}

TEST(UnitViewsOptions, TheClockRunsOverTheViews) {
  const auto frames = frames_of(views_read({"a.pov", "Views=5", "View_Clock=-1..1"}).animation);
  ASSERT_EQ(frames.size(), 5u);
  EXPECT_EQ(frames[0].clock.clock, -1.0);
  EXPECT_EQ(frames[3].clock.clock, 0.5);
  EXPECT_EQ(frames[4].clock.clock, 1.0);
  EXPECT_TRUE(frames[0].clock.clock_on);
  EXPECT_EQ(views_read({"a.pov", "Views=5", "View=1", "View_Clock=0..1"}).clock, 0.25);
  EXPECT_EQ(frames_of(views_read({"a.pov", "Views=2", "+K0.5"}).animation)[1].clock.clock, 0.5);
}

TEST(UnitViewsOptions, Quilts) {
  const RenderOptions whole = views_read({"a.pov", "Quilt=8x6", "+W3360", "+H3360"});
  EXPECT_EQ(whole.views.size, (PixelSize{420, 560}));
  EXPECT_EQ(whole.width, 420);
  EXPECT_EQ(whole.height, 560);
  EXPECT_FALSE(whole.views.aspect.has_value());
  const RenderOptions named = views_read({"a.pov", "Quilt=Portrait"});
  EXPECT_EQ(named.views.size, (PixelSize{420, 560}));
  EXPECT_EQ(named.views.aspect, 0.75);
  const RenderOptions small = views_read({"a.pov", "Quilt=go", "Quilt_Tile=20x30"});
  EXPECT_EQ(small.views.size, (PixelSize{20, 30}));
  EXPECT_EQ(small.views.quilt->columns, 11u);
  EXPECT_EQ(small.views.aspect, 0.5625);
  // Of a lens sheet, whose integral image keeps its size.
  const RenderOptions sheet = views_read({"a.pov", "Quilt=5x3", "Views=15", "+W1200", "+H600"});
  EXPECT_EQ(sheet.width, 1200);
  EXPECT_EQ(sheet.views.size, (PixelSize{240, 200}));
  for (const char* name : {"portrait", "go", "16-portrait", "27-landscape", "27-portrait",
                           "32-landscape", "32-portrait"}) {
    EXPECT_EQ(views_message({"a.pov", std::string("Quilt=") + name}), "") << name;
  }
}

TEST(UnitViewsOptions, TheIniFileAsksForTheSameAgain) {
  for (const auto& words : std::vector<std::vector<std::string>>{
           {"a.pov", "Views=12", "View_Size=80x60", "View_Clock=0..0.5", "Lenticular=On"},
           {"a.pov", "Views=12", "View=3", "Lenticular=On"},
           {"a.pov", "Quilt=portrait", "View_Cone=50"},
           {"a.pov", "Quilt=5x3", "Views=15", "+W1200", "+H600", "Quilt_Aspect=1.5"}}) {
    const std::string text = ini_text(views_read(words));
    std::vector<std::string> again;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      again.push_back(text.substr(at, end - at));
      at = end + 1;
    }
    std::erase_if(again,
                  [](const std::string& line) { return line.find("_Return=") != line.npos; });
    EXPECT_EQ(ini_text(views_read(again)), text) << words[1];
  }
}

TEST(ErrorViewsOptions, EveryMessage) {
  const std::pair<std::vector<std::string>, const char*> rows[] = {
      {{"Views=0"}, "Views=0"},
      {{"View_Size=80"}, "a size such as 420x560 is expected"},
      {{"View_Size=0x5"}, "a size such as 420x560 is expected"},
      {{"Quilt=8"},
       "columns x rows of views are expected, such as 8x6, or a display: portrait, go"},
      {{"Quilt=8x6000"}, "columns x rows of views are expected"},
      {{"Quilt=8x6", "+W3361", "+H3360"},
       "a quilt of 3361 pixels is not divided into 8 columns: take 3360, or say Quilt_Tile=WxH"},
      {{"Quilt=8x6", "+W3360", "+H3361"}, "is not divided into 6 rows: take 3360"},
      {{"Quilt=8x6", "View=3"}, "Quilt= has all views: View= does not go with it"},
      {{"Quilt=8x6", "View_Clock=0..1"}, "View_Clock= does not go with Quilt="},
      {{"Quilt=8x6", "Views=15"}, "Views=15 and a quilt of 8 x 6 views contradict each other"},
      {{"Quilt=8x6", "Views=48", "View_Cone=30"}, "View_Cone= and Views= contradict each other"},
      {{"Views=5", "+SF5"}, "leave no view: the views are 0 to 4"},
      {{"Views=5", "+SF3", "+EF2"}, "leave no view: the views are 0 to 4"},
      {{"View_Cone=30"}, "View_Cone= is of quilts"},
      {{"Quilt=8x6", "View_Cone=180"}, "an angle below 180 degrees is expected"},
      {{"Quilt_Aspect=1"}, "Quilt_Aspect= is of quilts"},
      {{"View_Size=8x6"}, "View_Size= is of the pictures of Views= and Quilt="},
      {{"View_Clock=0..1"}, "View_Clock= is of the pictures of Views="},
      {{"Views=3", "View_Clock=0-1"}, "two clocks are expected, such as 0..1"},
      {{"Views=3", "View_Clock=0..x"}, "two clocks are expected, such as 0..1"},
      {{"Views=3", "View=3"}, "there is no view 3: the views are 0 to 2"},
      {{"Views=3", "+KFF9"}, "name one View="}};
  for (const auto& [words, part] : rows) {
    const std::string text = views_message(words);
    EXPECT_NE(text.find(part), std::string::npos) << "got: " << text << "\nwanted: " << part;
  }
}

}  // namespace
}  // namespace lentray::parser
