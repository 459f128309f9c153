#include "parser/grammar/camera.h"

#include <cctype>
#include <cmath>
#include <numbers>

#include "camera/lens_sheet.h"
#include "core/base/tiny.h"
#include "parser/grammar/helpers.h"
#include "parser/grammar/object.h"

namespace lentray::parser {
namespace {

using core::Vec3;

using core::kTiny;

/// Length of `direction` that makes a picture of that width span `degrees`.
double direction_length(double right_length, double degrees) {
  return right_length / std::tan(degrees * std::numbers::pi / 360.0) / 2.0;
}

/// Reads one camera. From #version 3.5 on the order of the words does not matter: values are
/// collected and applied as right, direction, angle, up, sky, location, look_at, transforms.
/// Before, each word acts at once on what stands there.
class CameraReader {
 public:
  CameraReader(Parser& parser, Context& context, const CameraDesc& start)
      : m_parser(parser), m_context(context), m_camera(start),
        m_in_order(parser.language_version() >= 350) {}

  CameraDesc read() {
    m_camera.where = m_parser.location();
    m_parser.expect(Punct::kLeftCurly);
    if (auto named = m_parser.accept_value<Ref<CameraDesc>>()) {
      m_camera = **named;
      if (m_in_order) return read_copy();
    }
    if (m_in_order) m_camera.transform = core::Transform();
    m_camera.has_right = m_camera.has_up = m_camera.has_angle = m_camera.has_focal_point = false;
    m_camera.has_look_at = m_camera.has_look_at && !m_in_order;
    while (!m_parser.accept(Punct::kRightCurly)) {
      if (!accept_word()) fail_word();
    }
    if (m_in_order) apply_in_order();
    finish();
    return m_camera;
  }

 private:
  /// A copy of a named camera takes transforms only.
  CameraDesc read_copy() {
    if (const auto transform = m_parser.accept_transforms()) apply(*transform);
    if (!m_parser.accept(Punct::kRightCurly)) {
      m_parser.fail_expected("a transform or } after a camera identifier");
    }
    return m_camera;
  }

  void apply(const core::Transform& t) {
    m_camera.location = t.point(m_camera.location);
    m_camera.direction = t.vector(m_camera.direction);
    m_camera.right = t.vector(m_camera.right);
    m_camera.up = t.vector(m_camera.up);
    m_camera.look_at = t.point(m_camera.look_at);
    m_camera.transform = m_camera.transform.then(t);
  }

  bool accept_word() {
    if (const auto transform = m_parser.accept_transforms()) {
      if (m_in_order) {
        m_pending = m_pending.then(*transform);
      } else {
        apply(*transform);
      }
      return true;
    }
    return accept_kind() || accept_vector() || accept_view_angle() || accept_blur() ||
           accept_lens_word();
  }

  void set_kind(CameraKind kind) {
    m_camera.kind = kind;
    if (!m_in_order && kind == CameraKind::kOrthographic) resize_to_look_at();
  }

  bool accept_kind() {
    static constexpr std::pair<Keyword, CameraKind> kKinds[] = {
        {Keyword::kPerspective, CameraKind::kPerspective},
        {Keyword::kOrthographic, CameraKind::kOrthographic},
        {Keyword::kFisheye, CameraKind::kFisheye},
        {Keyword::kUltraWideAngle, CameraKind::kUltraWideAngle},
        {Keyword::kOmnimax, CameraKind::kOmnimax},
        {Keyword::kPanoramic, CameraKind::kPanoramic},
        {Keyword::kSpherical, CameraKind::kSpherical},
    };
    for (const auto& [keyword, kind] : kKinds) {
      if (m_parser.accept(keyword)) {
        set_kind(kind);
        return true;
      }
    }
    if (m_parser.accept(Keyword::kCylinder)) {
      m_camera.kind = CameraKind::kCylinder;
      m_camera.cylinder_type = m_parser.parse_int();
      if (m_camera.cylinder_type < 1 || m_camera.cylinder_type > 4) {
        m_parser.fail("Invalid cylinder camera type; valid are types 1 to 4.");
      }
      return true;
    }
    if (m_parser.accept(Keyword::kMeshCamera)) {
      m_camera.kind = CameraKind::kMesh;
      read_mesh_camera();
      return true;
    }
    return false;
  }

