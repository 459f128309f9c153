// Antialiasing method 2: adaptive and recursive. The corners of all pixels come first, in the pixel
// order; then each pixel whose corners differ is cut into quarters, and these into theirs, `depth`
// times at most. Pixels do not depend on each other: some are cut at a time, all into quarters, then all into
// sixteenths and so on, so that their samples are traced together.
// Source: reference manual 3.7, "Sampling_Method"; places, weights and jitter measured on stock by
// tests/image/antialiasing_test.cpp.
#include "core/render/film_of.h"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr std::size_t kBorderCorners =
    1024;  ///< corners outside the image that are traced at a time
/// Pixels that are cut together, and the places within all of them, at most.
constexpr std::size_t kMostPixels = 64, kMostPlaces = std::size_t{1} << 14;
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
      if (!trace_corners(thread.pixels, thread)) return false;
      if (m_setup.keeps() && m_plan.step > 0) {
        keep_samples(m_setup, thread,
                     [this](const Pixel& p) { return corner(p.column, p.row).seen; });
      }
      return true;
    }
    thread.pixels.clear();
    const std::size_t first = (job - m_corner_order->jobs()) * kBorderCorners;
    const std::size_t count = std::min(m_border.size() - first, kBorderCorners);
    return trace_corners(std::span(m_border).subspan(first, count), thread);
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

  bool trace_corners(std::span<const Pixel> pixels, FilmThread& thread) {
    const std::size_t each = m_plan.step == 0 ? 2 : 1;
    const auto is_right = [each](std::size_t i) { return i % each == 1; };
    return thread.sampler.samples(
        pixels.size() * each, Sampler::Layout::kNeighbours,
        [&](std::size_t i) { return corner_place(pixels[i / each], is_right(i)); },
        [&](std::size_t i, const Sample& sample) {
          const Pixel& p = pixels[i / each];
          corner(p.column, p.row, is_right(i)) = {sample.seen, m_setup.space.of(sample.seen),
                                                  sample.has_ray};
          return thread.begins();
        });
  }

  static SamplePlace corner_place(const Pixel& pixel, bool right) {
    SamplePlace out{place_of(pixel), right ? kRightCorner : 0};
    out.place.across = right ? 0.5 : -0.5;
    out.place.down = -0.5;
    return out;
  }

  bool cut_pixels(FilmThread& thread) {
    const std::size_t most = std::clamp<std::size_t>(kMostPlaces / places(), 1, kMostPixels);
    for (std::span<const Pixel> left = thread.pixels; !left.empty();) {
      const auto pixels = left.first(std::min(most, left.size()));
      if (!cut_together(pixels, thread)) return false;
      left = left.subspan(pixels.size());
    }
    return true;
  }

  bool cut_together(std::span<const Pixel> pixels, FilmThread& thread) {
    begin(pixels, thread);
    for (;;) {
      std::erase_if(thread.open, [&](std::uint32_t i) {
        return !want({thread, i}, {0, 0, m_plan.places});
      });
      if (thread.open.empty()) break;
      if (!trace_wanted(pixels, thread)) return false;
    }
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
      if (!thread.begins()) return false;
      if (m_setup.region.has(pixels[i])) store_mean(pixels[i], {thread, i});
    }
    return true;
  }

  /// The places within one of the pixels that are cut together.
  struct Grid {
    FilmThread& thread;
    std::uint32_t pixel;
  };
  FilmThread::Finer& at(const Grid& grid, std::uint32_t x, std::uint32_t y) const {
    return grid.thread.finer[grid.pixel * places() + std::size_t{y} * (m_plan.places + 1) + x];
  }
  std::size_t places() const {
    return std::size_t{m_plan.places + 1} * std::size_t{m_plan.places + 1};
  }

  /// Pixels begin with their corners, all of them open.
  void begin(std::span<const Pixel> pixels, FilmThread& thread) {
    thread.stamp += 2;
    if (thread.finer.size() < pixels.size() * places())
      thread.finer.resize(pixels.size() * places());
    thread.open.clear();
    for (std::uint32_t i = 0; i < pixels.size(); ++i) {
      const Pixel& pixel = pixels[i];
      if (!m_setup.region.has(pixel)) continue;
      bool has_ray = false;
      for (const std::uint32_t x : {0u, 1u}) {
        for (const std::uint32_t y : {0u, 1u}) {
          const Corner& from = corner(pixel.column, pixel.row + y, x == 1);
          at({thread, i}, x * m_plan.places, y * m_plan.places) = {from.seen, from.compared,
                                                                   thread.known()};
          has_ray = has_ray || from.has_ray;
        }
      }
      if (!has_ray) ++thread.counters.dark_pixels;
      thread.open.push_back(i);
    }
  }

  /// A square within a pixel.
  struct Square {
    std::uint32_t x, y, side;
    std::uint32_t right() const { return x + side; }
    std::uint32_t below() const { return y + side; }
    std::uint32_t middle() const { return x + side / 2; }
    std::uint32_t centre() const { return y + side / 2; }
    std::array<Square, 4> quarters() const {
      const std::uint32_t half = side / 2;
      return {
          Square{x, y, half}, {middle(), y, half}, {x, centre(), half}, {middle(), centre(), half}};
    }
  };

  Corners corners(const Grid& grid, const Square& q) const {
    return {&at(grid, q.x, q.y), &at(grid, q.right(), q.y), &at(grid, q.x, q.below()),
            &at(grid, q.right(), q.below())};
  }
  bool is_cut(const Grid& grid, const Square& q) const {
    return q.side > 2 && differ(corners(grid, q));
  }

  /// Wants what the square lacks for being cut. False: it lacks nothing.
  bool want(const Grid& grid, const Square& q) const {
    if (!is_cut(grid, q)) return false;
    const bool lacks[] = {want(grid, q.x, q.centre()), want(grid, q.middle(), q.y),
                          want(grid, q.right(), q.centre()), want(grid, q.middle(), q.below()),
                          want(grid, q.middle(), q.centre())};
    if (std::ranges::any_of(lacks, std::identity{})) return true;
    bool any = false;
    for (const Square& quarter : q.quarters()) any = want(grid, quarter) || any;
    return any;
  }
  /// False: the pixel has the place already.
  bool want(const Grid& grid, std::uint32_t x, std::uint32_t y) const {
    FilmThread& thread = grid.thread;
    std::uint32_t& stamp = at(grid, x, y).stamp;
    if (stamp == thread.known()) return false;
    if (stamp != thread.stamp) thread.places.push_back({grid.pixel, x, y});
    stamp = thread.stamp;
    return true;
  }

  bool trace_wanted(std::span<const Pixel> pixels, FilmThread& thread) const {
    const bool goes_on = thread.sampler.samples(
        thread.places.size(), Sampler::Layout::kScattered,
        [&](std::size_t i) {
          const FilmThread::FinerPlace& place = thread.places[i];
          return finer(pixels[place.pixel], place.x, place.y);
        },
        [&](std::size_t i, const Sample& sample) {
          const FilmThread::FinerPlace& place = thread.places[i];
          at({thread, place.pixel}, place.x, place.y) = {sample.seen, m_setup.space.of(sample.seen),
                                                         thread.known()};
          return !thread.is_cancelled();
        });
    thread.places.clear();
    return goes_on;
  }

  SamplePlace finer(const Pixel& pixel, std::uint32_t x, std::uint32_t y) const {
    const Antialiasing& aa = m_setup.antialiasing;
    SamplePlace out{place_of(pixel), y * (m_plan.places + 1) + x + 1};
    out.place.across = 1.0 * x / m_plan.places - 0.5;
    out.place.down = 1.0 * y / m_plan.places - 0.5;
    if (!(aa.jitter > 0.0)) return out;
    RandomSequence random(sample_key(out.place.column, out.place.row, out.index),
                          RandomSequence::Use::kFilm);
    const double most = aa.jitter / (m_plan.places + 1);
    out.place.across += (random.next() - 0.5) * most;
    out.place.down += (random.next() - 0.5) * most;
    return out;
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

  void store_mean(const Pixel& pixel, const Grid& grid) {
    const Square whole{0, 0, m_plan.places};
    if (is_cut(grid, whole)) ++grid.thread.counters.antialiased_pixels;
    store(mean(grid, whole), m_setup.alpha, m_image.pixel(pixel.column, pixel.row - m_image_top));
  }

  Radiance mean(const Grid& grid, const Square& q) const {
    Radiance sum;
    if (is_cut(grid, q)) {
      for (const Square& quarter : q.quarters()) sum += mean(grid, quarter);
    } else {
      for (const FilmThread::Finer* c : corners(grid, q)) sum += c->seen;
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
