#include "core/render/film_grid.h"

#include <algorithm>
#include <utility>

namespace lentray::core {
namespace {

class GridBand final : public FilmBand {
 public:
  /// Rows [first, end); the image begins with row `top`.
  GridBand(const FilmSetup& setup, const BandOrders& orders, std::uint32_t first, std::uint32_t end,
           std::uint32_t top, Image& image)
      : m_setup(setup), m_order(orders.band(first, end)), m_top(top), m_image(image) {
    recall_colours(setup, 0, first, end, top, image);
  }
  std::size_t stages() const override { return 1; }
  std::size_t jobs(std::size_t) const override { return m_order->jobs(); }

  bool work(std::size_t, std::size_t job, FilmThread& thread) override {
    m_order->pixels(job, thread.pixels);
    leave_out(m_setup.known(0), thread.pixels);
    for (const Pixel& p : thread.pixels) {
      if (!thread.begins(p)) return false;
      store(mean(p, thread), m_setup.alpha, m_image.pixel(p.column, p.row - m_top));
    }
    if (m_setup.keeps()) keep_colours(m_setup, 0, m_top, m_image, thread);
    return true;
  }

 private:
  Radiance mean(const Pixel& pixel, FilmThread& thread) const {
    const Antialiasing& aa = m_setup.antialiasing;
    const double step = 1.0 / aa.depth;
    const int samples = aa.depth * aa.depth;
    const auto column = static_cast<std::int32_t>(pixel.column);
    const auto row = static_cast<std::int32_t>(pixel.row);
    Radiance sum{{}, 0.0f};
    bool shows = false;
    for (int i = 0; i < samples; ++i) {
      const PixelPlace place{.column = column,
                             .row = row,
                             .across = (i % aa.depth + 0.5) * step - 0.5,
                             .down = (i / aa.depth + 0.5) * step - 0.5};
      Radiance one;
      if (thread.sampler.sample(place, static_cast<std::uint32_t>(i), one)) shows = true;
      sum.rgb += one.rgb;
      sum.transmit += one.transmit;
    }
    if (!shows) {
      ++thread.counters.dark_pixels;
      return {};
    }
    ++thread.counters.antialiased_pixels;
    const float share = 1.0f / static_cast<float>(samples);
    return {sum.rgb * share, sum.transmit * share};
  }

  const FilmSetup& m_setup;
  const std::unique_ptr<PixelOrder> m_order;
  const std::uint32_t m_top;
  Image& m_image;
};

class GridFilm final : public Film {
 public:
  GridFilm(FilmSetup setup, const BandOrders& orders)
      : m_setup(std::move(setup)), m_orders(orders) {}
  std::unique_ptr<FilmBand> band(std::uint32_t top, std::uint32_t bottom,
                                 Image& image) const override {
    const std::uint32_t first = std::max(top, m_setup.region.top);
    const std::uint32_t end = std::min(bottom, m_setup.region.bottom);
    if (first >= end || m_setup.region.left >= m_setup.region.right) return nullptr;
    return std::make_unique<GridBand>(m_setup, m_orders, first, end, top, image);
  }

 private:
  const FilmSetup m_setup;
  const BandOrders& m_orders;
};

}  // namespace

std::unique_ptr<Film> make_film_of_grids(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<GridFilm>(std::move(setup), orders);
}

}  // namespace lentray::core
