// Sampling for the eye. Nobody sees a pixel of a print: the eye blends several rows, and the lens
// several columns. So the samples of pixels that are seen together lie at different places of their
// areas, well spread, and the eye averages them.
//
// First each pixel has one sample. Then a pixel has depth more if its first one differs from that
// of a neighbour: the same view's in the lenses beside it, and in the rows above and below. It
// becomes the mean of all in linear light, each clipped to what the picture's file can hold.
// A sample's place follows from its pixel's row, lens and view and its own number, and the test
// looks at first samples alone: a part of a picture has the whole picture's pixels.
// Source: the steps from row to row and from sample to sample are those of M. Roberts' sequences of
// three and of two dimensions ("The Unreasonable Effectiveness of Quasirandom Sequences", 2018);
// those from lens to lens keep neighbouring lenses apart. tests/bench/eye_samples.py measures what
// an eye sees.
#include "core/render/film_of.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace lentray::core {
namespace {

struct SpreadPlan : FilmPlan {
  SpreadPlan(FilmSetup s, const BandOrders& o)
      : FilmPlan(std::move(s), o), columns(traced_columns_of_spread(setup)),
        stride(columns.right - columns.left), first_right(setup.width + 1) {
    // The columns that have a column on their left, in its order.
    const std::vector<std::int32_t>& left = setup.lattice.left;
    for (const std::int32_t k : left) {
      if (k >= 0) ++first_right[static_cast<std::size_t>(k) + 1];
    }
    for (std::size_t k = 0; k < setup.width; ++k) first_right[k + 1] += first_right[k];
    right.resize(first_right.back());
    std::vector<std::uint32_t> next = first_right;
    for (std::uint32_t k = 0; k < setup.width; ++k) {
      if (left[k] >= 0) right[next[static_cast<std::size_t>(left[k])]++] = k;
    }
  }

  SamplePlace sample(const Pixel& pixel, std::uint32_t number) const {
    const SpreadPlace at = spread_place(setup.camera->eye_place(pixel.column, pixel.row), number);
    SamplePlace out{place_of(pixel), number};
    out.place.across = at.across;
    out.place.down = at.down;
    return out;
  }

  FilmColumns columns;
  std::size_t stride;                      ///< columns that are kept
  std::vector<std::uint32_t> first_right;  ///< by column, where they begin in `right`
  std::vector<std::uint32_t> right;        ///< columns on the right
};

class SpreadBand final : public FilmBand {
 public:
  /// Rows [top, bottom); the image begins with row `image_top`.
  SpreadBand(const SpreadPlan& plan, std::uint32_t top, std::uint32_t bottom,
             std::uint32_t image_top, Image& image)
      : m_plan(plan), m_setup(plan.setup), m_top(top), m_bottom(bottom),
        m_first(top > 0 ? top - 1 : 0), m_end(std::min(bottom + 1, plan.setup.height)),
        m_image_top(image_top), m_image(image), m_traced(plan.orders.band(m_first, m_end)),
        m_shown(plan.orders.band(top, bottom)), m_base(plan.stride * (m_end - m_first)) {
    recall_colours(m_setup, 1, top, bottom, image_top, image);
    if (!m_setup.known(0)) return;
    recall_samples(m_setup, plan.columns, m_first, m_end,
                   [this](const Pixel& p, const Radiance& seen) { keep_base(p, seen); });
  }

  std::size_t stages() const override { return 2; }
  std::size_t jobs(std::size_t stage) const override {
    return (stage == 0 ? m_traced : m_shown)->jobs();
  }
  bool work(std::size_t stage, std::size_t job, FilmThread& thread) override {
    return stage == 0 ? trace_base(job, thread) : refine(job, thread);
  }

 private:
  struct Base {
    Radiance seen;
    Compared compared;
  };

  Base& base(std::uint32_t column, std::uint32_t row) {
    return m_base[(row - m_first) * m_plan.stride + (column - m_plan.columns.left)];
  }
  Base& base(const Pixel& p) { return base(p.column, p.row); }
  void keep_base(const Pixel& p, const Radiance& seen) { base(p) = {seen, m_setup.space.of(seen)}; }

