// Pictures of few bits against stock: palettes of TARGA, BMP, PNG and GIF files, whose entries are the heights
// of height fields, and TARGA files of five bits a colour.
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "tests/support/render.h"

namespace lentray::test {
namespace {

constexpr int kPaletteFilesSide = 12, kEntries = 16;

int entry(int pixel) {
  return (pixel % kPaletteFilesSide * 3 + pixel / kPaletteFilesSide * 7) % kEntries;
}

std::string word(int value) {
  return {static_cast<char>(value & 255), static_cast<char>(value >> 8 & 255)};
}

std::string bytes(std::initializer_list<int> values) {
  std::string all;
  for (const int value : values) all += static_cast<char>(value);
  return all;
}

/// Blue, green, red.
std::string colour(int i) {
  return bytes({(i * 97 + 7) % 256, (i * 31 + 90) % 256, (i * 53 + 20) % 256});
}
std::string five_bits(int i) {
  return word(0x8000 | (i * 7 + 3) % 32 << 10 | (i * 5 + 11) % 32 << 5 | (i * 3 + 1) % 32);
}

template <class Each>
std::string repeated(int count, Each&& each) {
  std::string all;
  for (int i = 0; i < count; ++i) all += each(i);
  return all;
}

std::string pixels() {
  return repeated(kPaletteFilesSide * kPaletteFilesSide, [](int i) { return bytes({entry(i)}); });
}

std::string targa_head(int type, int entry_bits, int bits, int alpha_bits) {
  const int entries = entry_bits > 0 ? kEntries : 0;
  return bytes({0, entries > 0 ? 1 : 0, type, 0, 0}) + word(entries) +
         bytes({entry_bits, 0, 0, 0, 0}) + word(kPaletteFilesSide) + word(kPaletteFilesSide) +
         bytes({bits, 0x20 | alpha_bits});
}

/// Entries 2 i and 2 i + 1 have one colour.
std::string twin(int i) {
  return bytes({(i / 2 * 53 + 20) % 256, (i / 2 * 31 + 90) % 256, (i / 2 * 97 + 7) % 256});
}

std::string chunk(const std::string& body) {
  const auto big = [](uLong v) {
    return bytes({int(v >> 24 & 255), int(v >> 16 & 255), int(v >> 8 & 255), int(v & 255)});
  };
  return big(body.size() - 4) + body +
         big(crc32(0, reinterpret_cast<const Bytef*>(body.data()), uInt(body.size())));
}

/// `kind`: 0 grey, 3 by palette. `pixels`: kPaletteFilesSide rows.
std::string png(int kind, const std::string& palette, const std::string& pixels) {
  const std::string rows = repeated(kPaletteFilesSide, [&](int y) {
    return std::string(1, '\0') +
           pixels.substr(static_cast<std::size_t>(y) * kPaletteFilesSide, kPaletteFilesSide);
  });
  uLongf size = compressBound(rows.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size,
           reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  return "\x89PNG\r\n\x1a\n" +
         chunk("IHDR" +
               bytes({0, 0, 0, kPaletteFilesSide, 0, 0, 0, kPaletteFilesSide, 8, kind, 0, 0, 0})) +
         palette + chunk("IDAT" + packed.substr(0, size)) + chunk("IEND");
}

std::string png_of_twins() { return png(3, chunk("PLTE" + repeated(kEntries, twin)), pixels()); }

/// Five bits a code, and a code that starts anew before they would have to grow. `extension` stands before the picture.
std::string gif_of_twins(const std::string& extension) {
  constexpr int kBits = 5, kClear = 16, kEnd = 17;
  std::vector<int> codes;
  for (int i = 0; i < kPaletteFilesSide * kPaletteFilesSide; ++i) {
    if (i % 8 == 0) codes.push_back(kClear);
    codes.push_back(entry(i));
  }
  codes.push_back(kEnd);
  std::string packed((codes.size() * kBits + 7) / 8, '\0');
  for (std::size_t i = 0; i < codes.size() * kBits; ++i) {
    if (codes[i / kBits] >> i % kBits & 1)
      packed[i / 8] = static_cast<char>(packed[i / 8] | 1 << i % 8);
  }
  return "GIF89a" + word(kPaletteFilesSide) + word(kPaletteFilesSide) + bytes({0xf3, 0, 0}) +
         repeated(kEntries, twin) + extension + "," + word(0) + word(0) + word(kPaletteFilesSide) +
         word(kPaletteFilesSide) + bytes({0, 4, static_cast<int>(packed.size())}) + packed +
         bytes({0, ';'});
}

std::string word4(int value) { return word(value) + word(value >> 16); }

/// `packing` 1 and 2: in runs of 8 and 4 bits.
std::string bitmap(int bits, int packing, const std::string& palette, const std::string& body) {
  const int start = 54 + static_cast<int>(palette.size());
  return "BM" + word4(start + static_cast<int>(body.size())) + word4(0) + word4(start) + word4(40) +
         word4(kPaletteFilesSide) + word4(kPaletteFilesSide) + word(1) + word(bits) +
         word4(packing) + word4(static_cast<int>(body.size())) + std::string(8, '\0') +
         word4(kEntries) + word4(0) + palette + body;
}

/// Red and blue are the other way round than in twin(), which tells nobody.
std::string twin_entries() {
  return repeated(kEntries, [](int i) { return twin(i) + std::string(1, '\0'); });
}

std::string halves(const std::string& row) {
  return repeated(static_cast<int>(row.size()) / 2, [&](int i) {
    return bytes(
        {row[static_cast<std::size_t>(2 * i)] << 4 | row[static_cast<std::size_t>(2 * i + 1)]});
  });
}

std::string bitmap_row(int y) {
  return pixels().substr(static_cast<std::size_t>(y) * kPaletteFilesSide, kPaletteFilesSide);
}

/// Each row has entries as they are, a run and a pair that is repeated; behind the last there is no end of row.
std::string bitmap_runs(int bits) {
  std::string body;
  for (int y = 0; y < kPaletteFilesSide; ++y) {
    const std::string row = bitmap_row(y);
    if (y > 0) body += bytes({0, 0});
    if (bits == 8) {
      body += bytes({0, 5}) + row.substr(0, 5) + bytes({0, 4, row[5], 0, 3}) + row.substr(9, 3) +
              bytes({0});
    } else {
      body += bytes({5, row[0] << 4 | row[1], 0, 7}) + halves(row.substr(5, 7) + '\0');
    }
  }
  return body + bytes({0, 1});
}

std::string file_of_twins(const std::string& name) {
  if (name == "twins.png") return png_of_twins();
  if (name == "twins.gif") return gif_of_twins("");
  if (name == "twins_clear.gif")
    return gif_of_twins("!" + bytes({0xf9, 4, 1, 0, 0, 5, 0}));  // entry 5 is clear
  if (name == "twins.bmp") return bitmap(8, 0, twin_entries(), pixels());
  if (name == "twins_runs.bmp") return bitmap(8, 1, twin_entries(), bitmap_runs(8));
  if (name == "twins_runs4.bmp") return bitmap(4, 2, twin_entries(), bitmap_runs(4));
  if (name == "twins4.bmp") {
    return bitmap(4, 0, twin_entries(), repeated(kPaletteFilesSide, [](int y) {
                    return halves(bitmap_row(y)) + word(0);
                  }));
  }
  const std::string palette = repeated(kEntries, twin);
  if (name == "twins.tga") return targa_head(1, 24, 8, 0) + palette + pixels();
  return targa_head(9, 24, 8, 0) + palette + repeated(kPaletteFilesSide, [](int y) {
           const std::string row =
               bitmap_row(y);  // five as they are, a run of three, four as they are
           return bytes({4}) + row.substr(0, 5) + bytes({0x82, row[5], 3}) + row.substr(8, 4);
         });
}

std::string file(const std::string& name) {
  if (name.starts_with("twins")) return file_of_twins(name);
  const auto rows = [](auto&& head) {
    return repeated(kPaletteFilesSide, [&](int y) {
      return head +
             pixels().substr(static_cast<std::size_t>(y) * kPaletteFilesSide, kPaletteFilesSide);
    });
  };
  if (name == "palette.tga") return targa_head(1, 24, 8, 0) + repeated(kEntries, colour) + pixels();
  if (name == "packed.tga")
    return targa_head(9, 24, 8, 0) + repeated(kEntries, colour) +
           rows(bytes({kPaletteFilesSide - 1}));
  if (name == "palette16.tga")
    return targa_head(1, 16, 8, 0) + repeated(kEntries, five_bits) + pixels();
  if (name == "colours16.tga") {
    return targa_head(2, 0, 16, 1) + repeated(kPaletteFilesSide * kPaletteFilesSide,
                                              [](int i) { return five_bits(entry(i)); });
  }
  if (name == "greys.tga") {
    return targa_head(3, 0, 8, 0) + repeated(kPaletteFilesSide * kPaletteFilesSide,
                                             [](int i) { return bytes({entry(i) * 16}); });
  }
  return bitmap(8, 0, repeated(kEntries, [](int i) { return colour(i) + std::string(1, '\0'); }),
                pixels());
}

constexpr const char* kWithPalette[] = {
    "palette.tga",    "packed.tga",      "palette16.tga",  "palette.bmp",      "twins.png",
    "twins.gif",      "twins_clear.gif", "twins.tga",      "twins_packed.tga", "twins.bmp",
    "twins_runs.bmp", "twins4.bmp",      "twins_runs4.bmp"};
constexpr const char* kWithoutPalette[] = {"colours16.tga", "greys.tga"};

class ImagePaletteFiles : public ::testing::TestWithParam<const char*> {};
using ImagePaletteFilesEntries = ImagePaletteFiles;

TEST_P(ImagePaletteFiles, HeightsAndColours) {
  const std::string name = GetParam(), type = name.substr(name.size() - 3);
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location <0,3,-3> look_at 0 "
      "angle 60 }\n"
      "light_source { <-4,7,-6>, 1 }\n"
      "height_field { " +
      type + " \"" + name +
      "\" scale <2.4,1,2.4> translate <-1.8,-.6,-1.2> pigment { rgb 1 } }\n"
      "plane { z, 1.5 pigment { image_map { " +
      type + " \"" + name + "\" } scale 1.5 } finish { ambient 1 diffuse 0 } }";
  EXPECT_TRUE(same_as_stock(
      {.sdl = sdl, .width = 96, .height = 72, .arguments = {}, .files = {{name, file(name)}}}));
}

/// Entries by number, in the order they are given in; transparency as a pattern; textures by entry.
TEST_P(ImagePaletteFilesEntries, ByNumber) {
  const std::string name = GetParam(), type = name.substr(name.size() - 3);
  const std::string glow = " finish { ambient 1 diffuse 0 }",
                    file_words = type + " \"" + name + "\" ";
  const auto wall = [](int column, const std::string& looks) {
    const double left = -1.6 + 0.8 * column;
    return "box { <" + std::to_string(left) + ",-1,0>, <" + std::to_string(left + .75) + ",1,.1> " +
           looks + " }\n";
  };
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "plane { z, 3 pigment { checker rgb 1 rgb x scale .3 } finish { ambient 1 diffuse 0 } }\n" +
      wall(0, "pigment { image_map { " + file_words +
                  "transmit 3, .6 filter 5, .8 filter all .2 filter 6, .9 } }" + glow) +
      wall(1, "pigment { image_map { " + file_words + "transmit all .5 transmit 4, .1 } }" + glow) +
      wall(2, "pigment { image_pattern { " + file_words +
                  "use_alpha } color_map { [0 rgb y] [1 rgb z] } }" + glow) +
      wall(3, "texture { material_map { " + file_words + "texture { pigment { rgb x }" + glow +
                  " } texture { pigment { rgb y }" + glow + " } texture { pigment { rgb z }" +
                  glow + " } } }");
  EXPECT_TRUE(same_as_stock(
      {.sdl = sdl, .width = 96, .height = 48, .arguments = {}, .files = {{name, file(name)}}}));
}

/// Both programs take an entry of the palette and refuse one behind its last, and any of a picture without one.
TEST_P(ImagePaletteFiles, EntriesThatAreNotThere) {
  const std::string name = GetParam(), type = name.substr(name.size() - 3);
  const bool has_palette = std::find(std::begin(kWithoutPalette), std::end(kWithoutPalette),
                                     name) == std::end(kWithoutPalette);
  const tool::TemporaryFolder folder;
  tool::write_text(folder / name, file(name));
  for (const std::string entry : {"filter all", "transmit 15,", "filter 16,"}) {
    tool::write_text(
        folder / "scene.pov",
        "#version 3.7; global_settings { assumed_gamma 1 }\nsphere { 0, 1 pigment { image_map { " +
            type + " \"" + name + "\"\n " + entry + " .5 } } }\n");
    const std::vector<std::string> arguments{"+Iscene.pov", "+Oa.png", "+W4", "+H3", "-D"};
    std::vector<std::string> stock_arguments{"povray"};
    stock_arguments.insert(stock_arguments.end(), arguments.begin(), arguments.end());
    const bool is_there = entry == "filter all" || (has_palette && entry == "transmit 15,");
    const tool::RunResult stock = tool::run_program(stock_arguments, folder.path(), 60.0);
    const tool::RunResult ours = run_lentray(arguments, folder.path());
    EXPECT_EQ(stock.status == 0, is_there) << entry << stock.output;
    EXPECT_EQ(ours.status, is_there ? 0 : 1) << entry << ours.output;
    const std::string place =
        "scene.pov:3:" + std::to_string(entry.find(' ') + 3) + ": error: expected ";
    EXPECT_EQ(ours.output.find(place) == std::string::npos, is_there) << place << ours.output;
  }
}

/// The upper bit of 16 is alpha though the head tells of none, and columns go from left to right whatever it tells.
TEST(ImagePaletteFilesNone, TargaFlagsThatNobodyHeeds) {
  const std::string map =
      targa_head(2, 0, 16, 0x10) + repeated(kPaletteFilesSide * kPaletteFilesSide,
                                            [](int i) { return word(i * 2654435 % 65536); });
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "plane { z, 3 pigment { checker rgb 1 rgb x scale .3 } finish { ambient 1 diffuse 0 } }\n"
      "plane { z, 0 pigment { image_map { tga \"flags.tga\" } } finish { ambient 1 diffuse 0 } }";
  EXPECT_TRUE(same_as_stock(
      {.sdl = sdl, .width = 64, .height = 48, .arguments = {}, .files = {{"flags.tga", map}}}));
}

/// Numbers of textures are as stored where there is no palette, too.
TEST(ImagePaletteFilesNone, MaterialsByRed) {
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "light_source { -9*z, 1 } plane { z, 0 texture { material_map { png \"plasma3.png\" texture "
      "{ pigment { rgb x } }"
      " texture { pigment { rgb y } } texture { pigment { rgb z } } } scale 2 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl, .width = 64, .height = 48, .arguments = {}, .files = {}}));
}

/// Greys 0 .. 143; each texture is a colour of its own.
TEST(ImagePaletteFilesNone, MaterialsByGrey) {
  std::string textures;
  for (int i = 0; i < kPaletteFilesSide * kPaletteFilesSide; ++i) {
    textures += "texture { pigment { rgb <" + std::to_string(i) + "," +
                std::to_string(i * 7 % 256) + ",99>/255 } finish { ambient 1 diffuse 0 } }\n";
  }
  const std::string greys =
      png(0, "", repeated(kPaletteFilesSide * kPaletteFilesSide, [](int i) { return bytes({i}); }));
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "plane { z, 0 texture { material_map { png \"greys.png\" " +
      textures + " } scale 2 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 96,
                             .height = 72,
                             .arguments = {"File_Gamma=1.0"},
                             .files = {{"greys.png", greys}}}));
}

