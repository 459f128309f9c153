#include "tools/lentray-chart/page_pictures.h"

#include <exception>
#include <map>

#include "core/image/reader.h"
#include "tools/common/page_text.h"
#include "tools/common/small_pictures.h"
#include "tools/common/thumbnail_store.h"

namespace lentray::chart {
namespace {

namespace fs = std::filesystem;

/// Longer sides, from what large screens show to what still shows anything.
constexpr std::uint32_t kSides[] = {2048, 1600, 1280, 1024, 800, 640, 480,
                                    360,  280,  200,  140,  96,  64};
constexpr int kBestQuality = 95;  ///< errors of 1/255 are looked for

/// The most that a picture of the chart takes: half a byte a pixel, and a head.
std::size_t most_bytes(const Chart& chart, std::uint32_t side) {
  const std::uint32_t width = chart.width > 0 ? chart.width : side,
                      height = chart.height > 0 ? chart.height : side;
  const core::ThumbnailSize size = tool::size_within(width, height, width, side);
  return 800 + std::size_t{size.width} * size.height / 2;
}

/// Exact settings have the plain picture.
const Point& shown_by(const Chart& chart, const Point& point) {
  const bool is_same = point.setting.kind == Kind::exact && !point.setting.is_plain &&
                       point.from_plain && !(point.from_plain->rms > 0.0);
  if (!is_same) return point;
  for (const Point& p : chart.points) {
    if (p.setting.is_plain && p.state == State::done && !p.picture.empty()) return p;
  }
  return point;
}

std::size_t count_of_files(const Chart& chart) {
  std::map<std::string, int> files;
  std::size_t to_come = 0;
  for (const Point& p : chart.points) {
    if (p.state == State::waiting) to_come += p.setting.kind == Kind::exact ? 0 : 2;
    const Point& shown = shown_by(chart, p);
    for (const std::string& file : {shown.picture, shown.difference, p.stock_picture})
      ++files[file];
  }
  ++files[chart.reference.picture];
  if (chart.lens_reference) ++files[chart.lens_reference->picture];
  files.erase("");
  return files.size() + to_come;
}

/// Makes pictures, each file once.
class Maker {
 public:
  Maker(fs::path folder, std::uint32_t side, std::size_t most, std::vector<std::string>& jpegs)
      : m_folder(std::move(folder)), m_side(side), m_most(most), m_jpegs(jpegs),
        m_store(m_folder / ".lentray-chart" / "thumbnails") {}

  /// Nothing for no file. What hinders it goes to `problem`.
  std::optional<std::size_t> operator()(const std::string& file, std::string* problem) {
    if (file.empty() || m_side == 0) return std::nullopt;
    const auto [at, is_new] = m_made.try_emplace(file);
    if (is_new) make(file, at->second);
    if (problem != nullptr) *problem = at->second.problem;
    return at->second.place;
  }
  void delete_others() const { m_store.delete_others(); }

 private:
  struct Made {
    std::optional<std::size_t> place{};
    std::string problem{};
  };

  void make(const std::string& file, Made& made) {
    try {
      const std::string jpeg = jpeg_of(m_folder / file);
      if (jpeg.empty()) {
        made.problem = "It does not become small enough for the page.";
        return;
      }
      made.place = m_jpegs.size();
      m_jpegs.push_back(tool::base64(jpeg));
    } catch (const std::exception& error) {
      made.problem = error.what();
    }
  }
  std::string jpeg_of(const fs::path& path) {
    const std::string recipe = "chart " + std::to_string(m_side) + ' ' + std::to_string(m_most);
    return m_store.kept(path, recipe, [&] {
      const core::StoredImage image = core::read_image(path);
      const core::ThumbnailSize size =
          tool::size_within(image.width, image.height, image.width, m_side);
      return tool::jpeg_within(core::thumbnail_of(image, size), m_most, kBestQuality);
    });
  }

  fs::path m_folder;
  std::uint32_t m_side;
  std::size_t m_most;
  std::vector<std::string>& m_jpegs;
  tool::ThumbnailStore m_store;
  std::map<std::string, Made> m_made{};
};

std::uint32_t side_within(const Chart& chart, std::size_t room) {
  const std::size_t count = count_of_files(chart);
  for (const std::uint32_t side : kSides) {
    if (count * tool::bytes_in_page(most_bytes(chart, side)) <= room) return side;
  }
  return 0;
}

}  // namespace

PagePictures pictures_of(const Chart& chart, const fs::path& folder, std::size_t room) {
  PagePictures all;
  all.side = side_within(chart, room);
  Maker make(folder, all.side, most_bytes(chart, all.side), all.jpegs);
  for (const Point& p : chart.points) {
    PointPictures& own = all.points.emplace_back();
    if (p.state != State::done) continue;
    const Point& shown = shown_by(chart, p);
    own.picture = make(shown.picture, &own.problem);
    own.difference = make(shown.difference, nullptr);
    own.stock = make(p.stock_picture, nullptr);
    if (all.side == 0) own.problem = "The page has no room for pictures.";
    if (shown.picture.empty()) own.problem = "No picture was kept.";
  }
  all.reference = make(chart.reference.picture, &all.reference_problem);
  if (chart.lens_reference) all.lens_reference = make(chart.lens_reference->picture, nullptr);
  if (all.side > 0) make.delete_others();
  return all;
}

}  // namespace lentray::chart
