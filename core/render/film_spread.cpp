// Sampling for the eye. Nobody sees a pixel of a print: the eye blends several rows, and the lens
// several columns. So the samples of pixels that are seen together lie at different places of their
// areas, well spread, and the eye averages them.
//
// A pixel's neighbours are the same view's in the lenses beside it, and in the rows above and below.
// First every second pixel has one sample, so that those between have four neighbours with one. Where
// these agree, a pixel between them is the mean of the two above and below; otherwise it has a sample
// too. Then a pixel that differs from a neighbour has depth more (and a first, if it has none). It
// becomes the mean of all in linear light, each clipped to what the picture's file can hold.
// A sample's place follows from its pixel's row, lens and view and its own number, and the tests
// look at first samples alone: a part of a picture has the whole picture's pixels.
// Source: core/render/eye_place.h; tests/bench/eye_samples.py measures what an eye sees.
#include "core/render/film_of.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace lentray::core {
namespace {

/// Neighbours agree that differ by less than this part of the threshold.
constexpr float kBetween = 1.0f / 3.0f;

/// The columns, and those beside them in the neighbouring lenses.
FilmColumns with_neighbours(const FilmSetup& setup, FilmColumns columns) {
  const std::vector<std::int32_t>& left = setup.lattice.left;
  FilmColumns out = columns;
  for (std::uint32_t k = columns.left; k < columns.right; ++k)
    out.left = std::min(out.left, static_cast<std::uint32_t>(std::max(0, left[k])));
  const auto end = static_cast<std::int32_t>(columns.right);
  while (out.right < setup.width && left[out.right] < end) ++out.right;
  return out;
}

struct SpreadPlan : FilmPlan {
  SpreadPlan(FilmSetup s, const BandOrders& o)
      : FilmPlan(std::move(s), o), columns(traced_columns_of_spread(setup)),
        near(with_neighbours(setup, {setup.region.left, setup.region.right})),
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
    return spread_sample(*setup.camera, pixel, number);
  }

  /// Every second pixel of a view.
  bool is_first(const Pixel& p) const {
    const EyePlace at = setup.camera->eye_place(p.column, p.row);
    return ((at.row + at.view + at.lens) & 1) == 0;
  }

  /// Whether `ask(column)` is true of the same view in the lenses beside a column, as far as they are kept.
  template <class Ask>
  bool all_beside(std::uint32_t column, Ask&& ask) const {
    const std::int32_t left = setup.lattice.left[column];
    if (left >= static_cast<std::int32_t>(columns.left) && !ask(static_cast<std::uint32_t>(left)))
      return false;
    for (std::uint32_t i = first_right[column]; i < first_right[column + 1]; ++i) {
      if (right[i] < columns.right && !ask(right[i])) return false;
    }
    return true;
  }

  FilmColumns columns;                     ///< of samples that decide of pixels
  FilmColumns near;                        ///< of neighbours
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
        m_first(top > kReach ? top - kReach : 0),
        m_end(std::min(bottom + kReach, plan.setup.height)), m_image_top(image_top), m_image(image),
        m_traced(plan.orders.band(m_first, m_end)), m_shown(plan.orders.band(top, bottom)),
        m_base(plan.stride * (m_end - m_first)) {
    recall_colours(m_setup, 1, top, bottom, image_top, image);
    if (!m_setup.known(0)) return;
    recall_samples(m_setup, plan.columns, m_first, m_end,
                   [this](const Pixel& p, const Radiance& seen) {
                     base(p).is_first = m_plan.is_first(p);
                     keep_base(p, seen);
                   });
  }

  std::size_t stages() const override { return 3; }
  std::size_t jobs(std::size_t stage) const override {
    return (stage < 2 ? m_traced : m_shown)->jobs();
  }
  bool work(std::size_t stage, std::size_t job, FilmThread& thread) override {
    if (stage == 2) return refine(job, thread);
    m_traced->pixels(job, thread.pixels);
    return stage == 0 ? trace_first(thread) : trace_between(thread);
  }

 private:
  static constexpr std::uint32_t kReach = 2;  ///< rows whose samples decide of a pixel

  struct Base {
    Radiance seen;  ///< the first sample, or what neighbours make of it
    Compared compared;
    bool is_first = false;    ///< it has a sample whatever its neighbours have
    bool has_sample = false;  ///< that is its own
  };

  Base& base(std::uint32_t column, std::uint32_t row) {
    return m_base[(row - m_first) * m_plan.stride + (column - m_plan.columns.left)];
  }
  Base& base(const Pixel& p) { return base(p.column, p.row); }
  void keep_base(const Pixel& p, const Radiance& seen) {
    Base& b = base(p);
    b.seen = seen;
    b.compared = m_setup.space.of(seen);
    b.has_sample = true;
  }

