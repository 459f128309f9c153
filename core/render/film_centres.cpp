// Antialiasing method 1: adaptive, not recursive. All pixels' centres come first, in the pixel
// order; then, row by row, a pixel is compared with what its left and upper neighbours have become,
// and where two differ both get depth x depth samples more.
//
// What a pixel becomes depends on what happened before it, so the rows are chains. They begin anew
// in tiles of PixelLattice::kTile pixels each way, counted from the image's corner: a tile sees the
// bare centres of the pixels around it. So tiles can be traced alone and at once, and a part of a
// picture has the whole picture's pixels. Within a tile, pixels that do not join one another (other
// views behind a lens sheet) are chains of their own (core/render/pixel_chains.h). The samples of all
// pixels that a step of a chain refines are traced together.
// Source: reference manual 3.7, "Sampling_Method"; the order of the comparisons and the weights
// measured on stock by tests/image/antialiasing_test.cpp.
#include "core/render/film_of.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/render/pixel_chains.h"
#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr std::uint32_t kTile = PixelLattice::kTile;
constexpr std::size_t kBorderPixels = 1024;  ///< pixels outside the image that are traced at a time

struct Tiles {
  std::size_t first = 0, end = 0;  ///< of PixelLattice::tiles
};

Tiles tiles_of(const FilmSetup& setup) {
  const auto& starts = setup.lattice.tiles;
  Tiles out;
  if (setup.region.left >= setup.region.right) return out;
  const auto after = [&](std::uint32_t column) {
    return static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), column) -
                                    starts.begin());
  };
  out.first = after(setup.region.left) - 1;
  out.end = after(setup.region.right - 1);
  return out;
}

std::vector<PixelChain> chains_of(const FilmSetup& setup) {
  std::vector<PixelChain> out;
  const Tiles tiles = tiles_of(setup);
  for (std::size_t i = tiles.first; i < tiles.end; ++i) {
    std::ranges::move(
        chains_of_tile(setup.lattice, setup.lattice.tiles[i], setup.lattice.tiles[i + 1]),
        std::back_inserter(out));
  }
  return out;
}

struct CentresPlan : FilmPlan {
  CentresPlan(FilmSetup s, const BandOrders& o)
      : FilmPlan(std::move(s), o), chains(chains_of(setup)),
        columns(traced_columns_of_centres(setup)),
        base(columns.left == 0 ? setup.lattice.leftmost()
                               : static_cast<std::int32_t>(columns.left)),
        stride(static_cast<std::size_t>(static_cast<std::int32_t>(columns.right) - base)) {}
  std::vector<PixelChain> chains;
  FilmColumns columns;
  std::int32_t base;   ///< the first column that is kept, perhaps outside the image
  std::size_t stride;  ///< columns that are kept
};

class CentresBand final : public FilmBand {
 public:
  /// Rows [top, bottom), whole tiles; the image begins with row `image_top`.
  CentresBand(const CentresPlan& plan, std::uint32_t top, std::uint32_t bottom,
              std::uint32_t image_top, Image& image)
      : m_plan(plan), m_setup(plan.setup), m_top(top), m_bottom(bottom), m_image_top(image_top),
        m_image(image), m_cells(static_cast<std::size_t>(plan.setup.antialiasing.depth) *
                                static_cast<std::size_t>(plan.setup.antialiasing.depth)) {
    const std::uint32_t first = top > 0 ? top - 1 : 0;
    m_order = plan.orders.band(first, std::min(bottom + 1, m_setup.height));
    for (std::int32_t k = plan.base; k < 0; ++k) {
      for (std::uint32_t row = top; row < bottom; ++row) {
        m_border.push_back({.column = k, .row = static_cast<std::int32_t>(row)});
      }
    }
    if (top == 0) {
      for (std::uint32_t k = plan.columns.left; k < plan.columns.right; ++k) {
        m_border.push_back({.column = static_cast<std::int32_t>(k), .row = -1});
      }
    }
    m_centres.resize(plan.stride * (bottom - top + 2));
    recall(first, std::min(bottom + 1, m_setup.height));
  }

