// Every output type, its bits, alpha, gamma and dithering, written by both programs: files that hold the same samples
// in the same layout, with tags by which viewers show the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/image/png_chunks.h"
#include "core/image/writer.h"
#include "tests/support/render.h"

namespace lentray::test {
namespace {

namespace fs = std::filesystem;
using FileTypesWords = std::vector<std::string>;

constexpr const char* kScene = R"(
camera { location -5*z look_at 0 angle 40 }
light_source { <5,8,-9> rgb 1 }
background { rgbt <.2,.3,.6,.4> }
sphere { 0, 1 pigment { rgb <.9,.4,.1> } finish { phong .9 } }
sphere { <1,.8,.2>, .7 pigment { rgbt <.3,.9,.2,.6> } finish { phong 1 } }
plane { y, -1 pigment { gradient x color_map { [0 rgb 0] [1 rgb .3] } scale 7 } })";

/// Both programs' files of a scene: in folders "stock" and "lentray".
class Both {
 public:
  Both(const std::string& sdl, const FileTypesWords& words) : m_words(words) {
    tool::write_text(m_folder / "a.pov", sdl);
    FileTypesWords all{"+Ia.pov", "+W83", "+H61", "-D", "-V"};
    all.insert(all.end(), words.begin(), words.end());
    for (const char* who : {"stock", "lentray"}) {
      const fs::path place = m_folder / who;
      fs::create_directory(place);
      FileTypesWords command{who == std::string("stock") ? "povray" : program("lentray").string()};
      command.insert(command.end(), all.begin(), all.end());
      command.push_back("+O" + std::string(who) + "/");
      const auto result = tool::run_program(command, m_folder.path(), 60.0);
      EXPECT_EQ(result.status, 0) << who << ": " << result.output;
    }
  }
  fs::path file(const char* who) const {
    for (const auto& entry : fs::directory_iterator(m_folder / who)) return entry.path();
    return {};
  }
  StoredImage image(const char* who) const { return core::read_image(file(who)); }

  /// Samples that differ by more than `most` steps of the file; the names and layouts are the same.
  std::size_t differing(float most = 0.0f) const {
    EXPECT_EQ(file("stock").filename(), file("lentray").filename());
    const StoredImage a = image("stock"), b = image("lentray");
    EXPECT_EQ(a.channels, b.channels);
    EXPECT_EQ(a.bits, b.bits);
    EXPECT_EQ(a.samples.size(), b.samples.size());
    EXPECT_EQ(a.gamma, b.gamma);
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.samples.size(), b.samples.size()); ++i) {
      if (std::fabs(a.samples[i] - b.samples[i]) > most) ++count;
    }
    return count;
  }

 private:
  FileTypesWords m_words;
  tool::TemporaryFolder m_folder;
};

std::string with_head(const std::string& head) { return head + kScene; }

/// Of 5063 pixels' samples: where shading differs in its last bit.
constexpr std::size_t kFew = 15;

class ImageFileTypes : public ::testing::TestWithParam<FileTypesWords> {};

