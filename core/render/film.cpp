#include "core/render/film.h"

#include <algorithm>
#include <utility>

#include "core/render/film_of.h"

namespace lentray::core {
namespace {

/// Of pixels that do not depend on one another: each is traced once, in the pixel order.
class OnePassBand : public FilmBand {
 public:
  OnePassBand(const FilmPlan& plan, std::uint32_t first, std::uint32_t end, std::uint32_t top,
              Image& image)
      : m_setup(plan.setup), m_top(top), m_image(image), m_order(plan.orders.band(first, end)) {
    recall_colours(m_setup, 0, first, end, top, image);
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

/// One sample a pixel.
class PlainBand final : public OnePassBand {
 public:
  using OnePassBand::OnePassBand;

 private:
  bool trace(FilmThread& thread) override {
    return thread.sampler.samples(
        thread.pixels.size(), Sampler::Layout::kNeighbours,
        [&](std::size_t i) { return SamplePlace{place_of(thread.pixels[i])}; },
        [&](std::size_t i, const Sample& sample) {
          const Pixel& p = thread.pixels[i];
          if (!sample.has_ray) ++thread.counters.dark_pixels;
          store(sample.has_ray ? sample.seen : Radiance{},  // not clear
                m_setup.alpha, m_image.pixel(p.column, p.row - m_top));
          return thread.begins();
        });
  }
};

/// Every pixel is the mean of depth x depth samples at the middles of its cells, whatever they show:
/// no pixel is compared with another, and there is no jitter. For references that other settings are
/// held against. In linear light they are spread for the eye, and none is a sample of a picture that is.
class GridBand final : public OnePassBand {
 public:
  using OnePassBand::OnePassBand;

 private:
  static constexpr std::uint32_t kFirstOfReference = 64;

  bool trace(FilmThread& thread) override {
    const int depth = m_setup.antialiasing.depth;
    const LinearLight* const light = m_setup.antialiasing.blends_light ? &m_setup.light : nullptr;
    const auto cells = static_cast<std::size_t>(depth) * static_cast<std::size_t>(depth);
    Radiance sum;
    bool shows = false;
    return thread.sampler.samples(
        cells * thread.pixels.size(), Sampler::Layout::kNeighbours,
        [&](std::size_t i) {
          const auto cell = static_cast<std::uint32_t>(i % cells);
          const Pixel& p = thread.pixels[i / cells];
          if (light) return spread_sample(*m_setup.camera, p, kFirstOfReference + cell);
          return SamplePlace{cell_of(p, depth, cell), cell};
        },
        [&](std::size_t i, const Sample& sample) {
          if (i % cells == 0) {
            sum = {};
            shows = false;
          }
          sum += light ? light->of(sample.seen) : sample.seen;
          shows = shows || sample.has_ray;
          if (i % cells + 1 < cells) return true;
          ++(shows ? thread.counters.antialiased_pixels : thread.counters.dark_pixels);
          const Pixel& p = thread.pixels[i / cells];
          sum = shows ? sum * (1.0f / static_cast<float>(cells)) : Radiance{};
          store(light ? light->back(sum) : sum, m_setup.alpha,
                m_image.pixel(p.column, p.row - m_top));
          return thread.begins();
        });
  }
};

}  // namespace

PixelPlace cell_of(const Pixel& pixel, int depth, std::uint32_t cell) {
  const double step = 1.0 / depth;
  const int i = static_cast<int>(cell);
  PixelPlace place = place_of(pixel);
  place.across = (i % depth + 0.5) * step - 0.5;
  place.down = (i / depth + 0.5) * step - 0.5;
  return place;
}

void leave_out(const PixelSet* known, std::vector<Pixel>& pixels) {
  if (known) std::erase_if(pixels, [known](const Pixel& p) { return known->has(p); });
}

void recall_colours(const FilmSetup& setup, std::size_t stage, std::uint32_t top,
                    std::uint32_t bottom, std::uint32_t image_top, Image& image) {
  if (!setup.known(stage)) return;
  setup.ledger->recall(
      stage, top, bottom, [image_top, &image](const Pixel& p, const float* values) {
        std::copy_n(values, PictureLedger::kValues, image.pixel(p.column, p.row - image_top));
      });
}

void keep_colours(const FilmSetup& setup, std::size_t stage, std::uint32_t image_top, Image& image,
                  FilmThread& thread) {
  std::erase_if(thread.pixels, [&setup](const Pixel& p) { return !setup.region.has(p); });
  thread.values.clear();
  for (const Pixel& p : thread.pixels) {
    const float* colour = image.pixel(p.column, p.row - image_top);
    thread.values.insert(thread.values.end(), colour, colour + PictureLedger::kValues);
  }
  setup.ledger->add(stage, thread.pixels, thread.values);
}

std::unique_ptr<Film> Film::make(FilmSetup setup, const BandOrders& orders) {
  switch (setup.antialiasing.method) {
    case AntialiasingMethod::kCentres: return make_film_of_centres(std::move(setup), orders);
    case AntialiasingMethod::kCorners: return make_film_of_corners(std::move(setup), orders);
    case AntialiasingMethod::kSpread: return make_film_of_spread(std::move(setup), orders);
    case AntialiasingMethod::kGrid:
      return std::make_unique<FilmOf<FilmPlan, GridBand>>(std::move(setup), orders);
    case AntialiasingMethod::kPlain: break;
  }
  return std::make_unique<FilmOf<FilmPlan, PlainBand>>(std::move(setup), orders);
}

std::uint32_t Film::rows_together(const Antialiasing& antialiasing) {
  return antialiasing.method == AntialiasingMethod::kCentres ? PixelLattice::kTile : 1;
}

FilmColumns Film::traced_columns(const FilmSetup& setup) {
  switch (setup.antialiasing.method) {
    case AntialiasingMethod::kCentres: return traced_columns_of_centres(setup);
    case AntialiasingMethod::kCorners: return traced_columns_of_corners(setup);
    case AntialiasingMethod::kSpread: return traced_columns_of_spread(setup);
    default: return {setup.region.left, setup.region.right};
  }
}

PixelRegion Film::traced_region(const FilmSetup& setup) {
  const FilmColumns columns = traced_columns(setup);
  const std::uint32_t tile = rows_together(setup.antialiasing);
  const std::uint32_t bottom = (setup.region.bottom + tile - 1) / tile * tile;
  return {columns.left, setup.region.top / tile * tile, columns.right,
          std::min(bottom, setup.height)};
}

double Film::bytes_a_row(const Antialiasing& antialiasing, std::uint32_t width) {
  constexpr double kImage = 4 * sizeof(float), kSample = sizeof(Radiance) + sizeof(Compared);
  return (antialiasing.compares() ? kImage + kSample : kImage) * width;
}

}  // namespace lentray::core
