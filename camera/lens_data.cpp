#include "camera/lens_data.h"

#include <cmath>
#include <numbers>

#include "camera/lens_sheet.h"
#include "camera/text.h"

namespace lentray::camera {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kMostIor = 100.0;        // of data
constexpr double kMostMaterialIor = 3.0;  // beyond any clear plastic or glass

/// The sine of half the angle inside the sheet.
double half_sine(double pitch, double thickness) {
  return 0.5 * pitch / std::hypot(0.5 * pitch, thickness);
}

void check_length(const std::optional<double>& value, const std::string& name,
                  const std::vector<std::string>& about) {
  check_range(value, "the " + name + " must be ", " mm", 1e-6, 1e6, "1e-6 to 1e6 mm", about);
}

void check(const LensData& data) {
  check_length(data.pitch, "lens pitch", {"Lens_Pitch"});
  check_length(data.focal_length, "lens focal length", {"Lens_Focal_Length"});
  check_length(data.thickness, "lens thickness", {"Lens_Thickness"});
  check_length(data.radius, "lens radius", {"Lens_Radius"});
  check_range(data.lpi, "the number of lenses an inch must be ", "", 1e-4, 1e7, "1e-4 to 1e7",
              {"Lens_LPI"});
  if (data.ior) {
    if (!(*data.ior >= 1.0))
      throw CameraError("the refractive index of the lens must be at least 1", {"Lens_IOR"});
    if (!(*data.ior <= kMostIor)) {
      throw CameraError("the refractive index of the lens must be 100 at most", {"Lens_IOR"});
    }
  }
  if (data.angle && !(*data.angle > 0.0 && *data.angle < 180.0)) {
    throw CameraError(
        "the viewing angle of the lens must be greater than 0 and less than 180 degrees",
        {"Lens_Angle"});
  }
}

/// "2.3 %"
std::string part_text(double a, double b) { return brief(100.0 * std::fabs(a / b - 1.0)) + " %"; }

bool agree(double a, double b) { return std::fabs(a - b) <= kLensDataTolerance * std::fabs(b); }

/// Reads data from the surest to the least sure.
class LensSolver {
 public:
  explicit LensSolver(const LensData& data) : m_data(data) {}

  SolvedLens solve() {
    check(m_data);
    find_pitch();
    find_ior();
    find_thickness();
    check_length(m_thickness, "lens thickness", depth_options());
    if (!m_pitch) find_pitch_from_angle();
    check_length(m_pitch, "lens pitch", {"Lens_Pitch", "Lens_LPI", "Lens_Thickness", "Lens_Angle"});
    m_out.pitch = *m_pitch;
    m_out.ior = *m_ior;
    m_out.thickness = *m_thickness;
    check_surface();
    check_angle();
    return m_out;
  }

 private:
  void note(std::string line) { m_out.notes.push_back(std::move(line)); }
  static std::vector<std::string> depth_options() {
    return {"Lens_Thickness", "Lens_Focal_Length", "Lens_Radius", "Lens_Angle",
            "Lens_IOR",       "Lens_Pitch",        "Lens_LPI"};
  }
  bool has_depth() const { return m_data.thickness || m_data.focal_length || m_data.radius; }

  void find_pitch() {
    m_pitch = m_data.pitch;
    if (m_data.lpi) {
      const double pitch = 25.4 / *m_data.lpi;
      // Printed digits may differ; more would be whole lenses across a sheet.
      if (m_pitch && std::fabs(*m_pitch - pitch) > 1e-4 * pitch) {
        throw CameraError("lens pitch " + format(*m_pitch) + " mm and " + format(*m_data.lpi) +
                              " lenses an inch (" + format(pitch) +
                              " mm) contradict each other: give one of them",
                          {"Lens_Pitch", "Lens_LPI"});
      }
      if (!m_pitch) m_pitch = pitch;
    }
    // With a thickness and an angle it follows.
    if (!m_pitch && !(m_data.angle && has_depth())) m_pitch = LensParameters().pitch;
  }

