// Antialiasing method 2: adaptive and recursive. The corners of all pixels come first, in the pixel
// order; then each pixel whose corners differ is cut into quarters, and these into theirs, `depth`
// times at most. Pixels do not depend on each other.
// Source: reference manual 3.7, "Sampling_Method"; places, weights and jitter measured on stock by
// tests/image/antialiasing_test.cpp.
#include "core/render/film_of.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr std::size_t kBorderCorners =
    1024;  ///< corners outside the image that are traced at a time
/// Where the areas of pixels do not join, a pixel has its right corners to itself.
constexpr std::uint32_t kRightCorner = ~0u;

struct Corner {
  Radiance seen;
  Compared compared;
  bool has_ray = false;
};

struct CornersPlan : FilmPlan {
  CornersPlan(FilmSetup s, const BandOrders& o)
      : FilmPlan(std::move(s), o), columns(traced_columns_of_corners(setup)),
        step(setup.lattice.step), places(1u << setup.antialiasing.depth),
        stride(step > 0 ? setup.region.right - setup.region.left + step
                        : 2 * std::size_t{setup.region.right - setup.region.left}) {}
  FilmColumns columns;
  std::uint32_t step;    ///< see PixelLattice
  std::uint32_t places;  ///< across a pixel
  std::size_t stride;    ///< corners in a row that are kept
};

class CornersBand final : public FilmBand {
 public:
  CornersBand(const CornersPlan& plan, std::uint32_t top, std::uint32_t bottom,
              std::uint32_t image_top, Image& image)
      : m_plan(plan), m_setup(plan.setup), m_top(top), m_bottom(bottom), m_image_top(image_top),
        m_image(image), m_corner_order(plan.orders.band(top, std::min(bottom + 1, m_setup.height))),
        m_order(plan.orders.band(top, bottom)), m_corners(plan.stride * (bottom - top + 1)) {
    const PixelRegion& region = m_setup.region;
    // The corners beyond the image's right and lower edge.
    for (std::uint32_t row = top; row <= bottom; ++row) {
      const std::uint32_t first = row < m_setup.height ? plan.columns.right : region.left;
      for (std::uint32_t k = first; k < region.right + plan.step; ++k) m_border.push_back({k, row});
    }
    recall(std::min(bottom + 1, m_setup.height));
  }

  std::size_t stages() const override { return 2; }
  std::size_t jobs(std::size_t stage) const override {
    if (stage == 1) return m_order->jobs();
    return m_corner_order->jobs() + (m_border.size() + kBorderCorners - 1) / kBorderCorners;
  }
  bool work(std::size_t stage, std::size_t job, FilmThread& thread) override {
    if (stage == 1) {
      m_order->pixels(job, thread.pixels);
      leave_out(m_setup.known(1), thread.pixels);
      if (!cut_pixels(thread)) return false;
      if (m_setup.keeps()) keep_colours(m_setup, 1, m_image_top, m_image, thread);
      return true;
    }
    if (job < m_corner_order->jobs()) {
      m_corner_order->pixels(job, thread.pixels);
      leave_out(known_corners(), thread.pixels);
      if (!trace_corners(thread.pixels.data(), thread.pixels.size(), thread)) return false;
      if (m_setup.keeps() && m_plan.step > 0) {
        keep_samples(m_setup, thread,
                     [this](const Pixel& p) { return corner(p.column, p.row).seen; });
      }
      return true;
    }
    thread.pixels.clear();
    const std::size_t first = (job - m_corner_order->jobs()) * kBorderCorners;
    return trace_corners(m_border.data() + first, std::min(m_border.size() - first, kBorderCorners),
                         thread);
  }

 private:
  using Corners = std::array<const FilmThread::Finer*, 4>;

  /// The upper left corner of a pixel, or its upper right one where pixels do not join.
  Corner& corner(std::uint32_t column, std::uint32_t row, bool right = false) {
    const std::size_t k = column - m_setup.region.left;
    const std::size_t place =
        m_plan.step > 0 ? k + (right ? m_plan.step : 0) : 2 * k + (right ? 1 : 0);
    return m_corners[(row - m_top) * m_plan.stride + place];
  }

  /// Where pixels do not join, each has two, and none is kept.
  const PixelSet* known_corners() const { return m_plan.step > 0 ? m_setup.known(0) : nullptr; }

  void recall(std::uint32_t end) {
    recall_colours(m_setup, 1, m_top, m_bottom, m_image_top, m_image);
    if (!known_corners()) return;
    recall_samples(m_setup, m_plan.columns, m_top, end,
                   [this](const Pixel& p, const Radiance& seen) {
                     Corner& out = corner(p.column, p.row);
                     out.seen = seen;
                     out.compared = m_setup.space.of(seen);
                     out.has_ray = true;
                   });
  }

  bool trace_corners(const Pixel* pixels, std::size_t count, FilmThread& thread) {
    for (std::size_t i = 0; i < count; ++i) {
      if (!thread.begins()) return false;
      trace(pixels[i], false, thread);
      if (m_plan.step == 0) trace(pixels[i], true, thread);
    }
    return true;
  }