TEST_P(ImageFileTypes, AreStocks) {
  for (const char* alpha : {"-UA", "+UA"}) {
    FileTypesWords words = GetParam();
    words.emplace_back(alpha);
    for (const char* head :
         {"#version 3.7; global_settings { assumed_gamma 1 }", "#version 3.6;"}) {
      EXPECT_LE(Both(with_head(head), words).differing(), kFew) << words[0] << alpha << head;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ImageFileTypes,
                         ::testing::Values(FileTypesWords{"+FN"}, FileTypesWords{"+FN5"},
                                           FileTypesWords{"+FN12"}, FileTypesWords{"+FN16"},
                                           FileTypesWords{"+FNg"}, FileTypesWords{"+FT"},
                                           FileTypesWords{"+FC"}, FileTypesWords{"+FJ"},
                                           FileTypesWords{"+FJ", "Compression=40"},
                                           FileTypesWords{"+FP"}, FileTypesWords{"+FP10"},
                                           FileTypesWords{"+FP16"}, FileTypesWords{"+FB"},
                                           FileTypesWords{"+FE"}, FileTypesWords{"+FH"},
                                           FileTypesWords{"+FT", "File_Gamma=1"}));

class ImageDither : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageDither, IsStocks) {
  const std::string head = "#version 3.7; global_settings { assumed_gamma 1 }";
  // One line's error is carried on whole, and rounding with it.
  const std::size_t few = GetParam() == std::string("D1") ? 500 : kFew;
  for (const FileTypesWords& type :
       {FileTypesWords{"+FN"}, FileTypesWords{"+FN5", "+UA"}, FileTypesWords{"+FT"}}) {
    FileTypesWords words = type;
    words.push_back(std::string("+TH") + GetParam());
    const Both both(with_head(head), words);
    EXPECT_LE(both.differing(), few);
    FileTypesWords plain = type;
    plain.emplace_back("-THFS");
    EXPECT_FALSE(same_bits(both.image("lentray"), Both(with_head(head), plain).image("lentray")));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, ImageDither, ::testing::Values("B2", "B3", "B4", "D1", "D2", "FS"));

/// Chunks before the pixels that say how to show them.
std::string gamma_chunks(const fs::path& png) {
  std::string said;
  for (const char* name : {"gAMA", "sRGB"}) {
    std::ifstream file(png, std::ios::binary);
    const auto length = core::find_png_chunk(file, name);
    if (!length) continue;
    std::string body(*length, '\0');
    file.read(body.data(), static_cast<std::streamsize>(body.size()));
    said += name + body;
  }
  return said;
}

TEST(ImagePngGamma, ChunksAndValuesAreStocks) {
  for (const char* head :
       {"", "#version 3.5;", "#version 3.6;", "#version 3.6; global_settings { assumed_gamma 1 }",
        "global_settings { assumed_gamma 2.2 }",
        "#version 3.7; global_settings { assumed_gamma 1 }",
        "#version 3.7; global_settings { assumed_gamma 2.2 }",
        "#version 3.7; global_settings { assumed_gamma srgb }"}) {
    for (const FileTypesWords& words :
         {FileTypesWords{}, FileTypesWords{"File_Gamma=1"},
          FileTypesWords{"File_Gamma=1.8", "+FN16"}, FileTypesWords{"File_Gamma=srgb"},
          FileTypesWords{"File_Gamma=2.2"}, FileTypesWords{"Display_Gamma=1.8"}}) {
      const Both both(with_head(head), words);
      const std::string which = std::string(head) + (words.empty() ? "" : words[0]);
      EXPECT_LE(both.differing(), kFew) << which;
      EXPECT_NE(gamma_chunks(both.file("stock")), "") << which;
      EXPECT_EQ(gamma_chunks(both.file("lentray")), gamma_chunks(both.file("stock"))) << which;
    }
  }
}

constexpr const char* kClear = R"(
camera { orthographic location -5*z look_at 0 right 8*x up 6*y }
light_source { <0,0,-900> rgb 1 }
sphere { 0, 1 pigment { rgbt <.9,.4,.1,.6> } finish { ambient .3 diffuse .6 } }
sphere { -2.4*x, 1 pigment { rgb 0 } finish { reflection .8 ambient 0 diffuse 0 } }
sphere { 2.4*x, 1 pigment { rgbt 1 } finish { ambient 0 diffuse 0 phong 1 } interior { ior 1.3 } }
)";

class ImageAlpha : public ::testing::TestWithParam<const char*> {};

TEST_P(ImageAlpha, OfBackgroundsIsStocks) {
  for (const char* version : {"", "#version 3.5;", "#version 3.6;", "#version 3.7;"}) {
    for (const char* alpha : {"+UA", "-UA"}) {
      const std::string sdl =
          version + std::string("global_settings { assumed_gamma 1 }") + GetParam() + kClear;
      EXPECT_LE(Both(sdl, {alpha}).differing(), kFew) << version << alpha;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, ImageAlpha,
    ::testing::Values("", "background { rgb <.2,.3,.6> }", "background { rgbt <.2,.3,.6,.5> }",
                      "background { rgbt <.2,.3,.6,1> }", "background { rgbf <.2,.3,.6,.5> }",
                      "background { rgbft <.2,.3,.6,.3,.2> }",
                      "sky_sphere { pigment { rgb <.5,.2,.1> } }",
                      "sky_sphere { pigment { gradient y color_map { [0 rgbt <.5,.2,.1,.4>] [1 "
                      "rgbf <.5,.2,.9,.4>] } } }",
                      "background { rgb <.2,.3,.6> } sky_sphere { pigment { rgbt <.5,.2,.1,.4> } }",
                      "fog { distance 8 rgbt <.5,.5,.9,.3> } background { rgbt <.2,.3,.6,.4> }"));

TEST(ImageFileNames, AreStocks) {
  for (const FileTypesWords& words :
       {FileTypesWords{"+Iin/x.y.pov"}, FileTypesWords{"+Iin/x.y.pov", "+Oq"},
        FileTypesWords{"+Is.pov", "+Osub"}, FileTypesWords{"+Is.pov", "+Osub/"},
        FileTypesWords{"+Is.pov", "+Osub/.png"}, FileTypesWords{"+Is.pov", "+O.png"},
        FileTypesWords{"+Is.pov", "+Oq."}, FileTypesWords{"+Is.pov", "+Oq.PNG"},
        FileTypesWords{"+Is.pov", "+Oq.tga"}, FileTypesWords{"+Is.pov", "+Oq.tga", "+FC"},
        FileTypesWords{"+Is.pov", "+Oq.jpeg", "+FJ"}, FileTypesWords{"+Is.pov", "+Oq.png", "+FB"},
        FileTypesWords{"+Is.pov", "+Oq", "+FPg"}, FileTypesWords{"+Is.pov", "+Oq.tif", "+FN"},
        FileTypesWords{"+Is.pov", "-FJ", "+F"},
        FileTypesWords{"+Is.pov", "+Oq.tga", "+FT", "+KFI9", "+KFF10"}}) {
    std::vector<std::string> names;
    for (const std::string& renderer : {std::string("povray"), program("lentray").string()}) {
      const tool::TemporaryFolder folder;
      fs::create_directory(folder / "in");
      fs::create_directory(folder / "sub");
      for (const char* scene : {"s.pov", "in/x.y.pov"})
        tool::write_text(folder / scene, "#version 3.7; camera { }");
      FileTypesWords command{renderer, "+W4", "+H3", "-D"};
      command.insert(command.end(), words.begin(), words.end());
      EXPECT_EQ(tool::run_program(command, folder.path(), 60.0).status, 0);
      std::vector<std::string> made;
      for (const auto& entry : fs::recursive_directory_iterator(folder.path())) {
        if (!entry.is_regular_file() || entry.path().extension() == ".pov") continue;
        made.push_back(entry.path().lexically_relative(folder.path()).string());
      }
      std::sort(made.begin(), made.end());
      std::string all;
      for (const std::string& name : made) all += name + " ";
      names.push_back(all);
    }
    EXPECT_EQ(names[1], names[0]) << words.back();
  }
}

TEST(ImageDiffProgram, ComparesWhatViewersShow) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "a.pov",
                   with_head("#version 3.7; global_settings { assumed_gamma 1 }"));
  const auto render = [&](const FileTypesWords& more) {
    FileTypesWords words{"+Ia.pov", "+W40", "+H30", "-V"};
    words.insert(words.end(), more.begin(), more.end());
    ASSERT_EQ(run_lentray(words, folder.path()).status, 0);
  };
  render({"+Osrgb.png"});
  render({"+Ogamma.png", "File_Gamma=1.8", "+FN16"});
  render({"+Olight", "+FE"});
  render({"+Oclear.png", "+UA", "+FN16"});
  render({"+Oclear", "+UA", "+FE"});
  const auto compare = [&](const char* a, const char* b) {
    return run_diff({a, b, "--no-pictures", "--grade", "exact"}, folder.path()).status;
  };
  EXPECT_EQ(compare("srgb.png", "gamma.png"), 0);
  EXPECT_EQ(compare("srgb.png", "light.exr"), 0);
  EXPECT_EQ(compare("clear.png", "clear.exr"), 0);
  EXPECT_EQ(compare("clear.png", "srgb.png"), 1);
  // The same values, of which one file says something else.
  const std::string bytes = tool::read_text(folder / "gamma.png");
  core::StoredImage image = core::read_image(folder / "gamma.png");
  image.attributes.clear();
  core::write_stored(image, folder / "untagged.png");
  EXPECT_EQ(compare("gamma.png", "untagged.png"), 1);
}

}  // namespace
}  // namespace lentray::test