  bool trace_first(FilmThread& thread) {
    std::erase_if(thread.pixels, [this](const Pixel& p) { return !m_plan.is_first(p); });
    leave_out(m_setup.known(0), thread.pixels);
    for (const Pixel& p : thread.pixels) base(p).is_first = true;
    return trace_base(thread);
  }

  bool trace_between(FilmThread& thread) {
    std::erase_if(thread.pixels, [this](const Pixel& p) {
      return base(p).is_first || p.row + 1 < m_top || p.row > m_bottom ||
             !m_plan.near.has(p.column);
    });
    leave_out(m_setup.known(0), thread.pixels);
    std::erase_if(thread.pixels,
                  [&](const Pixel& p) { return lies_between(p) && thread.begins(); });
    return trace_base(thread);
  }

  /// The neighbours of a pixel agree, and it is their mean now. False: it is left as it is, and needs a sample.
  bool lies_between(const Pixel& p) {
    if (p.row == 0 || p.row + 1 == m_setup.height) return false;
    const Base &above = base(p.column, p.row - 1), &below = base(p.column, p.row + 1);
    if (!above.is_first || !below.is_first) return false;
    const Compared mean = middle(above.compared, below.compared);
    const float limit = kBetween * static_cast<float>(m_setup.antialiasing.threshold);
    const auto agrees = [&](const Base& b) {
      return b.is_first && mean.distance(b.compared) < limit;
    };
    if (!agrees(above)) return false;
    if (!m_plan.all_beside(p.column,
                           [&](std::uint32_t column) { return agrees(base(column, p.row)); }))
      return false;
    Base& b = base(p);
    b.seen = above.seen * 0.5f;
    b.seen += below.seen * 0.5f;
    b.compared = mean;
    return true;
  }

  static Compared middle(const Compared& one, const Compared& two) {
    return {(one.rgb + two.rgb) * 0.5f, 0.5f * (one.transmit + two.transmit)};
  }

  bool trace_base(FilmThread& thread) {
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
    return !m_plan.all_beside(p.column,
                              [&](std::uint32_t column) { return !differs(column, p.row); });
  }

  /// The number of the first sample that a pixel lacks.
  std::size_t first_more(const Pixel& p) { return base(p).has_sample ? 1 : 0; }

  bool refine(std::size_t job, FilmThread& thread) {
    m_shown->pixels(job, thread.pixels);
    std::erase_if(thread.pixels, [this](const Pixel& p) { return !m_setup.region.has(p); });
    leave_out(m_setup.known(1), thread.pixels);
    thread.wanted.clear();
    const auto more = static_cast<std::size_t>(m_setup.antialiasing.depth);
    for (const Pixel& p : thread.pixels) {
      if (is_to_be_refined(p)) {
        for (std::size_t i = first_more(p); i <= more; ++i) thread.wanted.push_back({p, i});
      } else {
        put(p, base(p).seen);
      }
      if (!thread.begins()) return false;
    }
    const float share = 1.0f / static_cast<float>(more + 1);
    Radiance sum;
    const bool goes_on = thread.sampler.samples(
        thread.wanted.size(), Sampler::Layout::kNeighbours,
        [&](std::size_t i) {
          const FilmThread::Wanted& wanted = thread.wanted[i];
          return m_plan.sample(wanted.pixel, static_cast<std::uint32_t>(wanted.at));
        },
        [&](std::size_t i, const Sample& sample) {
          const auto& [p, number] = thread.wanted[i];
          if (number == first_more(p))
            sum = base(p).has_sample ? m_setup.light.of(base(p).seen) : Radiance{};
          sum += m_setup.light.of(sample.has_ray ? sample.seen : Radiance{});
          if (number < more) return true;
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

SamplePlace spread_sample(const RaySource& camera, const Pixel& pixel, std::uint32_t number) {
  const SpreadPlace at = spread_place(camera.eye_place(pixel.column, pixel.row), number);
  SamplePlace out{place_of(pixel), number};
  out.place.across = at.across;
  out.place.down = at.down;
  return out;
}

FilmColumns traced_columns_of_spread(const FilmSetup& setup) {
  return with_neighbours(setup, with_neighbours(setup, {setup.region.left, setup.region.right}));
}

std::unique_ptr<Film> make_film_of_spread(FilmSetup setup, const BandOrders& orders) {
  return std::make_unique<FilmOf<SpreadPlan, SpreadBand>>(std::move(setup), orders);
}

}  // namespace lentray::core
