#include "core/render/film_grid.h"

#include <utility>

#include "core/render/film_one_pass.h"

namespace lentray::core {
namespace {

class GridBand final : public OnePassBand {
 public:
  using OnePassBand::OnePassBand;

 private:
  bool trace(FilmThread& thread) override {
    for (const Pixel& p : thread.pixels) {
      if (!thread.begins()) return false;
      store(mean(p, thread), m_setup.alpha, m_image.pixel(p.column, p.row - m_top));
    }
    return true;
  }

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
      sum += one;
    }
    if (!shows) {
      ++thread.counters.dark_pixels;
      return {};
    }
    ++thread.counters.antialiased_pixels;
    const float share = 1.0f / static_cast<float>(samples);
    return sum * share;
  }
};

}  // namespace

std::unique_ptr<Film> make_film_of_grids(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<OnePassFilm<GridBand>>(std::move(setup), orders);
}

}  // namespace lentray::core