  void find_ior() {
    m_ior = m_data.ior;
    const auto& depth = m_data.thickness ? m_data.thickness : m_data.focal_length;
    if (!m_ior && m_pitch && m_data.angle && depth && !m_data.radius) {
      m_ior = std::sin(0.5 * *m_data.angle * kDegree) / half_sine(*m_pitch, *depth);
      if (!(*m_ior >= 1.0 && *m_ior <= kMostMaterialIor)) {
        throw CameraError(
            "a viewing angle of " + format(*m_data.angle) + " degrees and " + format(*depth) +
                " mm from lens to print contradict each other: they would "
                "need a refractive index of " +
                format(*m_ior),
            {"Lens_Angle", "Lens_Thickness", "Lens_Focal_Length", "Lens_Pitch", "Lens_LPI"});
      }
      m_angle_is_used = true;
      note("Refractive index " + brief(*m_ior) + ", from the viewing angle");
    }
    if (!m_ior) m_ior = LensParameters().ior;
  }

  /// Where the lens focuses, if that is known.
  std::optional<double> focus() {
    if (!m_data.radius) return m_data.focal_length;
    if (*m_ior == 1.0) {
      throw CameraError("a lens with a radius needs a refractive index greater than 1",
                        {"Lens_Radius", "Lens_IOR"});
    }
    const double focus = *m_ior * *m_data.radius / (*m_ior - 1.0);
    if (m_data.focal_length) {
      if (!agree(*m_data.focal_length, focus)) {
        throw CameraError("a lens focal length of " + format(*m_data.focal_length) +
                              " mm and the " + format(focus) + " mm that follow from the radius " +
                              format(*m_data.radius) + " mm and the index " + format(*m_ior) +
                              " contradict each other: leave out one of them",
                          {"Lens_Focal_Length", "Lens_Radius", "Lens_IOR"});
      }
      note("Focal length " + brief(*m_data.focal_length) +
           " mm as given; radius and index make it " + brief(focus) + " mm, " +
           part_text(*m_data.focal_length, focus) + " off");
      return m_data.focal_length;
    }
    if (!m_data.thickness) {
      note("Thickness " + brief(focus) + " mm, where a lens of that radius focuses");
    }
    return focus;
  }

  void find_thickness() {
    const auto where = focus();
    m_thickness = m_data.thickness ? m_data.thickness : where;
    if (m_data.thickness && where && *m_ior > 1.0) {
      m_out.radius = m_data.radius.value_or(*where * (*m_ior - 1.0) / *m_ior);
    }
    if (m_thickness) return;
    if (m_data.angle) {
      const double inside = std::asin(std::sin(0.5 * *m_data.angle * kDegree) / *m_ior);
      m_thickness = 0.5 * *m_pitch / std::tan(inside);
      m_angle_is_used = true;
      note("Thickness " + brief(*m_thickness) + " mm, from the viewing angle");
      return;
    }
    const LensParameters usual;
    m_thickness = usual.focal_length;
    if (!m_data.pitch && !m_data.lpi) return;
    m_thickness = usual.focal_length / usual.pitch * *m_pitch;
    note("Thickness " + brief(*m_thickness) +
         " mm is a guess, for lenses of the usual shape: say Lens_Thickness, Lens_Angle or "
         "Lens_Sheet");
  }

  void find_pitch_from_angle() {
    const double inside = std::asin(std::sin(0.5 * *m_data.angle * kDegree) / *m_ior);
    m_pitch = 2.0 * *m_thickness * std::tan(inside);
    m_angle_is_used = true;
    note("Lens pitch " + brief(*m_pitch) + " mm, from thickness and viewing angle");
  }

