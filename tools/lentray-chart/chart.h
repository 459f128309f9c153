// What lentray-chart knows of a scene: settings that trade time for error, what each took and how far its picture
// is from a converged reference, and which of them a user should choose. Plain data.
//
// Times in seconds of processor time, errors in 1/255 of full scale, decibels for PSNR.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lentray::chart {

/// What a setting changes.
enum class Kind {
  lens_model,    ///< rays behind a lens
  antialiasing,  ///< method, depth, threshold
  area_light,    ///< samples of area lights
  focal_blur,    ///< samples of the aperture
  media,         ///< method, intervals, samples
  radiosity,     ///< count, error_bound, nearest_count, recursion_limit
  photons,       ///< count, gather
  subsurface,    ///< samples of subsurface light
  depth,         ///< max_trace_level, adc_bailout
  quality,       ///< +Q
  combined,      ///< several of those at once
  exact          ///< orders, caches, accelerators, light buffers, paths: the picture stays as it is
};
inline constexpr Kind kKinds[] = {Kind::lens_model, Kind::antialiasing, Kind::area_light,
                                  Kind::focal_blur, Kind::media,        Kind::radiosity,
                                  Kind::photons,    Kind::subsurface,   Kind::depth,
                                  Kind::quality,    Kind::combined,     Kind::exact};
const char* name_of(Kind kind);
std::optional<Kind> kind_named(std::string_view name);

/// Options for lentray on top of the user's own.
struct Setting {
  std::string id;  ///< stable, of letters, digits and -: names files and rows ("aa-method1-depth3")
  std::string label;  ///< for readers ("antialiasing, method 1, 3 x 3 samples")
  Kind kind = Kind::exact;
  std::vector<std::string> options;
  bool is_plain = false;  ///< the user's own options alone: what the others are held against
};

/// Of a picture against another of its size.
struct Error {
  double rms = 0.0;                 ///< over all channels, 1/255
  double psnr = 0.0;                ///< dB; infinite when equal
  double share = 0.0;               ///< of the pixels that differ by more than 1/255
  double largest = 0.0;             ///< of a pixel, 1/255
  std::optional<double> perceived;  ///< Butteraugli's 3-norm; nothing where it cannot be had
  /// Of a lens sheet: RMS in L* of what an eye sees (lentray-diff --seen); nothing as above.
  std::optional<double> seen{};
};

enum class State { waiting, done, failed };
const char* name_of(State state);

/// "0.12/255".
std::string error_text(double rms);

struct Point {
  Setting setting;
  State state = State::waiting;
  std::string reason{};          ///< of a failure: what lentray said
  std::vector<double> cpu_s{};   ///< one a repeat, of rendering with reading and writing
  std::string picture{};         ///< file, relative to the chart's folder
  std::string difference{};      ///< file: the difference from the reference, times eight
  std::optional<Error> error{};  ///< against the reference
  std::optional<Error>
      from_plain{};  ///< against the picture of the plain setting; exact ones: no difference
  std::optional<Error>
      from_stock{};  ///< against stock at the same settings; nothing where stock has none
  std::optional<double> stock_cpu_s{};  ///< median
  std::vector<double> stock_runs{};     ///< s of processor time, one a repeat
  std::optional<Error> stock_error{};   ///< of stock's picture against the reference
  std::string stock_picture{};          ///< file, relative to the chart's folder
  // What follows is derived from all points (tools/lentray-chart/front.h).
  bool told_apart = true;      ///< its error is at least ten times the reference's own change
  bool on_front = false;       ///< no other setting has less error in less time
  std::string dominated_by{};  ///< id of the fastest setting that is better in both
  std::string command{};       ///< to render so, for a shell

  /// It has a time and an error.
  bool is_known() const { return state == State::done && error && !cpu_s.empty(); }
  double seconds() const;  ///< median; 0 where nothing was timed
  double least() const, most() const;
};

/// The converged picture of the scene.
struct Reference {
  std::vector<std::string> options{};
  std::string picture{};  ///< 16 bits, relative to the chart's folder
  double change = 0.0;    ///< rms, 1/255: from the picture with half of its samples
  double cpu_s = 0.0;
  std::vector<std::pair<std::string, double>> steps{};  ///< every step tried: what, and its change
  bool is_converged = false;  ///< change below a tenth of the smallest error that is distinguished
};

struct Chart {
  std::string scene{};
  std::string command{};  ///< the user's own: lentray, the scene and their options, for a shell
  unsigned width = 0, height = 0;
  bool is_sheet = false;
  std::string machine{};  ///< processor and number of threads (one is used)
  Reference reference{};
  /// What lens models are held against: the truest model. Points of Kind::lens_model have their errors against it;
  /// they make a front of their own and are never chosen. Nothing where no lens model is charted.
  std::optional<Reference> lens_reference{};
  std::string
      noise{};  ///< why pictures of the scene have random noise; empty: nothing is known that makes any
  std::vector<Point> points{};
  std::string stock{};  ///< its version; empty: why there is none is in stock_reason
  std::string stock_reason{};
};

/// What --budget and --error find.
struct Choice {
  const Point* point = nullptr;  ///< null: none fits
  std::string command{};         ///< to render so, for a shell
  std::string reason{};          ///< why none fits, and what the nearest one is
};

}  // namespace lentray::chart
