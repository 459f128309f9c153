// A run writes no more bytes than Max_Written, whatever they are for, and older files stay.
#include "core/image/written_bytes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "core/image/byte_file.h"
#include "core/image/writer.h"
#include "parser/files/files.h"
#include "tools/common/process.h"
#include "tools/session/picture_journal.h"

namespace lentray::test_written_bytes {
namespace {

/// So many bytes more.
struct Limit {
  explicit Limit(std::uint64_t more) {
    core::limit_written(static_cast<double>(core::written_bytes() + more));
  }
  ~Limit() { core::limit_written(std::numeric_limits<double>::infinity()); }
  Limit(const Limit&) = delete;
  Limit& operator=(const Limit&) = delete;
};

TEST(UnitWrittenBytes, WhatFitsIsCounted) {
  const Limit limit(100);
  const std::uint64_t before = core::written_bytes();
  EXPECT_EQ(core::count_written(60), "");
  EXPECT_NE(core::count_written(41).find("(Max_Written)"), std::string::npos);
  EXPECT_EQ(core::written_bytes(), before + 60);
  EXPECT_EQ(core::count_written(40), "");
}

TEST(UnitWrittenBytes, OlderFilesStay) {
  const tool::TemporaryFolder folder;
  tool::write_whole(folder / "a", "older");
  const Limit limit(100);
  EXPECT_THROW(tool::write_whole(folder / "a", std::string(101, 'x')), core::ImageError);
  EXPECT_EQ(tool::read_text(folder / "a"), "older");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
}

TEST(UnitWrittenBytes, EncodersAreStopped) {
  const tool::TemporaryFolder folder;
  const Limit limit(1 << 20);
  core::ByteFile file(folder / "a", nullptr, &core::count_written);
  const std::string piece(100'000, 'x');
  EXPECT_THROW(
      for (int i = 0; i < 11; ++i) {
        file.write(piece);
        file.flush();
      },
      std::runtime_error);
}

TEST(UnitWrittenBytes, ScenesAreTold) {
  const tool::TemporaryFolder folder;
  const Limit limit(100);
  const auto file = parser::disk_files().open((folder / "a").string(), false);
  EXPECT_EQ(file->write(std::string(90, 'x')), "");
  EXPECT_NE(file->write(std::string(90, 'x')).find("(Max_Written)"), std::string::npos);
  EXPECT_EQ(file->close(), "");
  EXPECT_EQ(std::filesystem::file_size(folder / "a"), 90u);
}

/// A journal leaves half of the limit to the picture, and the run goes on without it.
TEST(UnitWrittenBytes, JournalsComeAfterPictures) {
  const tool::TemporaryFolder folder;
  const std::uint64_t before = core::written_bytes();
  core::limit_written(2.0 * static_cast<double>(before) + 200'000.0);
  const std::string picture = (folder / "a.png").string();
  tool::PictureJournal journal(picture, 100, 100, tool::Identity{"program", "option\n", {}},
                               std::chrono::milliseconds(0));
  std::vector<core::Pixel> pixels(10'000);
  for (std::uint32_t i = 0; i < pixels.size(); ++i) pixels[i] = {i % 100, i / 100};
  journal.add(0, pixels, std::vector<float>(4 * pixels.size()));
  journal.keep();
  EXPECT_NE(journal.trouble().find("(Max_Written)"), std::string::npos) << journal.trouble();
  EXPECT_LT(core::written_bytes() - before, 100'000u);
  core::limit_written(std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace lentray::test_written_bytes