  void trace(const Pixel& p, bool right, FilmThread& thread) {
    Corner& out = corner(p.column, p.row, right);
    const PixelPlace place{.column = static_cast<std::int32_t>(p.column),
                           .row = static_cast<std::int32_t>(p.row),
                           .across = right ? 0.5 : -0.5,
                           .down = -0.5};
    out.has_ray = thread.sampler.sample(place, right ? kRightCorner : 0, out.seen);
    out.compared = m_setup.space.of(out.seen);
  }

  bool cut_pixels(FilmThread& thread) {
    const std::size_t side = m_plan.places + 1;
    if (thread.finer.size() < side * side) thread.finer.assign(side * side, {});
    for (const Pixel& pixel : thread.pixels) {
      if (!thread.begins()) return false;
      if (!m_setup.region.has(pixel)) continue;
      ++thread.stamp;
      const std::uint32_t end = m_plan.places;
      bool has_ray = false, was_cut = false;
      for (const std::uint32_t x : {0u, 1u}) {
        for (const std::uint32_t y : {0u, 1u}) {
          const Corner& from = corner(pixel.column, pixel.row + y, x == 1);
          at(thread, x * end, y * end) = {from.seen, from.compared, thread.stamp};
          has_ray = has_ray || from.has_ray;
        }
      }
      if (!has_ray) ++thread.counters.dark_pixels;
      const Radiance mean = cut(pixel, {0, 0, end}, was_cut, thread);
      if (was_cut) ++thread.counters.antialiased_pixels;
      store(mean, m_setup.alpha, m_image.pixel(pixel.column, pixel.row - m_image_top));
    }
    return true;
  }

  FilmThread::Finer& at(FilmThread& thread, std::uint32_t x, std::uint32_t y) const {
    return thread.finer[std::size_t{y} * (m_plan.places + 1) + x];
  }

  /// A square within a pixel.
  struct Square {
    std::uint32_t x, y, side;
  };

  /// Samples a place unless the pixel has it already.
  void need(const Pixel& pixel, std::uint32_t x, std::uint32_t y, FilmThread& thread) const {
    FilmThread::Finer& out = at(thread, x, y);
    if (out.stamp == thread.stamp) return;
    const Antialiasing& aa = m_setup.antialiasing;
    const auto index = y * (m_plan.places + 1) + x + 1;
    const auto column = static_cast<std::int32_t>(pixel.column),
               row = static_cast<std::int32_t>(pixel.row);
    PixelPlace place{.column = column,
                     .row = row,
                     .across = 1.0 * x / m_plan.places - 0.5,
                     .down = 1.0 * y / m_plan.places - 0.5};
    if (aa.jitter > 0.0) {
      RandomSequence random(sample_key(column, row, index), RandomSequence::Use::kFilm);
      const double most = aa.jitter / (m_plan.places + 1);
      place.across += (random.next() - 0.5) * most;
      place.down += (random.next() - 0.5) * most;
    }
    thread.sampler.sample(place, index, out.seen);
    out.compared = m_setup.space.of(out.seen);
    out.stamp = thread.stamp;
  }

  bool differ(const Corners& c) const {
    const auto threshold = static_cast<float>(m_setup.antialiasing.threshold);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = i + 1; j < 4; ++j) {
        if (c[i]->compared.distance(c[j]->compared) >= threshold) return true;
      }
    }
    return false;
  }

  Radiance cut(const Pixel& pixel, const Square& q, bool& was_cut, FilmThread& thread) const {
    const std::uint32_t right = q.x + q.side, below = q.y + q.side;
    const Corners corners{&at(thread, q.x, q.y), &at(thread, right, q.y), &at(thread, q.x, below),
                          &at(thread, right, below)};
    Radiance sum;
    if (q.side > 2 && differ(corners)) {
      was_cut = true;
      const std::uint32_t half = q.side / 2, x = q.x + half, y = q.y + half;
      need(pixel, q.x, y, thread);
      need(pixel, x, q.y, thread);
      need(pixel, right, y, thread);
      need(pixel, x, below, thread);
      need(pixel, x, y, thread);
      for (const Square& quarter :
           {Square{q.x, q.y, half}, {x, q.y, half}, {q.x, y, half}, {x, y, half}}) {
        sum += cut(pixel, quarter, was_cut, thread);
      }
    } else {
      for (const FilmThread::Finer* c : corners) sum += c->seen;
    }
    return sum * 0.25f;
  }

  const CornersPlan& m_plan;
  const FilmSetup& m_setup;
  const std::uint32_t m_top, m_bottom, m_image_top;
  Image& m_image;
  std::unique_ptr<PixelOrder> m_corner_order, m_order;
  std::vector<Pixel> m_border;  ///< corners outside the image
  std::vector<Corner> m_corners;
};

}  // namespace

FilmColumns traced_columns_of_corners(const FilmSetup& setup) {
  const PixelRegion& region = setup.region;
  return {region.left, std::min(setup.width, region.right + setup.lattice.step)};
}

std::unique_ptr<Film> make_film_of_corners(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<FilmOf<CornersPlan, CornersBand>>(std::move(setup), orders);
}

}  // namespace lentray::core