  void read_mesh_camera() {
    m_parser.expect(Punct::kLeftCurly);
    m_camera.meshes.clear();
    m_camera.rays_per_pixel = m_parser.parse_int();
    if (m_camera.rays_per_pixel < 1) m_parser.fail("A mesh_camera needs at least one ray a pixel.");
    m_parser.parse_comma();
    m_camera.distribution = m_parser.parse_int();
    if (m_camera.distribution < 0 || m_camera.distribution > 3) {
      m_parser.fail("The distribution of a mesh_camera must be 0 to 3.");
    }
    m_camera.max_ray_distance = next_float(m_parser, 0.0);
    Location where = m_parser.location();
    while (Ref<ObjectDesc> mesh = accept_object(m_parser, m_context)) {
      if (!mesh->is_any<std::shared_ptr<const MeshShape>>()) {
        m_parser.fail_at(where, "a mesh_camera takes meshes, not a " + std::string(mesh->keyword));
      }
      m_camera.meshes.push_back(mesh);
      where = m_parser.location();
    }
    m_camera.smooth = m_parser.accept(Keyword::kSmooth);
    m_parser.expect(Punct::kRightCurly);
    if (m_camera.meshes.empty()) m_parser.fail("A mesh_camera needs a mesh or mesh2.");
    check_mesh_rays();
  }

  void check_mesh_rays() {
    const int rays = m_camera.rays_per_pixel;
    if (m_camera.distribution == 0 && rays > static_cast<int>(m_camera.meshes.size())) {
      m_parser.fail("A mesh_camera of distribution 0 needs a mesh for each ray of a pixel.");
    }
    if (m_camera.distribution >= 2 && rays != 1) {
      m_parser.fail("A mesh_camera of distribution 2 or 3 has one ray a pixel.");
    }
  }

  bool accept_vector() {
    if (m_parser.accept(Keyword::kLocation, m_camera.location) ||
        m_parser.accept(Keyword::kDirection, m_camera.direction) ||
        m_parser.accept(Keyword::kSky, m_camera.sky))
      return true;
    if (m_parser.accept(Keyword::kRight)) {
      m_camera.right = m_parser.parse_vector();
      m_camera.has_right = true;
    } else if (m_parser.accept(Keyword::kUp)) {
      m_camera.up = m_parser.parse_vector();
      m_camera.has_up = true;
    } else if (m_parser.accept(Keyword::kLookAt)) {
      m_camera.look_at = m_parser.parse_vector();
      m_camera.has_look_at = true;
      if (!m_in_order) turn_to_look_at();
    } else {
      return false;
    }
    return true;
  }

  bool accept_view_angle() {
    if (!m_parser.accept(Keyword::kAngle)) return false;
    if (m_camera.kind == CameraKind::kSpherical && m_in_order) {
      m_camera.horizontal_angle = m_parser.parse_float();
      m_camera.vertical_angle = next_float(m_parser, m_camera.horizontal_angle * 0.5);
      if (m_camera.horizontal_angle < 0.0 || m_camera.vertical_angle < 0.0) {
        m_parser.fail("Negative viewing angle.");
      }
      return true;
    }
    m_angle_where = m_parser.location();
    m_camera.angle = optional_float(m_parser, 0.0);
    m_camera.has_angle = true;
    if (m_camera.angle < 0.0) m_parser.fail("Negative viewing angle.");
    if (!m_in_order && m_camera.kind == CameraKind::kPerspective) apply_angle();
    return true;
  }

  bool accept_blur() {
    if (m_parser.accept(Keyword::kAperture, m_camera.aperture)) return true;
    if (m_parser.accept(Keyword::kBlurSamples)) {
      const int first = m_parser.parse_int();
      if (first <= 0) m_parser.fail("Illegal number of focal blur samples.");
      const int second = static_cast<int>(next_float(m_parser, 0.0));
      if (second != 0 && first > second) {
        m_parser.fail("Focal blur samples minimum must not be larger than maximum.");
      }
      m_camera.blur_samples = second == 0 ? first : second;
      m_camera.blur_samples_min = second == 0 ? 0 : first;
    } else if (m_parser.accept(Keyword::kConfidence)) {
      const double value = m_parser.parse_float();
      if (value > 0.0 && value < 1.0) {
        m_camera.confidence = value;
      } else {
        m_parser.warn("Illegal confidence value; the default is used.");
      }
    } else if (m_parser.accept(Keyword::kVariance)) {
      const double value = m_parser.parse_float();
      if (value >= 0.0 && value <= 1.0) {
        m_camera.variance = value;
      } else {
        m_parser.warn("Illegal variance value; the default is used.");
      }
    } else if (m_parser.accept(Keyword::kFocalPoint)) {
      m_camera.focal_point = m_parser.parse_vector();
      m_camera.has_focal_point = true;
      if (!m_in_order) m_camera.focal_distance = length(m_camera.focal_point - m_camera.location);
    } else if (m_parser.accept(Keyword::kNormal)) {
      m_camera.normal = parse_normal(m_parser, m_context.materials);
    } else if (m_parser.accept(Keyword::kBokeh)) {
      m_parser.expect(Punct::kLeftCurly);
      m_parser.expect(Keyword::kPigment);
      m_camera.bokeh = parse_pigment(m_parser, m_context.materials);
      m_parser.expect(Punct::kRightCurly);
    } else {
      return false;
    }
    return true;
  }

