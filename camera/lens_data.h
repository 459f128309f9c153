// Lens data as makers and shops give them, and the lens that follows from any sufficient set of them.
// Lengths in mm, the angle in degrees; what was not said stays empty.
//
// The print lies on the sheet's flat back, so the distance from a lens's vertex to the pixels is the
// sheet's thickness. The lens focuses at n r/(n - 1) behind its vertex, which may be another place.
// Errors: CameraError, worded for the user. Pure; any number of threads.
// Source: Snell's law; Wikipedia, "Lenticular optics", for the viewing angle with a radius.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lentray::camera {

/// A camera that cannot be had, and why.
class CameraError : public std::runtime_error {
 public:
  /// `about`: the options that it may come from, by their names; those of a lens are also words of the camera
  /// statement, in small letters. None: it comes from the statement alone.
  explicit CameraError(const std::string& why, std::vector<std::string> about = {})
      : std::runtime_error(why), m_about(std::move(about)) {}
  const std::vector<std::string>& about() const { return m_about; }

 private:
  std::vector<std::string> m_about;
};

/// An option in CameraError::about() whose error is of the statement besides.
inline constexpr const char* kCameraToo = "camera";

struct LensData {
  std::optional<double> pitch{};         ///< width of a lens, mm
  std::optional<double> lpi{};           ///< the same as lenses an inch
  std::optional<double> focal_length{};  ///< from the vertex, in the material, mm
  std::optional<double> thickness{};     ///< from the vertex to the print, mm
  std::optional<double> radius{};        ///< of the round surface, mm
  std::optional<double> ior{};           ///< refractive index
  std::optional<double> angle{};         ///< the full viewing angle in the air, degrees

  bool is_empty() const {
    return !pitch && !lpi && !focal_length && !thickness && !radius && !ior && !angle;
  }
  /// What `other` says replaces what was said here, and what that had made superfluous: a pitch
  /// replaces lenses an inch, a focal length replaces radius and thickness, a radius or a thickness
  /// replaces the focal length, an angle replaces all three, and each of them the angle.
  void override_by(const LensData& other);
};

/// A lens, complete.
struct SolvedLens {
  double pitch = 0.0, thickness = 0.0, ior = 1.0;
  double radius = 0.0;             ///< 0: that which focuses on the print
  std::vector<std::string> notes;  ///< where it is from, and what was said twice: lines of a report
};

/// Data that are given twice agree when they differ by this part at most.
inline constexpr double kLensDataTolerance = 0.02;

/// What is missing follows from the rest, or is the default lens's, whose shape is kept at other
/// pitches. Data that contradict each other are an error with both figures.
SolvedLens solve(const LensData& data);

/// Throws unless the value, if there is one, is greater than 0 and `least` to `most`: "<must>greater than 0<unit>", and
/// "<must><range>".
void check_range(const std::optional<double>& value, const std::string& must, const char* unit,
                 double least, double most, const char* range,
                 const std::vector<std::string>& about);

/// The angle in the air, degrees, between the outermost rays through a lens's vertex; 180 where they
/// are totally reflected.
double viewing_angle(double pitch, double thickness, double ior);
/// That of the rays from one edge of a lens's strip to the opposite edge of its surface. The radius
/// must be half the pitch at least.
double viewing_angle(double pitch, double thickness, double ior, double radius);

}  // namespace lentray::camera
