#include "tools/lentray-batch/page_pictures.h"

#include <algorithm>
#include <exception>
#include <optional>

#include "core/image/orientation.h"
#include "core/image/photo_tags.h"
#include "core/image/reader.h"
#include "core/image/thumbnail.h"
#include "tools/common/page_text.h"
#include "tools/common/small_pictures.h"
#include "tools/common/thumbnail_store.h"

namespace lentray::batch {
namespace {

namespace fs = std::filesystem;
using core::StoredImage;
using core::Thumbnail;
using core::ThumbnailSize;
using tool::base64;
using tool::bytes_in_page;
using tool::bytes_within;
using tool::jpeg_within;
using tool::size_within;
using tool::ThumbnailStore;

constexpr std::uint32_t kBlock = 16;  ///< rows that a JPEG codes together

bool is_integral(const Row& row) { return row.lens_pixels >= 2.0 && row.lens_pixels < 1e6; }

std::uint32_t columns_of_view(std::uint32_t width, double lens_pixels) {
  return static_cast<std::uint32_t>(std::max(1.0, width / lens_pixels + 1e-9));
}

/// Where the eye is moves the other way than the column that it sees.
std::vector<double> views_from_left_eye(double lens_pixels, int count) {
  std::vector<double> views;
  const double last = lens_pixels - 1.0;
  for (int i = count - 1; i >= 0; --i)
    views.push_back(count > 1 ? last * i / (count - 1) : last / 2);
  return views;
}

int tilt_views(const Row& row, const PictureStep& step) {
  return is_integral(row) ? std::min(step.views, static_cast<int>(row.lens_pixels)) : 0;
}

ThumbnailSize size_told(const Row& row, const PictureStep& step) {
  return {row.width > 0 ? row.width : step.side, row.height > 0 ? row.height : step.side};
}

/// The most that a row's small picture may take, by the size that the row gives.
std::size_t picture_bytes(const Row& row, const PictureStep& step) {
  if (step.side == 0) return 0;
  const auto [width, height] = size_told(row, step);
  const ThumbnailSize size = size_within(width, height, width, step.side);
  return bytes_within(step.bytes, std::size_t{size.width} * size.height);
}

std::size_t tilt_bytes(const Row& row, const PictureStep& step) {
  const int views = tilt_views(row, step);
  if (views < 2) return 0;
  const auto [width, height] = size_told(row, step);
  const ThumbnailSize size =
      size_within(width, height, columns_of_view(width, row.lens_pixels), step.tilt_side);
  const std::size_t pixels =
      std::size_t{size.width} * (size.height + kBlock) * static_cast<std::size_t>(views);
  return bytes_within(step.tilt_bytes, pixels);
}

/// Which pictures a row has on the page.
struct Wanted {
  bool picture = false, tilt = false, comparison = false;
};

std::vector<Wanted> wanted(const std::vector<Row>& rows, const std::vector<Card>& cards) {
  std::vector<Wanted> all(rows.size());
  for (const Card& card : cards) {
    for (const std::size_t i : card.is_animation ? shown_frames(rows, card) : card.rows) {
      const bool has_picture = rows[i].state == State::done && !rows[i].picture.empty();
      all[i] = {has_picture, has_picture && !card.is_animation && is_integral(rows[i]),
                !card.is_animation && rows[i].verdict.has_value()};
    }
  }
  return all;
}

std::size_t room_of(const Row& row, const Wanted& want, const PictureStep& step) {
  const std::size_t one = bytes_in_page(picture_bytes(row, step));
  std::size_t room = want.picture ? one : 0;
  if (want.tilt) room += bytes_in_page(tilt_bytes(row, step));
  if (want.comparison)
    room += (row.verdict->stock.empty() ? 0 : one) + (row.verdict->difference.empty() ? 0 : one);
  return room;
}

/// Makes the pictures of one file, which is read when the first of them is not kept.
class PictureFile {
 public:
  PictureFile(ThumbnailStore& store, fs::path path) : m_store(store), m_path(std::move(path)) {}

  std::string whole(std::uint32_t side, std::size_t most) {
    return kept("whole " + std::to_string(side), most, [side, this](const StoredImage& image) {
      return core::upright(
          core::thumbnail_of(image, size_within(image.width, image.height, image.width, side)),
          m_orientation);
    });
  }
  std::string middle(double lens_pixels, std::uint32_t side, std::size_t most) {
    return kept(
        "middle " + std::to_string(lens_pixels) + ' ' + std::to_string(side), most,
        [=, this](const StoredImage& image) { return views(image, lens_pixels, 1, side, false); });
  }
  /// Frames begin where JPEG's blocks do, so that they do not run into each other.
  std::string tilt(double lens_pixels, int count, std::uint32_t side, std::size_t most) {
    return kept("tilt " + std::to_string(lens_pixels) + ' ' + std::to_string(count) + ' ' +
                    std::to_string(side),
                most, [=, this](const StoredImage& image) {
                  return views(image, lens_pixels, count, side, true);
                });
  }