  /// The word that stands next, or "" if it is no identifier. The words of a lens sheet are
  /// contextual: a scene may use them as identifiers elsewhere, so they are no keywords.
  std::string identifier() {
    const Token& token = m_parser.peek();
    if (token.kind != TokenKind::kIdentifier) return {};
    std::string_view rest = m_parser.sources().text(token.where.file);
    if (token.where.offset > rest.size()) return {};
    rest.remove_prefix(token.where.offset);
    std::size_t n = 0;
    while (n < rest.size() && (std::isalnum(static_cast<unsigned char>(rest[n])) || rest[n] == '_'))
      ++n;
    return std::string(rest.substr(0, n));
  }

  /// A word of a lens sheet with one number behind it.
  struct LensWord {
    std::string_view word;
    std::optional<double> LensDesc::*value;
    double least;
    bool may_equal;  ///< the least
  };
  static constexpr LensWord kLensWords[] = {
      {"lens_pitch", &LensDesc::pitch, 0.0, false},
      {"lens_lpi", &LensDesc::lpi, 0.0, false},
      {"lens_focal_length", &LensDesc::focal_length, 0.0, false},
      {"lens_ior", &LensDesc::ior, 1.0, true},
      {"lens_pixels", &LensDesc::pixels, 1.0, true},
      {"print_dpi", &LensDesc::print_dpi, 0.0, false},
      {"lens_front", &LensDesc::front, 0.0, true},
      {"view_distance", &LensDesc::view_distance, 0.0, true}};

  /// The number behind a word, which is next: `is_good` must be true of it.
  template <typename Good>
  double lens_value(std::string_view word, Good is_good, const std::string& expected) {
    m_parser.next();
    const Location where = m_parser.location();
    const double value = m_parser.parse_float();
    if (!is_good(value)) m_parser.fail_at(where, std::string(word) + " must be " + expected + ".");
    return value;
  }

  bool accept_lens_word() {
    const std::string word = identifier();
    if (word == "lenticular") {
      m_parser.next();
      m_camera.kind = CameraKind::kLenticular;
      return true;
    }
    if (m_camera.kind != CameraKind::kLenticular) return false;
    LensDesc& lens = m_camera.lens;
    for (const LensWord& known : kLensWords) {
      if (word != known.word) continue;
      const auto is_good = [&](double value) {
        return (known.may_equal ? value >= known.least : value > known.least) &&
               std::isfinite(value);
      };
      lens.*known.value = lens_value(word, is_good,
                                     std::string(known.may_equal ? "at least " : "greater than ") +
                                         (known.least == 0.0 ? "0" : "1"));
      return true;
    }
    if (word == "lens_model") {
      m_parser.next();
      lens.model = read_lens_model();
    } else if (word == "lens_rays") {
      constexpr int kMost = camera::kMostLensRays;
      const auto is_good = [](double value) {
        return value >= 1.0 && value <= kMost && std::floor(value) == value;
      };
      lens.rays = static_cast<int>(
          lens_value(word, is_good, "a whole number from 1 to " + std::to_string(kMost)));
    } else if (word == "lens_slant") {
      const auto is_good = [](double value) { return std::fabs(value) <= 80.0; };
      lens.slant = lens_value(word, is_good, "an angle of -80 to 80 degrees");
    } else {
      return false;
    }
    return true;
  }

  LensModel read_lens_model() {
    const std::string word = identifier();
    LensModel model = LensModel::kPinhole;
    if (word == "paraxial") {
      model = LensModel::kParaxial;
    } else if (word == "thick") {
      model = LensModel::kThick;
    } else if (word != "pinhole") {
      m_parser.fail_expected("a lens model: one of paraxial, pinhole, thick");
    }
    m_parser.next();
    return model;
  }

