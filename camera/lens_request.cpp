#include "camera/lens_request.h"

#include <cmath>

#include "camera/text.h"

namespace lentray::camera {
namespace {

/// Two ways to say one thing agree when they differ by no more than printed digits do.
bool agree(double a, double b) { return std::fabs(a - b) <= 1e-4 * std::fabs(b); }

double pitch_of(const LensRequest& request, double fallback) {
  if (request.lpi && !(*request.lpi > 0.0)) {
    throw CameraError("the number of lenses an inch must be greater than 0");
  }
  if (request.pitch && request.lpi && !agree(*request.pitch, 25.4 / *request.lpi)) {
    throw CameraError("lens pitch " + format(*request.pitch) + " mm and " + format(*request.lpi) +
                      " lenses an inch (" + format(25.4 / *request.lpi) +
                      " mm) contradict each other: give one of them");
  }
  if (request.pitch) return *request.pitch;
  return request.lpi ? 25.4 / *request.lpi : fallback;
}

/// N from the print's resolution. With the eye given in scene units V itself depends on N
/// (the sheet is W/N lenses wide): N (1 - a w / (n v W)) = a P with a = DPI/25.4 and f in w.
double pixels_of_dpi(const LensParameters& lens, double dpi, std::uint32_t width,
                     const EyeInScene* eye) {
  if (!eye) return pixels_for_dpi(lens, dpi);
  const double per_mm = dpi / 25.4;
  const double loss =
      per_mm * lens.focal_length * eye->sheet_width / (lens.ior * eye->distance * width);
  if (loss >= 1.0) {
    throw CameraError("no sheet at " + format(dpi) +
                      " pixels an inch lets the eye of this camera "
                      "see one view: ask for lens pixels instead");
  }
  return per_mm * lens.pitch / (1.0 - loss);
}

}  // namespace

void LensRequest::override_by(const LensRequest& other) {
  if (other.pitch || other.lpi) {
    pitch = other.pitch;
    lpi = other.lpi;
  }
  if (other.pixels || other.print_dpi) {
    pixels = other.pixels;
    print_dpi = other.print_dpi;
  }
  if (other.focal_length) focal_length = other.focal_length;
  if (other.ior) ior = other.ior;
  if (other.front) front = other.front;
  if (other.view_distance) view_distance = other.view_distance;
  if (other.model) model = other.model;
  if (other.rays) rays = other.rays;
}

LensParameters resolve(const LensRequest& request, std::uint32_t width, const EyeInScene* eye) {
  LensParameters lens;
  lens.pitch = pitch_of(request, lens.pitch);
  lens.focal_length = request.focal_length.value_or(lens.focal_length);
  lens.ior = request.ior.value_or(lens.ior);
  if (request.view_distance) {
    if (*request.view_distance < 0.0 || std::isnan(*request.view_distance)) {
      throw CameraError("the viewing distance must not be negative");
    }
    if (*request.view_distance > 0.0) lens.view_distance = *request.view_distance;
    eye = nullptr;
  }
  lens.pixels = request.pixels.value_or(lens.pixels);
  const bool finite = eye || lens.is_finite();
  lens.model = request.model.value_or(finite ? LensModel::kParaxial : LensModel::kPinhole);
  lens.rays = request.rays.value_or(lens.rays);
  if (const std::string why = complaint(lens); !why.empty()) throw CameraError(why);
  if (request.print_dpi) {
    if (!(*request.print_dpi > 0.0) || !std::isfinite(*request.print_dpi)) {
      throw CameraError("the print's resolution must be greater than 0 pixels an inch");
    }
    const double pixels = pixels_of_dpi(lens, *request.print_dpi, width, eye);
    if (request.pixels && !agree(*request.pixels, pixels)) {
      throw CameraError(format(*request.pixels) + " pixels a lens and " +
                        format(*request.print_dpi) + " pixels an inch (" + format(pixels) +
                        " pixels a lens) contradict each other: give one of them");
    }
    if (!request.pixels) lens.pixels = pixels;
    if (lens.pixels < 1.0) throw CameraError("a lens must be at least one pixel wide");
  }
  if (eye) {
    const double per_mm = eye->sheet_width / (width / lens.pixels * lens.pitch);
    lens.view_distance = eye->distance / per_mm;
  }
  if (const std::string why = complaint(lens); !why.empty())
    throw CameraError(why);  // of what was computed
  return lens;
}

}  // namespace lentray::camera