  void check_surface() const {
    if (!m_data.radius) return;
    const double radius = *m_data.radius, half = 0.5 * m_out.pitch;
    if (radius < half) {
      throw CameraError("a lens radius of " + format(radius) + " mm and a pitch of " +
                            format(m_out.pitch) + " mm contradict each other: such lenses are " +
                            format(2.0 * radius) + " mm wide at most; give a radius of at least " +
                            brief(half) + " mm, or more lenses an inch",
                        {"Lens_Radius", "Lens_Pitch", "Lens_LPI"});
    }
    const double bulge = radius - std::sqrt((radius - half) * (radius + half));
    if (bulge >= m_out.thickness) {
      throw CameraError("a lens radius of " + format(radius) + " mm and a thickness of " +
                            format(m_out.thickness) +
                            " mm contradict each other: the lenses alone are " + format(bulge) +
                            " mm high",
                        {"Lens_Radius", "Lens_Thickness", "Lens_Pitch", "Lens_LPI"});
    }
  }

  void check_angle() {
    if (!m_data.angle || m_angle_is_used) return;
    const double simple = viewing_angle(m_out.pitch, m_out.thickness, m_out.ior);
    double nearest = simple;
    if (m_data.radius) {
      const double round = viewing_angle(m_out.pitch, m_out.thickness, m_out.ior, *m_data.radius);
      if (std::fabs(round - *m_data.angle) < std::fabs(simple - *m_data.angle)) nearest = round;
    }
    if (!agree(*m_data.angle, nearest)) {
      throw CameraError("a viewing angle of " + format(*m_data.angle) + " degrees and the " +
                            format(nearest) + " degrees that follow from pitch " +
                            format(m_out.pitch) + " mm, thickness " + format(m_out.thickness) +
                            " mm and index " + format(m_out.ior) +
                            " contradict each other: leave out one of them",
                        {"Lens_Angle", "Lens_Pitch", "Lens_LPI", "Lens_Thickness",
                         "Lens_Focal_Length", "Lens_Radius", "Lens_IOR"});
    }
    note("Viewing angle " + brief(*m_data.angle) + " degrees as given; the other data make it " +
         brief(nearest) + ", " + part_text(*m_data.angle, nearest) + " off");
  }

  const LensData& m_data;
  std::optional<double> m_pitch, m_ior, m_thickness;
  bool m_angle_is_used = false;
  SolvedLens m_out;
};

}  // namespace

void LensData::override_by(const LensData& other) {
  if (other.pitch || other.lpi) {
    pitch = other.pitch;
    lpi = other.lpi;
    angle.reset();
  }
  if (other.focal_length || other.angle) {
    thickness.reset();
    radius.reset();
  }
  if (other.thickness || other.radius || other.angle) focal_length.reset();
  if (other.thickness || other.radius || other.focal_length || other.ior) angle.reset();
  if (other.focal_length) focal_length = other.focal_length;
  if (other.thickness) thickness = other.thickness;
  if (other.radius) radius = other.radius;
  if (other.ior) ior = other.ior;
  if (other.angle) angle = other.angle;
}

void check_range(const std::optional<double>& value, const std::string& must, const char* unit,
                 double least, double most, const char* range,
                 const std::vector<std::string>& about) {
  if (!value) return;
  if (!(*value > 0.0)) throw CameraError(must + "greater than 0" + unit, about);
  if (!(*value >= least && *value <= most)) throw CameraError(must + range, about);
}

SolvedLens solve(const LensData& data) { return LensSolver(data).solve(); }

double viewing_angle(double pitch, double thickness, double ior) {
  const double sine = ior * half_sine(pitch, thickness);
  return sine < 1.0 ? 2.0 * std::asin(sine) / kDegree : 180.0;
}

double viewing_angle(double pitch, double thickness, double ior, double radius) {
  const double half = 0.5 * pitch, normal = std::asin(std::fmin(1.0, half / radius));
  const double edge = thickness - radius + std::sqrt((radius - half) * (radius + half));
  const double sine = ior * std::sin(normal - std::atan(pitch / edge));
  return std::fabs(sine) < 1.0 ? 2.0 * (normal - std::asin(sine)) / kDegree : 180.0;
}

}  // namespace lentray::camera
