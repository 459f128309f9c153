// Antialiasing method 1: adaptive, not recursive. All pixels' centres come first, in the pixel
// order; then, row by row, a pixel is compared with what its left and upper neighbours have become,
// and where two differ both get depth x depth samples more.
//
// What a pixel becomes depends on what happened before it, so the rows are chains. They begin anew
// in tiles of PixelLattice::kTile pixels each way, counted from the image's corner: a tile sees the
// bare centres of the pixels around it. So tiles can be traced alone and at once, and a part of a
// picture has the whole picture's pixels. Within a tile, pixels that do not join one another (other
// views behind a lens sheet) are chains of their own.
// Source: reference manual 3.7, "Sampling_Method"; the order of the comparisons and the weights
// measured on stock by tests/image/antialiasing_test.cpp.
#include "core/render/film_of.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/trace/random_key.h"

namespace lentray::core {
namespace {

constexpr std::uint32_t kTile = PixelLattice::kTile;
constexpr std::size_t kBorderPixels = 1024;  ///< pixels outside the image that are traced at a time

/// Pixels of a tile that join one another: their columns, ascending.
struct Chain {
  std::uint32_t begin = 0;  ///< of the tile
  std::vector<std::uint32_t> columns;
  std::vector<std::uint32_t>
      left;  ///< by place in `columns`: that of the left neighbour, or kOutside
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      ahead;  ///< place, and its neighbour on the right
};
constexpr std::uint32_t kOutside = ~0u;

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

std::vector<Chain> chains_of_tile(const PixelLattice& lattice, std::uint32_t begin,
                                  std::uint32_t end) {
  std::vector<Chain> chains;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> at(end - begin);  // chain, place in it
  for (std::uint32_t k = begin; k < lattice.width(); ++k) {
    const std::int32_t left = lattice.left[k];
    const bool joins = left >= static_cast<std::int32_t>(begin);
    if (k >= end) {
      if (left >= static_cast<std::int32_t>(end)) break;
      if (!joins) continue;
      const auto& [chain, place] = at[static_cast<std::uint32_t>(left) - begin];
      chains[chain].ahead.emplace_back(place, k);
      continue;
    }
    std::uint32_t chain = static_cast<std::uint32_t>(chains.size()), neighbour = kOutside;
    if (joins) {
      std::tie(chain, neighbour) = at[static_cast<std::uint32_t>(left) - begin];
    } else {
      chains.emplace_back().begin = begin;
    }
    at[k - begin] = {chain, static_cast<std::uint32_t>(chains[chain].columns.size())};
    chains[chain].columns.push_back(k);
    chains[chain].left.push_back(neighbour);
  }
  return chains;
}

std::vector<Chain> chains_of(const FilmSetup& setup) {
  std::vector<Chain> out;
  const Tiles tiles = tiles_of(setup);
  for (std::size_t i = tiles.first; i < tiles.end; ++i) {
    for (Chain& chain :
         chains_of_tile(setup.lattice, setup.lattice.tiles[i], setup.lattice.tiles[i + 1])) {
      out.push_back(std::move(chain));
    }
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
  std::vector<Chain> chains;
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
        m_image(image) {
    const std::uint32_t first = top > 0 ? top - 1 : 0;
    m_order = plan.orders.band(first, std::min(bottom + 1, m_setup.height));
    if (plan.base < 0) {
      for (std::uint32_t row = top; row < bottom; ++row) {
        for (std::int32_t k = plan.base; k < 0; ++k)
          m_border.push_back({k, static_cast<std::int32_t>(row)});
      }
    }
    if (top == 0) {
      for (std::uint32_t k = plan.columns.left; k < plan.columns.right; ++k) {
        m_border.push_back({static_cast<std::int32_t>(k), -1});
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
    if (stage == 1) {
      const auto tile = static_cast<std::uint32_t>(job / m_plan.chains.size());
      const std::uint32_t top = m_top + tile * kTile, bottom = std::min(top + kTile, m_bottom);
      const Chain& chain = m_plan.chains[job % m_plan.chains.size()];
      if (is_known(chain, top, bottom)) return true;
      if (!follow(chain, top, bottom, thread)) return false;
      if (m_setup.keeps()) keep_colours(m_setup, 1, m_image_top, m_image, thread);
      return true;
    }
    if (job < m_order->jobs()) {
      m_order->pixels(job, thread.pixels);
      leave_out(m_setup.known(0), thread.pixels);
      for (const Pixel& p : thread.pixels) {
        if (!thread.begins()) return false;
        const bool seen =
            trace(static_cast<std::int32_t>(p.column), static_cast<std::int32_t>(p.row), thread);
        if (!seen && p.row >= m_top && p.row < m_bottom) ++thread.counters.dark_pixels;
      }
      if (m_setup.keeps()) {
        keep_samples(m_setup, thread, [this](const Pixel& p) { return centre(p).seen; });
      }
      return true;
    }
    thread.pixels.clear();
    const std::size_t first = (job - m_order->jobs()) * kBorderPixels;
    const std::size_t end = std::min(m_border.size(), first + kBorderPixels);
    for (std::size_t i = first; i < end; ++i) {
      if (!thread.begins()) return false;
      trace(m_border[i].first, m_border[i].second, thread);
    }
    return true;
  }

 private:
  struct Centre {
    Radiance seen;
    Compared compared;
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

  /// All colours of the chain in the rows [top, bottom).
  bool is_known(const Chain& chain, std::uint32_t top, std::uint32_t bottom) const {
    const PixelSet* known = m_setup.known(1);
    if (!known) return false;
    for (std::uint32_t row = top; row < bottom; ++row) {
      for (const std::uint32_t k : chain.columns) {
        if (m_setup.region.has({k, row}) && !known->has({k, row})) return false;
      }
    }
    return true;
  }

  bool trace(std::int32_t column, std::int32_t row, FilmThread& thread) {
    Centre& out = centre(column, row);
    const bool seen = thread.sampler.sample({.column = column, .row = row}, 0, out.seen);
    out.compared = m_setup.space.of(out.seen);
    return seen;
  }

  /// The mean of the centre and the samples of a grid over the pixel, written to the image.
  Compared finer(std::uint32_t column, std::uint32_t row, FilmThread& thread) {
    const auto c = static_cast<std::int32_t>(column), r = static_cast<std::int32_t>(row);
    const Antialiasing& aa = m_setup.antialiasing;
    const double step = 1.0 / aa.depth;
    Radiance sum = centre(c, r).seen;
    for (int i = 0; i < aa.depth * aa.depth; ++i) {
      const auto index = static_cast<std::uint32_t>(i) + 1;
      PixelPlace place{.column = c,
                       .row = r,
                       .across = (i % aa.depth + 0.5) * step - 0.5,
                       .down = (i / aa.depth + 0.5) * step - 0.5};
      if (aa.jitter > 0.0) {
        RandomSequence random(sample_key(c, r, index), RandomSequence::Use::kFilm);
        place.across += (random.next() - 0.5) * aa.jitter * step;
        place.down += (random.next() - 0.5) * aa.jitter * step;
      }
      Radiance one;
      thread.sampler.sample(place, index, one);
      sum += one;
    }
    const float share = 1.0f / static_cast<float>(aa.depth * aa.depth + 1);
    const Radiance mean = sum * share;
    put(column, row, mean);
    ++thread.counters.antialiased_pixels;
    return m_setup.space.of(mean);
  }

  void put(std::uint32_t column, std::uint32_t row, const Radiance& seen) {
    if (m_setup.region.has({column, row})) {
      store(seen, m_setup.alpha, m_image.pixel(column, row - m_image_top));
    }
  }

  bool differ(const Compared& a, const Compared& b) const {
    return a.distance(b) >= static_cast<float>(m_setup.antialiasing.threshold);
  }

  /// A chain through the rows [top, bottom) of its tile.
  bool follow(const Chain& chain, std::uint32_t top, std::uint32_t bottom, FilmThread& thread) {
    const std::size_t count = chain.columns.size();
    thread.above.resize(count);
    thread.above_sampled.assign(count, 1);
    thread.row.resize(count);
    thread.row_sampled.resize(count);
    thread.pixels.clear();
    for (std::size_t i = 0; i < count; ++i) thread.above[i] = compared(chain.columns[i], top, -1);
    for (std::uint32_t row = top; row < bottom; ++row) {
      if (!follow_row(chain, row, thread)) return false;
      thread.above.swap(thread.row);
      thread.above_sampled.swap(thread.row_sampled);
      for (const std::uint32_t k : chain.columns) thread.pixels.push_back({k, row});
    }
    if (bottom == m_setup.height) return true;
    for (std::size_t i = 0; i < count; ++i) {
      if (thread.above_sampled[i] ||
          !differ(thread.above[i], compared(chain.columns[i], bottom, 0)))
        continue;
      finer(chain.columns[i], bottom - 1, thread);
    }
    return true;
  }

  /// Of the bare centre of a pixel, `off` rows further.
  const Compared& compared(std::uint32_t column, std::uint32_t row, std::int32_t off) {
    return centre(static_cast<std::int32_t>(column), static_cast<std::int32_t>(row) + off).compared;
  }

  bool follow_row(const Chain& chain, std::uint32_t row, FilmThread& thread) {
    std::fill(thread.row_sampled.begin(), thread.row_sampled.end(), std::uint8_t{0});
    for (std::size_t i = 0; i < chain.columns.size(); ++i) {
      const std::uint32_t k = chain.columns[i], left = chain.left[i];
      if (!thread.begins()) return false;
      const Centre& here = centre(static_cast<std::int32_t>(k), static_cast<std::int32_t>(row));
      thread.row[i] = here.compared;
      put(k, row, here.seen);
      const Compared& beside =
          left == kOutside
              ? centre(m_setup.lattice.left[k], static_cast<std::int32_t>(row)).compared
              : thread.row[left];
      const bool differs_left = differ(beside, here.compared);
      const bool differs_above = differ(thread.above[i], here.compared);
      if (differs_left && left != kOutside && !thread.row_sampled[left]) {
        sample_finer(chain.columns[left], row, thread.row[left], thread.row_sampled[left], thread);
      }
      if (differs_above && !thread.above_sampled[i]) {
        sample_finer(k, row - 1, thread.above[i], thread.above_sampled[i], thread);
      }
      if (differs_left || differs_above)
        sample_finer(k, row, thread.row[i], thread.row_sampled[i], thread);
    }
    for (const auto& [i, k] : chain.ahead) {
      if (differ(thread.row[i], compared(k, row, 0)) && !thread.row_sampled[i]) {
        sample_finer(chain.columns[i], row, thread.row[i], thread.row_sampled[i], thread);
      }
    }
    return true;
  }

  void sample_finer(std::uint32_t column, std::uint32_t row, Compared& now, std::uint8_t& sampled,
                    FilmThread& thread) {
    now = finer(column, row, thread);
    sampled = 1;
  }

  const CentresPlan& m_plan;
  const FilmSetup& m_setup;
  const std::uint32_t m_top, m_bottom, m_image_top;
  Image& m_image;
  std::unique_ptr<PixelOrder> m_order;
  std::vector<std::pair<std::int32_t, std::int32_t>> m_border;  ///< pixels outside the image
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
