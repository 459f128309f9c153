#include "tools/lentray-print/page_raster.h"

#include <algorithm>
#include <cmath>

#include "core/base/memory_limit.h"
#include "core/image/quantiser.h"

namespace lentray::print {
namespace {

constexpr std::uint32_t kBandRows = 64;

/// Draws into one window.
class Canvas {
 public:
  Canvas(const Page& page, const Window& window)
      : m_page(page), m_window(window), m_image(window.width, window.height) {}

  core::Image draw() {
    fill();
    for (const Picture& picture : m_page.pictures) put(picture);
    for (const Box& bar : m_page.bars) put(bar);
    for (const Stroke& stroke : m_page.strokes) put(stroke);
    return std::move(m_image);
  }

 private:
  /// Pixels from first to end of a page's column or row, as far as they are in the window.
  struct Span {
    std::int64_t first, end;
  };
  static Span within(double from, double to, std::int64_t start, std::uint32_t size) {
    const double least = static_cast<double>(start), most = least + size;
    return {static_cast<std::int64_t>(std::floor(std::clamp(from, least, most))),
            static_cast<std::int64_t>(std::ceil(std::clamp(to, least, most)))};
  }
  Span columns(double from, double to) const {
    return within(from, to, m_window.column, m_window.width);
  }
  Span rows(double from, double to) const {
    return within(from, to, m_window.row, m_window.height);
  }
  float* pixel(std::int64_t column, std::int64_t row) {
    return m_image.pixel(static_cast<std::uint32_t>(column - m_window.column),
                         static_cast<std::uint32_t>(row - m_window.row));
  }

  void fill() {
    const Colour& b = m_page.background;
    const float values[] = {static_cast<float>(b.red), static_cast<float>(b.green),
                            static_cast<float>(b.blue), 1.0f};
    for (std::size_t i = 0; i < m_image.rgba.size(); ++i) m_image.rgba[i] = values[i % 4];
  }

  void put(const Picture& picture) {
    const core::StoredImage& image = picture.image;
    const auto place = [](std::int64_t at) { return static_cast<double>(at); };
    const Span across =
        columns(place(picture.column), place(picture.column + std::int64_t{image.width}));
    const Span down = rows(place(picture.row), place(picture.row + std::int64_t{image.height}));
    const float most = static_cast<float>((1u << image.bits) - 1u);
    for (std::int64_t row = down.first; row < down.end; ++row) {
      for (std::int64_t column = across.first; column < across.end; ++column) {
        float* to = pixel(column, row);
        const std::size_t from = image.place(static_cast<std::uint32_t>(column - picture.column),
                                             static_cast<std::uint32_t>(row - picture.row), 0);
        for (std::size_t c = 0; c < 3; ++c)
          to[c] = image.samples[from + (image.channels < 3 ? 0 : c)] / most;
      }
    }
  }

  void ink(std::int64_t column, std::int64_t row, double share) {
    if (!(share > 0.0)) return;
    float* to = pixel(column, row);
    const double values[] = {m_page.ink.red, m_page.ink.green, m_page.ink.blue};
    for (int c = 0; c < 3; ++c)
      to[c] += static_cast<float>(share) * (static_cast<float>(values[c]) - to[c]);
  }

  void put(const Box& bar) {
    const double left = bar.left / m_page.pixel_width(), right = bar.right() / m_page.pixel_width();
    const double top = bar.top / m_page.pixel_height();
    const double bottom = bar.bottom() / m_page.pixel_height();
    const auto covered = [](std::int64_t at, double from, double to) {
      const auto pixel = static_cast<double>(at);
      return std::clamp(std::min(pixel + 1.0, to) - std::max(pixel, from), 0.0, 1.0);
    };
    const Span across = columns(left, right), down = rows(top, bottom);
    for (std::int64_t row = down.first; row < down.end; ++row) {
      const double height = covered(row, top, bottom);
      for (std::int64_t column = across.first; column < across.end; ++column)
        ink(column, row, height * covered(column, left, right));
    }
  }

  void put(const Stroke& stroke) {
    // Pieces of one stroke overlap at its joints: the nearest counts, once.
    const double reach = stroke.width / 2.0 + std::max(m_page.pixel_width(), m_page.pixel_height());
    double left = 1e300, right = -1e300, top = 1e300, bottom = -1e300;
    for (const Point& p : stroke.points) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
    const Span across =
        columns((left - reach) / m_page.pixel_width(), (right + reach) / m_page.pixel_width());
    const Span down =
        rows((top - reach) / m_page.pixel_height(), (bottom + reach) / m_page.pixel_height());
    const double pixel_size = std::sqrt(m_page.pixel_width() * m_page.pixel_height());
    for (std::int64_t row = down.first; row < down.end; ++row) {
      for (std::int64_t column = across.first; column < across.end; ++column) {
        const Point at{(static_cast<double>(column) + 0.5) * m_page.pixel_width(),
                       (static_cast<double>(row) + 0.5) * m_page.pixel_height()};
        const double inside = stroke.width / 2.0 - distance(stroke, at);
        ink(column, row, std::clamp(inside / pixel_size + 0.5, 0.0, 1.0));
      }
    }
  }

  static double distance(const Stroke& stroke, Point at) {
    double nearest = 1e300;
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      const Point a = stroke.points[i];
      const Point b = stroke.points[std::min(i + 1, stroke.points.size() - 1)];
      const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
      const double along =
          length > 0.0 ? std::clamp(((at.x - a.x) * x + (at.y - a.y) * y) / length, 0.0, 1.0) : 0.0;
      nearest = std::min(nearest, std::hypot(at.x - a.x - along * x, at.y - a.y - along * y));
    }
    return nearest;
  }

  const Page& m_page;
  const Window m_window;
  core::Image m_image;
};

template <class Value>
void append(const core::Image& band, int bits, std::vector<Value>& samples) {
  for (std::size_t i = 0; i < band.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    samples.push_back(static_cast<Value>(core::scaled_to_integer(band.rgba[i], bits)));
  }
}

}  // namespace

core::Image drawn(const Page& page, const Window& window) { return Canvas(page, window).draw(); }

core::StoredImage stored_window(const Page& page, const Window& window, int bits) {
  core::StoredImage image;
  image.width = window.width;
  image.height = window.height;
  image.channels = 3;
  image.bits = bits;
  image.profile = page.profile();
  const std::size_t count = std::size_t{3} * window.width * window.height;
  core::check_room(static_cast<double>(count) * bits / 8);
  image.samples.store_bits(bits, 0);
  image.samples.visit([&](auto& samples) {
    samples.reserve(count);
    for (std::uint32_t row = 0; row < window.height; row += kBandRows) {
      const std::uint32_t rows = std::min(kBandRows, window.height - row);
      append(drawn(page, {window.column, window.row + row, window.width, rows}), bits, samples);
    }
  });
  return image;
}

}  // namespace lentray::print
