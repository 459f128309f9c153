#include "core/accel/light_volume.h"

namespace lentray::core {
namespace {

constexpr double kEdgeOn =
    0x1p-20;  ///< a plane nearer to the light than this of its size has no side
constexpr double kRounding = 0x1p-30;  ///< of a corner beside a plane, to its distance
constexpr double kFlat = 0x1p-23;  ///< of the distance: corners farther off are not in their plane
constexpr double kLeastLength =
    1e-6;  ///< squared, to a cone's radius: a flatter one's side is not sure
constexpr double kOfDistance = 1e-6;  ///< more than rounding of a plane's distance in floats

/// Not less than the length, at most 1.74 times as much.
double sum_of_parts(const Vec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

}  // namespace

/// Coordinates of the objects' tests are off by reach * 2^-52. That turns an edge of some size, as the
/// light sees it, by reach / size as much, and moves its shadow with the point's distance over the
/// object's. Where size times distance is not less than this, the shadow moves by less than an eighth
/// of the slack.
LightVolumes::LightVolumes(double reach) : m_reach(reach), m_least(0x1p-26 * reach * reach) {}

/// The plane through the light and an edge, whose normal has the length of the edge as the light sees it
/// times its distance, at most `far`. `least`: size that is sure.
void LightVolumes::set_side(LightVolume& volume, int lane, const Vec3& inwards, double far,
                            double least) const {
  const double sum = sum_of_parts(inwards);
  if (!(sum > least * far)) return;
  const double scale = 1.0 / sum;
  volume.x[lane] = static_cast<float>(inwards.x * scale);
  volume.y[lane] = static_cast<float>(inwards.y * scale);
  volume.z[lane] = static_cast<float>(inwards.z * scale);
}

/// dot(normal, x) = offset, at most `far` from the light where the object is.
void LightVolumes::set_plane(LightVolume& volume, const Vec3& normal, double offset,
                             double far) const {
  const double sum = sum_of_parts(normal);
  if (!(std::fabs(offset) > kEdgeOn * sum * far)) return;
  const double scale = (offset < 0.0 ? -1.0 : 1.0) / sum;
  for (int a = 0; a < 3; ++a) volume.plane[a] = static_cast<float>(normal[a] * scale);
  volume.plane[3] = static_cast<float>(-offset * scale * (1.0 - kOfDistance));
}

LightVolume LightVolumes::triangle(const Vec3& a, const Vec3& b, const Vec3& c,
                                   double distance) const {
  LightVolume volume;
  const Vec3 ab = b - a, bc = c - b, ca = a - c;
  const Vec3 normal = cross(ab, bc);  // as long as the longest side times the least height
  const double offset = dot(normal, a);
  const double longest = std::max({sum_of_parts(ab), sum_of_parts(bc), sum_of_parts(ca)});
  const double far = std::max({sum_of_parts(a), sum_of_parts(b), sum_of_parts(c)});
  const double least = m_least / distance, size = sum_of_parts(normal);
  // Seen edge-on the sides cannot be told.
  if (!(size > least * longest) || !(std::fabs(offset) > kEdgeOn * size * far)) return volume;
  const double sign = offset < 0.0 ? -1.0 : 1.0;
  set_side(volume, 0, cross(a, ab) * sign, far, least);
  set_side(volume, 1, cross(b, bc) * sign, far, least);
  set_side(volume, 2, cross(c, ca) * sign, far, least);
  set_plane(volume, normal, offset, far);
  return volume;
}

void LightVolumes::polygon(std::span<const Vec3> ends, const Vec3& normal, double offset,
                           double distance, LightVolume& volume) const {
  double far = 0.0, off = 0.0;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    far = std::max(far, sum_of_parts(ends[i]));
    off = std::max(off, std::fabs(dot(normal, ends[i]) - offset));
  }
  const double least = m_least / distance;
  if (!(off < kFlat * distance) || !(distance > least)) return;
  if (!(std::fabs(offset) > kEdgeOn * 2.0 * far)) return;
  set_plane(volume, normal, offset, far);
  const std::size_t edges = ends.size() / 2;
  if (edges > 4) return;
  // Turns the same way at every corner, and ends where it began.
  Vec3 along[4];
  int left = 0, right = 0;
  for (std::size_t i = 0; i < edges; ++i) along[i] = ends[2 * i + 1] - ends[2 * i];
  for (std::size_t i = 0; i < edges; ++i) {
    const std::size_t next = i + 1 < edges ? i + 1 : 0;
    if (ends[2 * i + 1] != ends[2 * next]) return;
    ++(dot(cross(along[i], along[next]), normal) > 0.0 ? left : right);
  }
  if (left != 0 && right != 0) return;
  const double sign = (left != 0) == (offset > 0.0) ? 1.0 : -1.0;
  for (std::size_t i = 0; i < edges; ++i) {
    set_side(volume, static_cast<int>(i), cross(ends[2 * i], along[i]) * sign, far, least);
  }
}

namespace {

void set(LightVolume& volume, int lane, const Vec3& unit_normal) {
  volume.x[lane] = static_cast<float>(unit_normal.x);
  volume.y[lane] = static_cast<float>(unit_normal.y);
  volume.z[lane] = static_cast<float>(unit_normal.z);
}

}  // namespace

/// Four planes that touch it, square to each other.
LightVolume LightVolumes::sphere(const Vec3& centre, double radius, double distance) const {
  LightVolume volume;
  const double far2 = dot(centre, centre), tangent2 = far2 - radius * radius;
  if (!(radius * distance > m_least) || !(tangent2 > 0.0)) return volume;
  const Vec3 a{std::fabs(centre.x), std::fabs(centre.y), std::fabs(centre.z)};
  const Vec3 across = a.x > a.y && a.x > a.z ? Vec3{-centre.y, centre.x, 0.0}
                      : a.y > a.z            ? Vec3{0.0, -centre.z, centre.y}
                                             : Vec3{centre.z, 0.0, -centre.x};
  const double over_far2 = 1.0 / far2, cosine = std::sqrt(tangent2 * over_far2);
  const Vec3 u = across * (cosine / length(across)), v = cross(centre, u) * std::sqrt(over_far2);
  const Vec3 in = centre * (radius * over_far2);
  set(volume, 0, in + u);
  set(volume, 1, in - u);
  set(volume, 2, in + v);
  set(volume, 3, in - v);
  return volume;
}

/// Two planes that touch the spheres of the ends, and at each end one through the outermost corner of the
/// section that the plane through light and axis cuts: discs square to the axis reach no farther.
LightVolume LightVolumes::cone(const Vec3& a, double radius_a, const Vec3& b, double radius_b,
                               double distance) const {
  LightVolume volume;
  const double aa = dot(a, a), ab = dot(a, b), bb = dot(b, b);
  const Vec3 across = cross(a, b);
  const double across2 = dot(across, across);
  const double least = m_least / distance, thick = std::max(radius_a, radius_b);
  if (!(thick > least) || !(length_squared(b - a) > kLeastLength * thick * thick)) return volume;
  if (!(across2 > least * least * std::max(aa, bb))) return volume;
  // normal = p a + q b +- r across with dot(normal, a) = radius_a, dot(normal, b) = radius_b, length 1.
  const double over = 1.0 / across2;
  const double p = (radius_a * bb - radius_b * ab) * over,
               q = (radius_b * aa - radius_a * ab) * over;
  const double rest = 1.0 - (p * radius_a + q * radius_b);
  if (!(rest > 0.0)) return volume;  // one hides the other
  const Vec3 in = a * p + b * q, side = across * std::sqrt(rest * over);
  set(volume, 0, in + side);
  set(volume, 1, in - side);
  const Vec3 axis = b - a;
  const Vec3 rise = cross(across, axis) * std::sqrt(over / length_squared(axis));
  const Vec3 at_a[2] = {a + rise * radius_a, a - rise * radius_a};
  const Vec3 at_b[2] = {b + rise * radius_b, b - rise * radius_b};
  // `around` turns from this end to the other.
  const auto end = [&](int lane, const Vec3(&own)[2], const Vec3(&other)[2], const Vec3& around) {
    const bool first = dot(cross(around, own[0]), own[1]) >= 0.0;
    const Vec3 normal = cross(around, own[first ? 0 : 1]);
    if (!(dot(normal, other[0]) >= 0.0 && dot(normal, other[1]) >= 0.0)) return;
    set(volume, lane, normal / length(normal));
  };
  end(2, at_a, at_b, across);
  end(3, at_b, at_a, -across);
  return volume;
}

/// Of the six edges of its outline the two that are along the edge out of the face that shows largest are left
/// out: that adds least.
void LightVolumes::box(std::span<const Vec3> corners, double distance, double area,
                       LightVolume& volume) const {
  const double least = m_least / distance;
  if (!(distance > least)) return;
  const Vec3 edges[3] = {corners[1] - corners[0], corners[2] - corners[0], corners[4] - corners[0]};
  const Vec3 faces[3] = {cross(edges[1], edges[2]), cross(edges[2], edges[0]),
                         cross(edges[0], edges[1])};
  const Vec3 middle = (corners[0] + corners[7]) * 0.5;
  double shown[3], far = 0.0;
  for (int a = 0; a < 3; ++a) shown[a] = std::fabs(dot(faces[a], middle));
  for (const Vec3& p : corners) far = std::max(far, sum_of_parts(p));
  const int out =
      shown[0] > shown[1] ? (shown[0] > shown[2] ? 0 : 2) : (shown[1] > shown[2] ? 1 : 2);
  const Vec3& face = faces[out];
  const double low = dot(face, corners[0]), high = dot(face, corners[7]);
  if (low * high > 0.0)
    set_plane(volume, low > 0.0 ? face : -face, std::min(std::fabs(low), std::fabs(high)), far);

  const int first = (out + 1) % 3, second = (out + 2) % 3;
  const double added = shown[first] * shown[second] / shown[out], square = length_squared(middle);
  if (!(shown[0] + shown[1] + shown[2] + added < area * square * std::sqrt(square))) return;
  int lane = 0;
  for (const int along : {first, second}) {
    const std::size_t u = along == 0 ? 2 : 1, v = along == 2 ? 2 : 4;
    const std::size_t numbers[4] = {0, u, v,
                                    u + v};  // of corners where the four edges that way begin
    const auto beyond = [&](const Vec3& normal, std::size_t i) {
      return dot(normal, corners[numbers[i]]);
    };
    // The outermost to either side; all around the light there are none.
    Vec3 least_side = cross(corners[0], edges[along]), most_side = least_side;
    for (std::size_t i = 1; i < 4; ++i) {
      if (beyond(least_side, i) < 0.0) least_side = cross(corners[numbers[i]], edges[along]);
      if (beyond(most_side, i) > 0.0) most_side = cross(corners[numbers[i]], edges[along]);
    }
    bool is_around = false;
    for (std::size_t i = 0; i < 4; ++i) {
      is_around = is_around ||
                  beyond(least_side, i) < -kRounding * sum_of_parts(least_side) * far ||
                  beyond(most_side, i) > kRounding * sum_of_parts(most_side) * far;
    }
    for (const Vec3& inwards : {least_side, -most_side}) {
      volume.x[lane] = volume.y[lane] = volume.z[lane] = 0.0f;
      if (!is_around) set_side(volume, lane, inwards, far, least);
      ++lane;
    }
  }
}

}  // namespace lentray::core