  [[noreturn]] void fail_word() {
    std::string words =
        "one of perspective, orthographic, fisheye, ultra_wide_angle, omnimax, panoramic, "
        "spherical, "
        "cylinder, mesh_camera, lenticular, location, direction, right, up, sky, look_at, angle, "
        "aperture, blur_samples, confidence, variance, focal_point, normal, bokeh, a transform";
    if (m_camera.kind == CameraKind::kLenticular) {
      words +=
          ", lens_pitch, lens_lpi, lens_focal_length, lens_ior, lens_pixels, print_dpi, "
          "lens_front, view_distance, lens_model, lens_rays, lens_slant";
    }
    m_parser.fail_expected(words + " or }");
  }

  void apply_angle() {
    if (m_camera.angle >= 180.0) {
      m_parser.fail_at(m_angle_where, "Viewing angle has to be smaller than 180 degrees.");
    }
    if (m_camera.angle <= 0.0) return;
    m_camera.direction =
        normalized(m_camera.direction) * direction_length(length(m_camera.right), m_camera.angle);
  }

  /// look_at turns the three vectors, keeps their lengths and the handedness.
  void turn_to_look_at() {
    CameraDesc& c = m_camera;
    const double along = length(c.direction), high = length(c.up), wide = length(c.right);
    const double handedness = dot(cross(c.up, c.direction), c.right);
    const Vec3 to = c.look_at - c.location;
    if (length_squared(to) < kTiny) {
      m_parser.fail_at(c.where, "Camera location and look_at point must be different.");
    }
    const Vec3 direction = normalized(to);
    Vec3 right = cross(c.sky, direction);
    if (std::abs(right.x) < kTiny && std::abs(right.y) < kTiny && std::abs(right.z) < kTiny) {
      m_parser.warn_at(c.where,
                       "The camera looks along its sky direction: the right vector is kept.");
      right = c.right;
    }
    right = normalized(right);
    c.up = cross(direction, right) * high;
    c.direction = direction * along;
    c.right = right * (handedness > 0.0 ? wide : -wide);
  }

  /// An orthographic picture as large as the perspective one is at look_at.
  void resize_to_look_at() {
    const double to = length(m_camera.look_at - m_camera.location);
    const double along = length(m_camera.direction);
    if (to <= kTiny || along <= kTiny) return;
    m_camera.right *= to / along;
    m_camera.up *= to / along;
  }

  void apply_in_order() {
    CameraDesc& c = m_camera;
    const bool parallel = c.kind == CameraKind::kOrthographic || c.kind == CameraKind::kLenticular;
    if (c.has_angle && (parallel || c.kind == CameraKind::kPerspective)) apply_angle();
    if (c.has_look_at) turn_to_look_at();
    if (parallel && ((!c.has_up && !c.has_right) || c.has_angle)) resize_to_look_at();
    if (c.has_focal_point) c.focal_distance = length(c.focal_point - c.location);
    apply(m_pending);
  }

  void finish() {
    CameraDesc& c = m_camera;
    if (c.focal_distance < 0.0) c.focal_distance = c.has_angle ? length(c.direction) : 1.0;
    if (c.focal_distance == 0.0) c.focal_distance = 1.0;
    if (std::abs(dot(c.right, c.up)) > kTiny || std::abs(dot(c.right, c.direction)) > kTiny ||
        std::abs(dot(c.up, c.direction)) > kTiny) {
      m_parser.warn_at(c.where,
                       "Camera vectors are not perpendicular. Making look_at the last "
                       "statement may help.");
    }
  }

  Parser& m_parser;
  Context& m_context;
  CameraDesc m_camera;
  bool m_in_order;
  Location m_angle_where{};
  core::Transform m_pending;
};

}  // namespace

const char* camera_kind_name(CameraKind kind) {
  switch (kind) {
    case CameraKind::kPerspective: return "perspective";
    case CameraKind::kOrthographic: return "orthographic";
    case CameraKind::kFisheye: return "fisheye";
    case CameraKind::kUltraWideAngle: return "ultra_wide_angle";
    case CameraKind::kOmnimax: return "omnimax";
    case CameraKind::kPanoramic: return "panoramic";
    case CameraKind::kSpherical: return "spherical";
    case CameraKind::kCylinder: return "cylinder";
    case CameraKind::kMesh: return "mesh_camera";
    case CameraKind::kUserDefined: return "user_defined";
    case CameraKind::kLenticular: return "lenticular";
  }
  return "unknown";
}

CameraDesc parse_camera(Parser& parser, Context& context, const CameraDesc& start) {
  return CameraReader(parser, context, start).read();
}

}  // namespace lentray::parser
