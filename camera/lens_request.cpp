#include "camera/lens_request.h"

#include <cmath>

#include "camera/sheet_sanity.h"
#include "camera/text.h"

namespace lentray::camera {
namespace {

/// Whether two ways to say one thing agree: they differ by no more than printed digits do.
bool same_but_for_digits(double a, double b) { return std::fabs(a - b) <= 1e-4 * std::fabs(b); }

/// N from the print's resolution. With the eye given in scene units V itself depends on N
/// (the sheet is W/N lenses wide): N (1 - a w / (n v W)) = a P with a = DPI/25.4 and f in w; P is along
/// a row.
double pixels_of_dpi(const LensParameters& lens, double dpi, std::uint32_t width,
                     const EyeInScene* eye) {
  if (!eye) return pixels_for_dpi(lens, dpi);
  const double per_mm = dpi / 25.4;
  const double loss =
      per_mm * lens.focal_length * eye->sheet_width / (lens.ior * eye->distance * width);
  if (loss >= 1.0) {
    throw CameraError("no sheet at " + format(dpi) +
                          " pixels an inch lets the eye of this camera "
                          "see one view: ask for lens pixels instead",
                      {"Print_DPI", kCameraToo});
  }
  return per_mm * lens.pitch / lens.slant_cosine() / (1.0 - loss);
}

}  // namespace

const char* name_of(DepthMode mode) {
  switch (mode) {
    case DepthMode::kPrint: return "print";
    case DepthMode::kScene: return "scene";
    case DepthMode::kViewer: break;
  }
  return "viewer";
}

void LensRequest::override_by(const LensRequest& other) {
  LensData::override_by(other);
  if (other.print_lpi) {
    print_lpi = other.print_lpi;
    pitch.reset();
    lpi.reset();
  } else if (other.pitch || other.lpi) {
    print_lpi.reset();
  }
  if (other.pixels || other.print_dpi) {
    pixels = other.pixels;
    print_dpi = other.print_dpi;
  }
  if (other.slant) slant = other.slant;
  if (other.front) front = other.front;
  if (other.view_distance) view_distance = other.view_distance;
  if (other.model || other.automatic_model) {
    model = other.model;
    automatic_model = other.automatic_model;
  }
  if (other.tolerance) tolerance = other.tolerance;
  if (other.rays) rays = other.rays;
  if (other.size) size = other.size;
  if (other.across) across = other.across;
  if (other.depth_budget) depth_budget = other.depth_budget;
  if (other.depth) depth = other.depth;
  if (!other.sheet_name.empty()) {
    sheet_name = other.sheet_name;
    sheet_is_nominal = other.sheet_is_nominal;
  }
}

namespace {

void check_dpi(const std::optional<double>& dpi) {
  check_range(dpi, "the print's resolution must be ", " pixels an inch", 0.0, 1e9,
              "1e9 pixels an inch at most", {"Print_DPI"});
}

/// Those that a resolution gives a lens.
void check_pixels(const LensParameters& lens, double dpi) {
  if (lens.pixels >= 1.0) return;
  throw CameraError("at " + format(dpi) + " pixels an inch a lens has " + brief(lens.pixels) +
                        " pixels: " + resolution_for(lens, 1.0) + " give it one, and six are few",
                    {"Print_DPI", "Lens_Pitch", "Lens_LPI", "Print_LPI"});
}

void check(const LensParameters& lens) {
  const std::string why = complaint(lens);
  if (why.empty()) return;
  throw CameraError(
      why, {"Lens_Pitch", "Lens_LPI", "Print_LPI", "Lens_Thickness", "Lens_Focal_Length",
            "Lens_Radius", "Lens_IOR", "Lens_Angle", "Lens_Pixels", "Print_DPI", "View_Distance",
            "Lens_Model", "Lens_Rays", "Lens_Slant"});
}

/// All but N and a V that is the scene's.
LensParameters begin(const LensRequest& asked) {
  const LensRequest request = with_lens_pitch(asked);
  LensParameters lens;
  const SolvedLens solved = solve(request);
  lens.pitch = solved.pitch;
  lens.focal_length = solved.thickness;
  lens.ior = solved.ior;
  lens.surface_radius = solved.radius;
  if (request.view_distance) {
    if (*request.view_distance < 0.0 || std::isnan(*request.view_distance)) {
      throw CameraError(
          "the viewing distance must not be negative: give mm, or 0 for an eye infinitely far away",
          {"View_Distance"});
    }
    if (*request.view_distance > 0.0) lens.view_distance = *request.view_distance;
  } else if (request.depth == DepthMode::kPrint) {
    lens.view_distance = kUsualViewDistance;
  }
  lens.pixels = request.pixels.value_or(lens.pixels);
  lens.slant = request.slant.value_or(0.0);
  check_dpi(request.print_dpi);
  return lens;
}

}  // namespace

LensRequest with_lens_pitch(const LensRequest& request) {
  if (!request.print_lpi) return request;
  if (request.pitch || request.lpi) {
    throw CameraError(
        "Print_LPI gives the lenses' pitch, and so does Lens_Pitch or Lens_LPI: give one of them",
        {"Print_LPI", "Lens_Pitch", "Lens_LPI"});
  }
  if (!(*request.print_lpi >= 1e-4 && *request.print_lpi <= 1e7)) {
    throw CameraError("Print_LPI must be 0.0001 to 10000000 strips an inch", {"Print_LPI"});
  }
  if (!request.view_distance) {
    throw CameraError(
        "Print_LPI needs a View_Distance: which strips fit depends on it; give the one that the "
        "pitch test was looked at from",
        {"Print_LPI"});
  }
  const double strip = 25.4 / *request.print_lpi, distance = *request.view_distance;
  LensRequest out = request;
  out.print_lpi.reset();
  out.pitch = strip;
  if (!(distance > 0.0) || std::isinf(distance)) return out;
  // Without a thickness that is said, it follows from the pitch.
  constexpr int kMostSteps = 100;
  for (int i = 0; i < kMostSteps; ++i) {
    const SolvedLens lens = solve(out);
    const double next = strip / (1.0 + lens.thickness / (lens.ior * distance));
    const bool is_found = std::fabs(next - *out.pitch) <= 1e-15 * next;
    out.pitch = next;
    if (is_found) break;
  }
  return out;
}

LensParameters resolve(const LensRequest& request, std::uint32_t width, const EyeInScene* eye) {
  LensParameters lens = begin(request);
  if (request.view_distance) eye = nullptr;
  const bool finite = eye || lens.is_finite();
  const bool paraxial = finite || request.automatic_model;
  lens.model = request.model.value_or(paraxial ? LensModel::kParaxial : LensModel::kPinhole);
  lens.rays = request.rays.value_or(lens.rays);
  check(lens);
  if (request.print_dpi) {
    const double pixels = pixels_of_dpi(lens, *request.print_dpi, width, eye);
    if (request.pixels && !same_but_for_digits(*request.pixels, pixels)) {
      throw CameraError(format(*request.pixels) + " pixels a lens and " +
                            format(*request.print_dpi) + " pixels an inch (" + format(pixels) +
                            " pixels a lens) contradict each other: give one of them",
                        {"Lens_Pixels", "Print_DPI"});
    }
    if (!request.pixels) lens.pixels = pixels;
    check_pixels(lens, *request.print_dpi);
  }
  if (eye) {
    const double per_mm =
        eye->sheet_width / (width / lens.pixels * lens.pitch / lens.slant_cosine());
    lens.view_distance = eye->distance / per_mm;
  }
  check(lens);  // what was computed
  return lens;
}

ExactPixels exact_pixels(const LensRequest& request, const SheetSize& size) {
  constexpr double kLeast = 1e-6, kMost = 1e6;
  for (const double mm : {size.width, size.height}) {
    if (mm >= kLeast && mm <= kMost) continue;
    throw CameraError("the sheet must be 1e-6 to 1e6 mm wide and high",
                      {"Sheet_Width", "Sheet_Height", "Sheet_Size"});
  }
  check_dpi(size.dpi_down);
  LensParameters lens = begin(request);
  if (request.print_dpi && !request.pixels) {
    lens.pixels = pixels_for_dpi(lens, *request.print_dpi);
    check_pixels(lens, *request.print_dpi);
  }
  check(lens);
  const double larger = lens.print_pitch() / lens.pitch;
  const double dpi_down = size.dpi_down.value_or(lens.print_dpi());
  return {size.width / lens.pitch * lens.pixels * lens.slant_cosine(),
          size.height * larger * dpi_down / 25.4};
}

}  // namespace lentray::camera