 private:
  /// Those of a sheet on its side stand upright.
  Thumbnail views(const StoredImage& image, double lens_pixels, int count, std::uint32_t side,
                  bool in_blocks) const {
    ThumbnailSize size =
        size_within(image.width, image.height, columns_of_view(image.width, lens_pixels), side);
    std::uint32_t& rows = m_orientation == core::kTurned ? size.width : size.height;
    if (in_blocks) rows = std::max(kBlock, rows / kBlock * kBlock);
    std::vector<Thumbnail> all =
        core::view_thumbnails(image, lens_pixels, views_from_left_eye(lens_pixels, count), size);
    for (Thumbnail& one : all) one = core::upright(std::move(one), m_orientation);
    return core::stacked(all);
  }

  template <typename Make>
  std::string kept(const std::string& what, std::size_t most, const Make& make) {
    return base64(m_store.kept(m_path, what + ' ' + std::to_string(most), [&] {
      if (!m_image) {
        m_image = core::read_image(m_path);
        m_orientation = core::photo_tags(m_path).orientation;
      }
      return jpeg_within(make(*m_image), most);
    }));
  }

  ThumbnailStore& m_store;
  fs::path m_path;
  int m_orientation = 1;
  std::optional<StoredImage> m_image{};
};

/// `is_whole`: a difference, which is shown interlaced.
std::string compared(ThumbnailStore& store, const fs::path& path, const Row& row,
                     const PictureStep& step, bool is_whole) {
  PictureFile file(store, path);
  const std::size_t most = picture_bytes(row, step);
  return is_whole || !is_integral(row) ? file.whole(step.side, most)
                                       : file.middle(row.lens_pixels, step.side, most);
}

void put_own(RowPictures& out, ThumbnailStore& store, const fs::path& path, const Row& row,
             const Wanted& want, const PictureStep& step) {
  PictureFile file(store, path);
  const std::size_t most = picture_bytes(row, step);
  out.picture = is_integral(row) ? file.middle(row.lens_pixels, step.side, most)
                                 : file.whole(step.side, most);
  const int views = want.tilt ? tilt_views(row, step) : 0;
  if (views < 2) return;
  out.tilt = file.tilt(row.lens_pixels, views, step.tilt_side, tilt_bytes(row, step));
  out.tilt_views = out.tilt.empty() ? 0 : views;
}

template <typename Make>
std::string problem_with(const Make& make) {
  try {
    make();
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

RowPictures pictures_of_row(const Row& row, const Wanted& want, ThumbnailStore& store,
                            const fs::path& folder, const PictureStep& step) {
  RowPictures out;
  if (want.picture)
    out.problem = problem_with([&] { put_own(out, store, folder / row.picture, row, want, step); });
  if (!want.comparison) return out;
  const Verdict& verdict = *row.verdict;
  // Without the small pictures there are the links.
  if (!verdict.stock.empty()) {
    problem_with([&] { out.stock = compared(store, folder / verdict.stock, row, step, false); });
  }
  if (!verdict.difference.empty()) {
    problem_with(
        [&] { out.difference = compared(store, folder / verdict.difference, row, step, true); });
  }
  return out;
}

}  // namespace

const std::vector<PictureStep>& picture_steps() {
  static const std::vector<PictureStep> all{{400, 24000, 15, 320, 110000},
                                            {340, 17000, 15, 280, 76000},
                                            {280, 12000, 15, 240, 54000},
                                            {240, 8600, 15, 200, 37000},
                                            {200, 6200, 13, 176, 26000},
                                            {176, 4900, 11, 160, 19000},
                                            {160, 4000, 11, 144, 15000},
                                            {144, 3300, 9, 128, 11000},
                                            {128, 2700, 9, 112, 8000},
                                            {112, 2100, 7, 96, 5500},
                                            {96, 1600, 5, 80, 3200},
                                            {80, 1200, 3, 64, 1600},
                                            {64, 850, 0, 0, 0},
                                            {0, 0, 0, 0, 0}};
  return all;
}

std::vector<std::size_t> shown_frames(const std::vector<Row>& rows, const Card& card) {
  std::vector<std::size_t> with_picture;
  for (const std::size_t i : card.rows) {
    if (rows[i].state == State::done && !rows[i].picture.empty()) with_picture.push_back(i);
  }
  if (with_picture.size() <= kMostFrames) return with_picture;
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < kMostFrames; ++k) {
    chosen.push_back(with_picture[k * (with_picture.size() - 1) / (kMostFrames - 1)]);
  }
  return chosen;
}

std::size_t step_that_fits(const std::vector<Row>& rows, const std::vector<Card>& cards,
                           std::size_t expected_rows, std::size_t room) {
  const std::vector<Wanted> wants = wanted(rows, cards);
  const double times = rows_to_one(rows, expected_rows);
  const std::vector<PictureStep>& steps = picture_steps();
  for (std::size_t s = 0; s + 1 < steps.size(); ++s) {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) sum += room_of(rows[i], wants[i], steps[s]);
    if (static_cast<double>(sum) * times <= static_cast<double>(room)) return s;
  }
  return steps.size() - 1;
}

std::vector<RowPictures> pictures_of(const std::vector<Row>& rows, const std::vector<Card>& cards,
                                     const fs::path& folder, const PictureStep& step) {
  std::vector<RowPictures> all(rows.size());
  if (step.side == 0) return all;
  ThumbnailStore store(folder / ".lentray-batch" / "thumbnails");
  const std::vector<Wanted> wants = wanted(rows, cards);
  for (std::size_t i = 0; i < rows.size(); ++i)
    all[i] = pictures_of_row(rows[i], wants[i], store, folder, step);
  store.delete_others();
  return all;
}

}  // namespace lentray::batch
