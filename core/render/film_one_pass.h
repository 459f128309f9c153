// Films whose pixels do not depend on one another: each is traced once, in the pixel order.
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/render/film.h"

namespace lentray::core {

class OnePassBand : public FilmBand {
 public:
  /// Rows [first, end); the image begins with row `top`.
  OnePassBand(const FilmSetup& setup, const BandOrders& orders, std::uint32_t first,
              std::uint32_t end, std::uint32_t top, Image& image)
      : m_setup(setup), m_top(top), m_image(image), m_order(orders.band(first, end)) {
    recall_colours(setup, 0, first, end, top, image);
  }
  std::size_t stages() const override { return 1; }
  std::size_t jobs(std::size_t) const override { return m_order->jobs(); }

  bool work(std::size_t, std::size_t job, FilmThread& thread) override {
    m_order->pixels(job, thread.pixels);
    leave_out(m_setup.known(0), thread.pixels);
    if (!trace(thread)) return false;
    if (m_setup.keeps()) keep_colours(m_setup, 0, m_top, m_image, thread);
    return true;
  }

 protected:
  /// The thread's pixels, into the image; false if it was cancelled meanwhile.
  virtual bool trace(FilmThread& thread) = 0;

  const FilmSetup& m_setup;
  const std::uint32_t m_top;
  Image& m_image;

 private:
  const std::unique_ptr<PixelOrder> m_order;
};

template <class Band>
class OnePassFilm final : public Film {
 public:
  OnePassFilm(FilmSetup setup, const BandOrders& orders)
      : m_setup(std::move(setup)), m_orders(orders) {}
  std::unique_ptr<FilmBand> band(std::uint32_t top, std::uint32_t bottom,
                                 Image& image) const override {
    const std::uint32_t first = std::max(top, m_setup.region.top);
    const std::uint32_t end = std::min(bottom, m_setup.region.bottom);
    if (first >= end || m_setup.region.left >= m_setup.region.right) return nullptr;
    return std::make_unique<Band>(m_setup, m_orders, first, end, top, image);
  }

 private:
  const FilmSetup m_setup;
  const BandOrders& m_orders;
};

}  // namespace lentray::core
