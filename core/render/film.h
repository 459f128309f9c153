// The film: turns what a picture is asked for into the samples of its pixels, and samples into
// colours. It works on bands of rows. A band goes through stages, each of which is cut into jobs;
// the jobs of a stage may run at once, and a stage begins when the one before it has ended.
// Pixels of the image; colours linear in the scene's working space.
//
//   no antialiasing   one sample a pixel, in the pixel order
//   method 1          core/render/film_centres.cpp
//   method 2          core/render/film_corners.cpp
//   spread            core/render/film_spread.cpp
//   grid              GridBand in core/render/film.cpp
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/counters.h"
#include "core/image/image.h"
#include "core/render/antialiasing.h"
#include "core/render/frame_progress.h"
#include "core/render/picture_ledger.h"
#include "core/render/pixel_lattice.h"
#include "core/render/pixel_order.h"
#include "core/render/sampler.h"

namespace lentray::core {

/// What one thread works with. Buffers grow and are used again.
struct FilmThread {
  Sampler& sampler;
  Counters& counters;
  const std::atomic<bool>& cancel;
  FrameMeter* meter = nullptr;  ///< null: nobody watches
  std::vector<Pixel> pixels{};  ///< what the last job worked on
  std::vector<float> values{};  ///< what the ledger keeps of them
  /// A pixel of a chain as its neighbours see it.
  struct Chained {
    Compared now;
    bool is_refined;
  };
  /// A pixel to be refined, and its place in `chain`.
  struct Wanted {
    Pixel pixel;
    std::size_t at;
  };
  std::vector<Chained> chain{};  ///< of film_centres
  std::vector<Wanted> wanted{};  ///< of film_centres
  // Of film_corners: samples within the pixels that are cut together.
  struct Finer {
    Radiance seen;
    Compared compared;
    std::uint32_t stamp = 0;
  };
  struct FinerPlace {
    std::uint32_t pixel, x, y;
  };
  std::vector<Finer> finer{};
  std::vector<FinerPlace> places{};   ///< that are wanted
  std::vector<std::uint32_t> open{};  ///< pixels that may want more
  std::uint32_t stamp = 0;            ///< of a sample that is wanted
  std::uint32_t known() const { return stamp + 1; }

  /// Work on a pixel begins; false: it is not to, as the frame was cancelled.
  bool begins() const {
    if (meter) meter->pixel();
    return !is_cancelled();
  }
  bool is_cancelled() const { return cancel.load(std::memory_order_relaxed); }
};

class FilmBand {
 public:
  virtual ~FilmBand() = default;
  virtual std::size_t stages() const = 0;
  virtual std::size_t jobs(std::size_t stage) const = 0;
  /// False if it was cancelled meanwhile. Different jobs of a stage: any threads at once.
  virtual bool work(std::size_t stage, std::size_t job, FilmThread& thread) = 0;
  /// Of the picture's ledger: the last of several finds colours, those before it samples.
  std::size_t ledger_stage(std::size_t stage) const {
    return stages() > 1 && stage + 1 == stages() ? 1 : 0;
  }
};

/// What all bands of a picture have in common.
struct FilmSetup {
  std::uint32_t width = 0, height = 0;
  PixelRegion region;  ///< the pixels that are asked for; the others stay black
  Antialiasing antialiasing;
  bool alpha = false;
  PixelLattice lattice;
  const RaySource* camera = nullptr;
  ComparedSpace space{2.5, 1.0};
  LinearLight light{1.0, 1.0f};
  PictureLedger* ledger = nullptr;  ///< null: nothing is kept

  /// Null: nothing is known.
  const PixelSet* known(std::size_t stage) const { return ledger ? ledger->known(stage) : nullptr; }
  bool keeps() const { return ledger && ledger->listens(); }
};

/// The columns that a film traces pixels of in a pixel order, for those that are asked for.
struct FilmColumns {
  std::uint32_t left = 0, right = 0;
  bool has(std::uint32_t column) const { return column >= left && column < right; }
};

/// A pixel's centre.
inline PixelPlace place_of(const Pixel& pixel) {
  return {.column = static_cast<std::int32_t>(pixel.column),
          .row = static_cast<std::int32_t>(pixel.row)};
}
/// The middle of a cell of a pixel's area, of depth x depth, row by row.
PixelPlace cell_of(const Pixel& pixel, int depth, std::uint32_t cell);

/// Pixels of an order that are not known yet.
void leave_out(const PixelSet* known, std::vector<Pixel>& pixels);
/// Known colours, into an image whose first row is `image_top`.
void recall_colours(const FilmSetup& setup, std::size_t stage, std::uint32_t top,
                    std::uint32_t bottom, std::uint32_t image_top, Image& image);
/// The colours of the thread's pixels go to the ledger.
void keep_colours(const FilmSetup& setup, std::size_t stage, std::uint32_t image_top, Image& image,
                  FilmThread& thread);
/// The samples of the thread's pixels, one each of stage 0, go to the ledger. `sample_of(pixel)` is what
/// was seen.
template <typename SampleOf>
void keep_samples(const FilmSetup& setup, FilmThread& thread, SampleOf sample_of) {
  thread.values.clear();
  for (const Pixel& p : thread.pixels) {
    const Radiance& seen = sample_of(p);
    thread.values.insert(thread.values.end(), {seen.rgb.r, seen.rgb.g, seen.rgb.b, seen.transmit});
  }
  setup.ledger->add(0, thread.pixels, thread.values);
}
/// Known samples of the rows [top, bottom) and the columns: `tell(pixel, seen)`.
template <typename Tell>
void recall_samples(const FilmSetup& setup, FilmColumns columns, std::uint32_t top,
                    std::uint32_t bottom, Tell tell) {
  setup.ledger->recall(0, top, bottom, [&](const Pixel& p, const float* v) {
    if (p.column < columns.left || p.column >= columns.right) return;
    tell(p, Radiance{{v[0], v[1], v[2]}, v[3]});
  });
}

/// Immutable, any number of threads.
class Film {
 public:
  /// `orders` is for traced_columns(); it outlives the film.
  static std::unique_ptr<Film> make(FilmSetup setup, const BandOrders& orders);
  virtual ~Film() = default;
  /// The rows [top, bottom), into an image that begins with row `top` and is black. Null if no
  /// pixel of them is asked for.
  virtual std::unique_ptr<FilmBand> band(std::uint32_t top, std::uint32_t bottom,
                                         Image& image) const = 0;

  /// A band begins at a multiple of so many rows.
  static std::uint32_t rows_together(const Antialiasing& antialiasing);
  static FilmColumns traced_columns(const FilmSetup& setup);
  /// The pixels of the image that are traced for those that are asked for.
  static PixelRegion traced_region(const FilmSetup& setup);
  /// Bytes a band takes for each row, the image's own included.
  static double bytes_a_row(const Antialiasing& antialiasing, std::uint32_t width);
};

/// A pixel as the image keeps it: premultiplied.
inline void store(const Radiance& seen, bool alpha, float* out) {
  const float opacity = alpha ? std::clamp(1.0f - seen.transmit, 0.0f, 1.0f) : 1.0f;
  out[0] = seen.rgb.r;
  out[1] = seen.rgb.g;
  out[2] = seen.rgb.b;
  out[3] = opacity;
}

}  // namespace lentray::core