  std::size_t stages() const override { return 2; }
  std::size_t jobs(std::size_t stage) const override {
    return stage == 0 ? m_order->jobs() + (m_border.size() + kBorderPixels - 1) / kBorderPixels
                      : m_plan.chains.size() * ((m_bottom - m_top + kTile - 1) / kTile);
  }
  bool work(std::size_t stage, std::size_t job, FilmThread& thread) override {
    if (stage == 1) return refine_chain(job, thread);
    return job < m_order->jobs() ? trace_centres(job, thread)
                                 : trace_border(job - m_order->jobs(), thread);
  }

 private:
  struct Centre {
    Radiance seen;
    Compared compared;
  };

  /// A chain through the rows [top, bottom) of its tile.
  struct Walk {
    const PixelChain& chain;
    std::uint32_t top, bottom;
    FilmThread& thread;

    std::size_t rows() const { return bottom - top; }
    /// Row 0 is the one above the tile.
    std::size_t index(std::size_t place, std::size_t row) const {
      return row * chain.columns.size() + place;
    }
    const Compared& now(std::size_t place, std::size_t row) const {
      return thread.chain[index(place, row)].now;
    }
    void want(std::size_t place, std::size_t row) const {
      const std::size_t at = index(place, row);
      if (thread.chain[at].is_refined) return;
      thread.chain[at].is_refined = true;
      thread.wanted.push_back(
          {{chain.columns[place], top + static_cast<std::uint32_t>(row) - 1}, at});
    }
  };

  Centre& centre(std::int32_t column, std::int32_t row) {
    return m_centres[static_cast<std::size_t>(row - (static_cast<std::int32_t>(m_top) - 1)) *
                         m_plan.stride +
                     static_cast<std::size_t>(column - m_plan.base)];
  }
  Centre& centre(const Pixel& p) {
    return centre(static_cast<std::int32_t>(p.column), static_cast<std::int32_t>(p.row));
  }

  void recall(std::uint32_t first, std::uint32_t end) {
    recall_colours(m_setup, 1, m_top, m_bottom, m_image_top, m_image);
    if (!m_setup.known(0)) return;
    recall_samples(m_setup, m_plan.columns, first, end,
                   [this](const Pixel& p, const Radiance& seen) {
                     Centre& out = centre(p);
                     out.seen = seen;
                     out.compared = m_setup.space.of(seen);
                   });
  }

  bool trace_centres(std::size_t job, FilmThread& thread) {
    m_order->pixels(job, thread.pixels);
    leave_out(m_setup.known(0), thread.pixels);
    const auto place = [&](std::size_t i) { return place_of(thread.pixels[i]); };
    if (!trace(thread.pixels.size(), place, thread)) return false;
    if (m_setup.keeps()) {
      keep_samples(m_setup, thread, [this](const Pixel& p) { return centre(p).seen; });
    }
    return true;
  }

  bool trace_border(std::size_t part, FilmThread& thread) {
    const std::size_t first = part * kBorderPixels;
    const auto place = [&](std::size_t i) { return m_border[first + i]; };
    return trace(std::min(m_border.size() - first, kBorderPixels), place, thread);
  }

  /// Pixels' centres; `place(i)` -> PixelPlace.
  template <class Place>
  bool trace(std::size_t count, const Place& place, FilmThread& thread) {
    return thread.sampler.samples(
        count, Sampler::Layout::kNeighbours, [&](std::size_t i) { return SamplePlace{place(i)}; },
        [&](std::size_t i, const Sample& sample) {
          const PixelPlace at = place(i);
          Centre& out = centre(at.column, at.row);
          out.seen = sample.seen;
          out.compared = m_setup.space.of(sample.seen);
          if (!sample.has_ray && is_own(at)) ++thread.counters.dark_pixels;
          return thread.begins();
        });
  }

