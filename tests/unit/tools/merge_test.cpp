// lentray-merge's command line, its rows, and the heads of PNG files.
#include <gtest/gtest.h>

#include <stdexcept>

#include "core/image/writer.h"
#include "parser/options/options.h"
#include "tests/unit/image/written_image.h"
#include "tools/common/process.h"
#include "tools/lentray-merge/arguments.h"
#include "tools/lentray-merge/join.h"
#include "tools/lentray-merge/png_head.h"

namespace lentray::merge {
namespace {

using MergeWords = std::vector<std::string>;

std::string error_of(const MergeWords& words) {
  try {
    parse_arguments(words);
  } catch (const parser::OptionError& e) {
    return e.what();
  }
  return "no error";
}

TEST(UnitMerge, Arguments) {
  const Arguments a = parse_arguments({"a.png", "--out", "x.png", "b.png", "--rows=1-60,61-61"});
  EXPECT_EQ(a.parts, (std::vector<std::filesystem::path>{"a.png", "b.png"}));
  EXPECT_EQ(a.out, "x.png");
  EXPECT_EQ(a.rows, (std::vector<Rows>{{1, 60}, {61, 61}}));
}

TEST(UnitMerge, WrongArguments) {
  EXPECT_EQ(error_of({}), "no parts are given; lentray-merge --help lists all options");
  EXPECT_EQ(error_of({"a.png"}), "--out PICTURE is missing");
  EXPECT_EQ(error_of({"a.png", "--out"}), "--out needs a value");
  EXPECT_EQ(error_of({"a.png", "--out="}), "option --out=: the name of a file is expected");
  EXPECT_EQ(error_of({"a.png", "--ou=x.png"}),
            "unknown option '--ou'; there are --out --rows --help --version");
  EXPECT_EQ(error_of({"a.png", "b.png", "--out=x.png", "--rows=1-2"}),
            "--rows names 1 parts, but there are 2");
  EXPECT_EQ(error_of({"a.png", "--out=x.png", "--rows=9-2"}),
            "option --rows=9-2: '9-2' end before they start");
  for (const char* rows : {"", "0-3", "1-", "-3", "1-x", "1-2,", "1:2", "99999999999"}) {
    EXPECT_NE(error_of({"a.png", "--out=x.png", std::string("--rows=") + rows})
                  .find("are no rows; 1-60 is the form"),
              std::string::npos)
        << rows;
  }
}

TEST(UnitMerge, RowsInWords) {
  EXPECT_EQ(text_of({{7, 7}}), "row 7");
  EXPECT_EQ(text_of({{1, 60}}), "rows 1 to 60");
  EXPECT_EQ(text_of({{1, 60}, {70, 70}, {90, 99}}), "rows 1 to 60, 70 and 90 to 99");
}

TEST(UnitMerge, MissingRows) {
  EXPECT_TRUE(missing_rows({{61, 120}, {1, 60}}, 120).empty());
  EXPECT_TRUE(missing_rows({{1, 100}, {20, 30}, {90, 120}}, 120).empty());
  EXPECT_EQ(missing_rows({{11, 60}, {71, 100}}, 120),
            (std::vector<Rows>{{1, 10}, {61, 70}, {101, 120}}));
  EXPECT_EQ(missing_rows({}, 5), (std::vector<Rows>{{1, 5}}));
}

/// Pictures of 4 x 6 pixels whose rows are grey, or black outside of `rows`.
class UnitMergeFiles : public ::testing::Test {
 protected:
  std::string write(const std::string& name, const Rows& rows, const core::ImageFormat& format = {},
                    const core::ImageMetadata& metadata = {}, std::uint32_t height = 6) const {
    core::Image image(4, height);
    for (std::uint32_t y = 0; y < height; ++y) {
      if (!rows.holds(y + 1)) continue;
      const float grey = 0.1f * static_cast<float>(y + 1);
      for (std::size_t i = 0; i < 16; ++i) image.rgba[16 * y + i] = i % 4 == 3 ? 1.0f : grey;
    }
    core::write_image(image, m_folder / name, format, metadata);
    return (m_folder / name).string();
  }
  std::string join_error(const std::vector<Part>& parts) const {
    try {
      join(parts, m_folder / "out.png");
    } catch (const core::ImageError& e) {
      std::string text = e.what();
      for (std::size_t at; (at = text.find(m_folder.path().string() + "/")) != std::string::npos;) {
        text.erase(at, m_folder.path().string().size() + 1);
      }
      return text;
    }
    return "no error";
  }
  const tool::TemporaryFolder m_folder;
};

TEST_F(UnitMergeFiles, AllTheHeadIsKept) {
  const core::ImageMetadata data{
      .dpi_x = 300.5,
      .dpi_y = 720.0,
      .software = "Lentray",
      .description = "a sheet",
      .fields = {{"lentray:lens_pitch", "1.124"}, {"lentray:empty", ""}}};
  for (const int bits : {5, 8, 10, 16}) {
    for (const bool alpha : {false, true}) {
      for (const bool srgb : {false, true}) {
        for (const bool grey : {false, true}) {
          core::ImageFormat format{
              .bits = bits, .srgb = srgb, .file_gamma = 1.83, .alpha = alpha, .grey = grey};
          const std::string whole = write("whole.png", {1, 6}, format, data);
          const std::string a = write("a.png", {1, 2}, format, data),
                            b = write("b.png", {3, 6}, format, data);
          EXPECT_EQ(join_error({{b}, {a}}), "no error");
          EXPECT_EQ(tool::read_text(m_folder / "out.png"), tool::read_text(whole))
              << bits << alpha << srgb << grey;
          EXPECT_EQ(join_error({{a, Rows{1, 2}}, {b, Rows{3, 6}}}), "no error");
          EXPECT_EQ(tool::read_text(m_folder / "out.png"), tool::read_text(whole))
              << bits << alpha << srgb << grey;
        }
      }
    }
  }
}

TEST_F(UnitMergeFiles, RowsFromTheFile) {
  const core::ImageMetadata plain{.software = "Lentray", .description = "", .fields = {}};
  core::ImageMetadata upper = plain, lower = plain;
  upper.fields = {{"lentray:rows", "1-4"}};
  lower.fields = {{"lentray:rows", "5-6"}};
  // Rows 3 and 4 are black, which does not make them missing.
  const std::string a = write("a.png", {1, 2}, {}, upper), b = write("b.png", {5, 6}, {}, lower);
  EXPECT_EQ(join_error({{b}, {a}}), "no error");
  EXPECT_EQ(read_head(m_folder / "out.png").rows, std::nullopt)
      << "a whole picture says nothing of its rows";
  EXPECT_EQ(join_error({{a}}), "cannot make 'out.png': rows 5 to 6 are in no part");
  // What --rows says comes first.
  EXPECT_EQ(join_error({{a, Rows{1, 3}}, {b}}), "cannot make 'out.png': row 4 is in no part");
  lower.fields = {{"lentray:rows", "5-"}};
  const std::string wrong = write("c.png", {5, 6}, {}, lower);
  EXPECT_EQ(join_error({{wrong}}),
            "cannot read 'c.png': its text lentray:rows: '5-' are no rows; 1-60 is the form");
}

TEST_F(UnitMergeFiles, MissingAndCommonRows) {
  const std::string a = write("a.png", {1, 4}), b = write("b.png", {3, 6}),
                    c = write("c.png", {5, 5});
  EXPECT_EQ(join_error({{a}, {b}}), "no error") << "rows 3 and 4 are equal";
  EXPECT_EQ(join_error({{a}, {c}}),
            "cannot make 'out.png': row 6 is black in every part, or missing: "
            "--rows gives the rows of each part");
  EXPECT_EQ(join_error({{a, Rows{1, 4}}, {c, Rows{5, 5}}}),
            "cannot make 'out.png': row 6 is in no part");
  EXPECT_EQ(join_error({{a, Rows{1, 6}}, {b, Rows{3, 6}}}),
            "'a.png' and 'b.png' disagree in row 5");
  EXPECT_EQ(join_error({{a, Rows{1, 7}}}), "'a.png' has 6 rows, and cannot have rows 1 to 7");
  EXPECT_EQ(join_error({{a, Rows{1, 6}}}), "no error") << "rows 5 and 6 are black then";
}

TEST_F(UnitMergeFiles, PartsOfDifferentPictures) {
  const std::string a = write("a.png", {1, 3});
  const auto error = [&](const std::string& other) { return join_error({{a}, {other}}); };
  const std::string begin =
      "'a.png' and 'b.png' are not parts of one picture: they differ in their ";
  EXPECT_EQ(error(write("b.png", {4, 6}, {}, {}, 7)), begin + "size: 4 x 6 and 4 x 7");
  EXPECT_EQ(error(write("b.png", {4, 6}, {.bits = 16})),
            begin + "samples: 8 bits of colour and 16 bits of colour");
  EXPECT_EQ(error(write("b.png", {4, 6}, {.alpha = true})),
            begin + "samples: 8 bits of colour and 8 bits of colour with alpha");
  EXPECT_EQ(error(write("b.png", {4, 6}, {.srgb = false})), begin + "gamma");
  core::ImageMetadata resolution, texts;
  resolution.dpi_x = resolution.dpi_y = 100.0;
  texts.fields = {{"lentray:lens_pitch", "1"}};
  EXPECT_EQ(error(write("b.png", {4, 6}, {}, resolution)), begin + "resolution");
  EXPECT_EQ(error(write("b.png", {4, 6}, {}, texts)), begin + "text 'lentray:lens_pitch'");
}

TEST_F(UnitMergeFiles, FilesThatCannotBeRead) {
  const std::string a = write("a.png", {1, 6});
  tool::write_text(m_folder / "out.png", "what stood there");
  EXPECT_EQ(join_error({{m_folder / "none.png"}}),
            "cannot read 'none.png': No such file or directory");
  EXPECT_NE(join_error({{m_folder.path()}}).find("it is a folder"), std::string::npos);
  tool::write_text(m_folder / "b.png", "GIF89a, or nearly");
  EXPECT_EQ(join_error({{m_folder / "b.png"}}),
            "cannot read 'b.png': it is no PNG file, and only these are joined");
  const std::string whole = tool::read_text(a);
  for (std::size_t length = 8; length < whole.size() - 12; length += 3) {
    tool::write_text(m_folder / "b.png", whole.substr(0, length));
    EXPECT_TRUE(join_error({{m_folder / "b.png"}}).starts_with("cannot read 'b.png': ")) << length;
  }
  std::string flipped = whole;
  flipped[whole.find("IDAT") + 9] ^= 1;
  tool::write_text(m_folder / "b.png", flipped);
  EXPECT_TRUE(join_error({{m_folder / "b.png"}}).starts_with("cannot read 'b.png': "));
  EXPECT_EQ(tool::read_text(m_folder / "out.png"), "what stood there");
  std::size_t files = 0;
  for (const auto& file : std::filesystem::directory_iterator(m_folder.path()))
    files += file.path() != "" ? 1 : 0;
  EXPECT_EQ(files, 3u) << "temporary files are gone";
}

TEST_F(UnitMergeFiles, OutputsThatCannotBeWritten) {
  const std::string a = write("a.png", {1, 6});
  const auto error = [&](const std::string& out) {
    try {
      join({{a}}, out);
    } catch (const core::ImageError& e) {
      return std::string(e.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(error("a.tif"), "cannot write 'a.tif': parts are joined as .png");
  EXPECT_EQ(error("/none/a.png"), "cannot write '/none/a.png': the folder '/none' does not exist");
  EXPECT_EQ(error(a), "no error") << "a part may become the picture";
}

}  // namespace
}  // namespace lentray::merge
