#include "tools/lentray-views/quilt_source.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <utility>

#include "core/image/writer.h"

namespace lentray::views {
namespace {

using core::ImageError;
using core::StoredImage;

class QuiltSource final : public Source {
 public:
  QuiltSource(const Arguments& arguments, StoredImage quilt, const QuiltTiles& tiles)
      : m_arguments(arguments), m_quilt(std::move(quilt)), m_facts(facts_of(m_quilt)),
        m_tiles(tiles) {
    if (m_quilt.width % tiles.columns == 0 && m_quilt.height % tiles.rows == 0) return;
    throw ImageError("'" + arguments.pictures[0].string() + "' has " +
                     std::to_string(m_quilt.width) + " x " + std::to_string(m_quilt.height) +
                     " pixels, which are no " + std::to_string(tiles.columns) + " x " +
                     std::to_string(tiles.rows) + " tiles of a quilt");
  }
  std::uint32_t count() const override { return m_tiles.columns * m_tiles.rows; }
  StoredImage view(std::uint32_t view) const override {
    if (view >= count()) refuse_view(view, count());
    const std::uint32_t tile = count() - 1 - view;  // the leftmost camera has the last view
    const std::uint32_t width = m_quilt.width / m_tiles.columns,
                        height = m_quilt.height / m_tiles.rows;
    StoredImage out = blank_like(m_quilt, width, height);
    copy_pixels(m_quilt,
                {tile % m_tiles.columns * width,
                 (m_tiles.rows - 1 - tile / m_tiles.columns) * height, width, height},
                out, 0, 0);
    if (m_arguments.size) return in_pixels(out, m_arguments.size->width, m_arguments.size->height);
    if (!m_arguments.square || m_tiles.aspect <= 0.0) return out;
    const double wide = std::round(height * m_tiles.aspect);
    return in_pixels(out, static_cast<std::uint32_t>(std::max(1.0, wide)), height);
  }
  Pair pair() const override { return {view(count() - 1), view(0)}; }
  double aspect() const override { return m_tiles.aspect; }
  const Facts& facts() const override { return m_facts; }
  std::vector<std::string> warnings() const override { return {}; }

 private:
  StoredImage in_pixels(const StoredImage& tile, std::uint32_t width, std::uint32_t height) const {
    return resized(tile, width, height, m_arguments.filter);
  }

  const Arguments& m_arguments;
  const StoredImage m_quilt;
  const Facts m_facts;
  const QuiltTiles m_tiles;
};

std::uint32_t whole_of(const std::string& text) {
  return static_cast<std::uint32_t>(std::strtoul(text.c_str(), nullptr, 10));
}

}  // namespace

std::optional<QuiltTiles> quilt_tiles(const std::filesystem::path& path, const Facts& facts) {
  constexpr double kMost = 1000.0;
  const double columns = tool::number_of(facts, "quilt.columns"),
               rows = tool::number_of(facts, "quilt.rows");
  if (columns >= 1.0 && columns <= kMost && rows >= 1.0 && rows <= kMost) {
    return QuiltTiles{static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows),
                      tool::number_of(facts, "quilt.aspect")};
  }
  static const std::regex pattern("_qs([1-9][0-9]{0,2})x([1-9][0-9]{0,2})(a([0-9]+[.]?[0-9]*))?$");
  std::smatch found;
  const std::string stem = path.stem().string();
  if (!std::regex_search(stem, found, pattern)) return std::nullopt;
  return QuiltTiles{whole_of(found[1]), whole_of(found[2]),
                    std::strtod(found[4].str().c_str(), nullptr)};
}

std::unique_ptr<Source> quilt_source(const Arguments& arguments, StoredImage quilt,
                                     const QuiltTiles& tiles) {
  return std::make_unique<QuiltSource>(arguments, std::move(quilt), tiles);
}

}  // namespace lentray::views