  bool is_own(const PixelPlace& at) const {
    return at.column >= 0 && at.row >= static_cast<std::int32_t>(m_top) &&
           at.row < static_cast<std::int32_t>(m_bottom);
  }

  bool refine_chain(std::size_t job, FilmThread& thread) {
    const auto tile = static_cast<std::uint32_t>(job / m_plan.chains.size());
    const std::uint32_t top = m_top + tile * kTile;
    const Walk walk{m_plan.chains[job % m_plan.chains.size()], top, std::min(top + kTile, m_bottom),
                    thread};
    if (is_known(walk)) return true;
    begin(walk);
    if (!follow(walk)) return false;
    if (!m_setup.keeps()) return true;
    thread.pixels.clear();
    for (std::uint32_t row = walk.top; row < walk.bottom; ++row) {
      for (const std::uint32_t k : walk.chain.columns) thread.pixels.push_back({k, row});
    }
    keep_colours(m_setup, 1, m_image_top, m_image, thread);
    return true;
  }

  /// All colours of the chain.
  bool is_known(const Walk& walk) const {
    const PixelSet* known = m_setup.known(1);
    if (!known) return false;
    for (std::uint32_t row = walk.top; row < walk.bottom; ++row) {
      for (const std::uint32_t k : walk.chain.columns) {
        if (m_setup.region.has({k, row}) && !known->has({k, row})) return false;
      }
    }
    return true;
  }

  /// Pixels that are not refined show their centres. Those above the tile are not refined from here.
  void begin(const Walk& walk) {
    FilmThread& thread = walk.thread;
    thread.wanted.clear();
    thread.chain.clear();
    for (const std::uint32_t k : walk.chain.columns) {
      thread.chain.push_back({compared(k, walk.top, -1), true});
    }
    for (std::uint32_t row = walk.top; row < walk.bottom; ++row) {
      for (const std::uint32_t k : walk.chain.columns) {
        const Centre& here = centre({k, row});
        thread.chain.push_back({here.compared, false});
        put({k, row}, here.seen);
      }
    }
  }

  bool follow(const Walk& walk) {
    const std::size_t count = walk.chain.columns.size(), rows = walk.rows();
    bool goes_on = true;
    for (std::size_t step = 0; step < walk.chain.steps(rows); ++step) {
      walk.chain.at_step(step, rows, [&](std::size_t place, std::size_t row) {
        if (place >= count) return visit_ahead(walk, place - count, row + 1);
        goes_on = walk.thread.begins() && goes_on;
        visit(walk, place, row + 1);
      });
      if (!goes_on || !refine(walk.thread)) return false;
    }
    if (walk.bottom == m_setup.height) return true;
    for (std::size_t i = 0; i < count; ++i) {
      if (differ(walk.now(i, rows), compared(walk.chain.columns[i], walk.bottom, 0))) {
        walk.want(i, rows);
      }
    }
    return refine(walk.thread);
  }

  void visit(const Walk& walk, std::size_t place, std::size_t row) {
    const std::uint32_t k = walk.chain.columns[place], left = walk.chain.left[place];
    const Compared& here = walk.now(place, row);
    const bool is_first = left == PixelChain::kOutside;
    const auto image_row = static_cast<std::int32_t>(walk.top + row - 1);
    const bool differs_left = differ(
        is_first ? centre(m_setup.lattice.left[k], image_row).compared : walk.now(left, row), here);
    const bool differs_above = differ(walk.now(place, row - 1), here);
    if (differs_left && !is_first) walk.want(left, row);
    if (differs_above) walk.want(place, row - 1);
    if (differs_left || differs_above) walk.want(place, row);
  }

  void visit_ahead(const Walk& walk, std::size_t which, std::size_t row) {
    const auto& [place, column] = walk.chain.ahead[which];
    const auto image_row = walk.top + static_cast<std::uint32_t>(row) - 1;
    if (differ(walk.now(place, row), compared(column, image_row, 0))) walk.want(place, row);
  }