/// Greys of other files than PNG are not cut to 8 bits once they are decoded.
TEST(ImagePaletteFilesNone, GreyMapsThatAreDecoded) {
  const std::string map = "P5\n12 12\n255\n" + repeated(kPaletteFilesSide * kPaletteFilesSide,
                                                        [](int i) { return bytes({i / 4}); });
  const std::string sdl =
      "#version 3.7; global_settings { assumed_gamma 1 } camera { location -3*z look_at 0 angle 50 "
      "}\n"
      "plane { z, 0 pigment { image_map { pgm \"greys.pgm\" gamma 1.6 } scale 2 } finish { ambient "
      "9 diffuse 0 } }";
  EXPECT_TRUE(same_as_stock({.sdl = sdl,
                             .width = 96,
                             .height = 72,
                             .arguments = {"File_Gamma=1.0"},
                             .files = {{"greys.pgm", map}}}));
}

std::string palette_files_name(const ::testing::TestParamInfo<const char*>& one) {
  std::string name = one.param;
  name[name.find('.')] = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Each, ImagePaletteFiles, ::testing::ValuesIn(kWithPalette),
                         palette_files_name);
INSTANTIATE_TEST_SUITE_P(None, ImagePaletteFiles, ::testing::ValuesIn(kWithoutPalette),
                         palette_files_name);
INSTANTIATE_TEST_SUITE_P(Each, ImagePaletteFilesEntries, ::testing::ValuesIn(kWithPalette),
                         palette_files_name);

}  // namespace
}  // namespace lentray::test
