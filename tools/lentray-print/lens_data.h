// How an integral image was made: the lens data that lentray leaves in its files, and what a user says where they lack.
// Units: mm; pixels of the picture; pixels an inch. Errors: PageError, worded for the user. Pure.
#pragma once

#include <optional>
#include <string>

#include "core/image/reader.h"

namespace lentray::print {

/// What is said beside the file.
struct GivenLensData {
  std::optional<double> lens_pitch;  ///< mm
  std::optional<double> pixels;      ///< N, a lens
  std::optional<double> dpi_x, dpi_y;
};

/// The lens itself, of which only lentray's own files say anything.
struct LensOfPicture {
  double pitch = 0.0, focal_length = 0.0, ior = 1.0;
  double view_distance = 0.0;  ///< 0: infinite
  std::string model{};
  bool has_scenes_eye = false;  ///< the scene is seen from its own camera (Depth=print)

  /// f/(nV): by how much strips are wider apart than lenses.
  double widening() const {
    return view_distance > 0.0 ? focal_length / (ior * view_distance) : 0.0;
  }
};

struct LensData {
  double pixels = 0.0;  ///< N, a lens; may be fractional
  double dpi_x = 0.0, dpi_y = 0.0;
  std::optional<LensOfPicture> lens;

  double print_pitch() const;  ///< of the strips in the print, mm
  double print_lpi() const;
};

/// The lenses' slant in degrees as the file gives it; 0: upright, or it does not say.
double slant_in(const core::StoredImage& image);

/// `name`: the file's, for messages. Refuses single views, pictures that were resized or cropped after they were
/// rendered, and options that contradict the file.
LensData lens_data_of(const core::StoredImage& image, const GivenLensData& given,
                      const std::string& name);

}  // namespace lentray::print