  /// Of the bare centre of a pixel, `off` rows further.
  const Compared& compared(std::uint32_t column, std::uint32_t row, std::int32_t off) {
    return centre(static_cast<std::int32_t>(column), static_cast<std::int32_t>(row) + off).compared;
  }

  bool differ(const Compared& a, const Compared& b) const {
    return a.distance(b) >= static_cast<float>(m_setup.antialiasing.threshold);
  }

  /// The pixels that are wanted become the means of their centres and the samples of grids over them.
  bool refine(FilmThread& thread) {
    const float share = 1.0f / static_cast<float>(m_cells + 1);
    Radiance sum;
    const bool goes_on = thread.sampler.samples(
        thread.wanted.size() * m_cells, Sampler::Layout::kScattered,
        [&](std::size_t i) {
          return finer(thread.wanted[i / m_cells].pixel, static_cast<std::uint32_t>(i % m_cells));
        },
        [&](std::size_t i, const Sample& sample) {
          const FilmThread::Wanted& wanted = thread.wanted[i / m_cells];
          if (i % m_cells == 0) sum = centre(wanted.pixel).seen;
          sum += sample.seen;
          if (i % m_cells + 1 < m_cells) return true;
          const Radiance mean = sum * share;
          put(wanted.pixel, mean);
          thread.chain[wanted.at].now = m_setup.space.of(mean);
          ++thread.counters.antialiased_pixels;
          return !thread.is_cancelled();
        });
    thread.wanted.clear();
    return goes_on;
  }

  SamplePlace finer(const Pixel& pixel, std::uint32_t cell) const {
    const Antialiasing& aa = m_setup.antialiasing;
    SamplePlace out{cell_of(pixel, aa.depth, cell), cell + 1};
    if (!(aa.jitter > 0.0)) return out;
    RandomSequence random(sample_key(out.place.column, out.place.row, out.index),
                          RandomSequence::Use::kFilm);
    const double step = 1.0 / aa.depth;
    out.place.across += (random.next() - 0.5) * aa.jitter * step;
    out.place.down += (random.next() - 0.5) * aa.jitter * step;
    return out;
  }

  void put(const Pixel& pixel, const Radiance& seen) {
    if (!m_setup.region.has(pixel)) return;
    store(seen, m_setup.alpha, m_image.pixel(pixel.column, pixel.row - m_image_top));
  }

  const CentresPlan& m_plan;
  const FilmSetup& m_setup;
  const std::uint32_t m_top, m_bottom, m_image_top;
  Image& m_image;
  const std::size_t m_cells;  ///< of a pixel that is refined
  std::unique_ptr<PixelOrder> m_order;
  std::vector<PixelPlace> m_border;  ///< the centres of pixels outside the image
  std::vector<Centre> m_centres;
};

}  // namespace

FilmColumns traced_columns_of_centres(const FilmSetup& setup) {
  const Tiles tiles = tiles_of(setup);
  if (tiles.first == tiles.end) return {};
  const PixelLattice& lattice = setup.lattice;
  FilmColumns out{lattice.tiles[tiles.first], lattice.tiles[tiles.end]};
  const auto end = static_cast<std::int32_t>(out.right);
  while (out.right < setup.width && lattice.left[out.right] < end) ++out.right;
  // The neighbours of the tile's first lens are those of its first columns.
  std::int32_t least = static_cast<std::int32_t>(out.left);
  for (std::uint32_t k = out.left; k < static_cast<std::uint32_t>(end); ++k)
    least = std::min(least, lattice.left[k]);
  out.left = static_cast<std::uint32_t>(std::max(least, 0));
  return out;
}

std::unique_ptr<Film> make_film_of_centres(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<FilmOf<CentresPlan, CentresBand>>(std::move(setup), orders);
}

}  // namespace lentray::core