  bool trace_base(std::size_t job, FilmThread& thread) {
    m_traced->pixels(job, thread.pixels);
    leave_out(m_setup.known(0), thread.pixels);
    const bool goes_on = thread.sampler.samples(
        thread.pixels.size(), Sampler::Layout::kNeighbours,
        [&](std::size_t i) { return m_plan.sample(thread.pixels[i], 0); },
        [&](std::size_t i, const Sample& sample) {
          const Pixel& p = thread.pixels[i];
          if (!sample.has_ray && is_own(p)) ++thread.counters.dark_pixels;
          keep_base(p, sample.has_ray ? sample.seen : Radiance{});  // not clear
          return thread.begins();
        });
    if (goes_on && m_setup.keeps())
      keep_samples(m_setup, thread, [this](const Pixel& p) { return base(p).seen; });
    return goes_on;
  }

  bool is_own(const Pixel& p) const {
    return p.row >= m_top && p.row < m_bottom && m_setup.region.has(p);
  }

  bool is_to_be_refined(const Pixel& p) {
    const Compared& here = base(p).compared;
    const auto differs = [&](std::uint32_t column, std::uint32_t row) {
      return here.distance(base(column, row).compared) >=
             static_cast<float>(m_setup.antialiasing.threshold);
    };
    if (p.row > m_first && differs(p.column, p.row - 1)) return true;
    if (p.row + 1 < m_end && differs(p.column, p.row + 1)) return true;
    const std::int32_t left = m_setup.lattice.left[p.column];
    if (left >= 0 && differs(static_cast<std::uint32_t>(left), p.row)) return true;
    for (std::uint32_t i = m_plan.first_right[p.column]; i < m_plan.first_right[p.column + 1];
         ++i) {
      if (differs(m_plan.right[i], p.row)) return true;
    }
    return false;
  }

  bool refine(std::size_t job, FilmThread& thread) {
    m_shown->pixels(job, thread.pixels);
    std::erase_if(thread.pixels, [this](const Pixel& p) { return !m_setup.region.has(p); });
    leave_out(m_setup.known(1), thread.pixels);
    thread.wanted.clear();
    for (const Pixel& p : thread.pixels) {
      if (is_to_be_refined(p)) {
        thread.wanted.push_back({p, 0});
      } else {
        put(p, base(p).seen);
      }
      if (!thread.begins()) return false;
    }
    const auto more = static_cast<std::size_t>(m_setup.antialiasing.depth);
    const float share = 1.0f / static_cast<float>(more + 1);
    Radiance sum;
    const bool goes_on = thread.sampler.samples(
        thread.wanted.size() * more, Sampler::Layout::kNeighbours,
        [&](std::size_t i) {
          return m_plan.sample(thread.wanted[i / more].pixel,
                               static_cast<std::uint32_t>(i % more + 1));
        },
        [&](std::size_t i, const Sample& sample) {
          const Pixel& p = thread.wanted[i / more].pixel;
          if (i % more == 0) sum = m_setup.light.of(base(p).seen);
          sum += m_setup.light.of(sample.has_ray ? sample.seen : Radiance{});
          if (i % more + 1 < more) return true;
          put(p, m_setup.light.back(sum * share));
          ++thread.counters.antialiased_pixels;
          return !thread.is_cancelled();
        });
    if (goes_on && m_setup.keeps()) keep_colours(m_setup, 1, m_image_top, m_image, thread);
    return goes_on;
  }

  void put(const Pixel& p, const Radiance& seen) {
    store(seen, m_setup.alpha, m_image.pixel(p.column, p.row - m_image_top));
  }

  const SpreadPlan& m_plan;
  const FilmSetup& m_setup;
  const std::uint32_t m_top, m_bottom;
  const std::uint32_t m_first, m_end;  ///< rows that have samples
  const std::uint32_t m_image_top;
  Image& m_image;
  const std::unique_ptr<PixelOrder> m_traced, m_shown;
  std::vector<Base> m_base;
};

}  // namespace

FilmColumns traced_columns_of_spread(const FilmSetup& setup) {
  FilmColumns out{setup.region.left, setup.region.right};
  const std::vector<std::int32_t>& left = setup.lattice.left;
  for (std::uint32_t k = setup.region.left; k < setup.region.right; ++k)
    out.left = std::min(out.left, static_cast<std::uint32_t>(std::max(0, left[k])));
  const auto end = static_cast<std::int32_t>(setup.region.right);
  while (out.right < setup.width && left[out.right] < end) ++out.right;
  return out;
}

std::unique_ptr<Film> make_film_of_spread(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<FilmOf<SpreadPlan, SpreadBand>>(std::move(setup), orders);
}

}  // namespace lentray::core
