#include "core/shape/polygon.h"

#include <algorithm>

#include "core/base/tiny.h"
#include "core/numeric/bounds_help.h"

namespace lentray::core {
namespace {

constexpr int kMaxBands = 4096;

bool same_place(const Vec3& a, const Vec3& b) {
  return std::fabs(a.x - b.x) < kTiny && std::fabs(a.y - b.y) < kTiny &&
         std::fabs(a.z - b.z) < kTiny;
}

}  // namespace

EvenOdd::EvenOdd(std::vector<Edge> edges) {
  if (edges.empty()) return;
  double hi_v = edges[0].v1;
  m_lo_v = edges[0].v0;
  for (const Edge& e : edges) {
    m_lo_v = std::min(m_lo_v, e.v0);
    hi_v = std::max(hi_v, e.v1);
  }
  m_bands = std::min(static_cast<int>(edges.size()), kMaxBands);
  m_per_band = m_bands / (hi_v - m_lo_v);
  if (!std::isfinite(m_per_band)) {
    m_bands = 1;
    m_per_band = 0.0;
  }
  std::vector<std::uint32_t> count(static_cast<std::size_t>(m_bands) + 1, 0);
  for (const Edge& e : edges) {
    for (int b = band(e.v0); b <= band(e.v1); ++b) ++count[static_cast<std::size_t>(b)];
  }
  m_first.assign(count.size(), 0);
  for (std::size_t b = 1; b < count.size(); ++b) m_first[b] = m_first[b - 1] + count[b - 1];
  m_edges.resize(m_first.back());
  std::vector<std::uint32_t> next = m_first;
  for (const Edge& e : edges) {
    for (int b = band(e.v0); b <= band(e.v1); ++b) m_edges[next[static_cast<std::size_t>(b)]++] = e;
  }
}

/// Monotonic in v, so that an edge lies in the bands of all points that it can count for.
int EvenOdd::band(double v) const {
  return std::clamp(static_cast<int>((v - m_lo_v) * m_per_band), 0, m_bands - 1);
}

bool EvenOdd::contains(double u, double v) const {
  if (m_bands == 0) return false;
  const auto b = static_cast<std::size_t>(band(v));
  bool odd = false;
  for (std::uint32_t i = m_first[b]; i < m_first[b + 1]; ++i) odd ^= crosses(m_edges[i], u, v);
  return odd;
}

Polygon::Polygon(std::vector<Vec3> points) : m_points(std::move(points)) {
  if (m_points.size() < 3) {
    m_degenerate = true;
    return;
  }
  std::size_t start = 0;
  bool closed = false;
  for (std::size_t i = 1; i < m_points.size(); ++i) {
    closed = same_place(m_points[i], m_points[start]);
    if (!closed) continue;
    m_points[i] = m_points[start];
    start = ++i;
  }
  if (!closed && start < m_points.size()) m_points.push_back(m_points[start]);
  orient();
  if (!m_degenerate) flatten();
}

/// The normal from the first corner that is wide enough, and whether the points lie in a plane.
void Polygon::orient() {
  const Vec3 origin = m_points[0];
  std::size_t i = 1;
  while (i < m_points.size() && !(length_squared(m_points[i] - origin) > kTiny)) ++i;
  const Vec3 first = i < m_points.size() ? m_points[i] - origin : Vec3{};
  Vec3 normal;
  for (++i; i < m_points.size(); ++i) {
    const Vec3 second = m_points[i] - origin;
    normal = cross(first, second);
    if (length_squared(second) > kTiny && length_squared(normal) > kTiny) break;
  }
  m_degenerate = i >= m_points.size();
  m_normal = normalized(normal);
  for (const Vec3& p : m_points) {
    if (std::fabs(dot(p - origin, m_normal)) > kTiny) m_degenerate = true;
  }
}

/// Plane and projection along the axis that the normal is nearest to.
void Polygon::flatten() {
  m_offset = dot(m_normal, m_points[0]);
  const Vec3 n{std::fabs(m_normal.x), std::fabs(m_normal.y), std::fabs(m_normal.z)};
  const int dropped = n.x > n.y ? (n.x > n.z ? 0 : 2) : (n.y > n.z ? 1 : 2);
  m_u = dropped == 0 ? 1 : 0;
  m_v = dropped == 2 ? 1 : 2;
  m_lo_u = m_lo_v = Bounds::kInf;
  m_hi_u = m_hi_v = -Bounds::kInf;
  for (const Vec3& p : m_points) {
    m_lo_u = std::min(m_lo_u, p[m_u]);
    m_hi_u = std::max(m_hi_u, p[m_u]);
    m_lo_v = std::min(m_lo_v, p[m_v]);
    m_hi_v = std::max(m_hi_v, p[m_v]);
  }
  std::vector<EvenOdd::Edge> all = edges();
  if (all.size() > kFew) {
    m_many = EvenOdd(std::move(all));
    return;
  }
  m_few_edges = static_cast<std::uint32_t>(all.size());
  std::copy(all.begin(), all.end(), m_few.begin());
}

/// Those that can count: not level ones.
std::vector<EvenOdd::Edge> Polygon::edges() const {
  std::vector<EvenOdd::Edge> result;
  std::size_t start = 0;
  for (std::size_t i = 1; i < m_points.size(); ++i) {
    const Vec3 &a = m_points[i - 1], &b = m_points[i];
    if (a[m_v] < b[m_v]) result.push_back({a[m_u], a[m_v], b[m_u], b[m_v]});
    if (b[m_v] < a[m_v]) result.push_back({b[m_u], b[m_v], a[m_u], a[m_v]});
    if (b == m_points[start]) start = ++i;
  }
  return result;
}

Bounds Polygon::own_box() const {
  Bounds b;
  if (m_degenerate) return b;
  for (const Vec3& p : m_points) b.include(p);
  return padded(b);
}

bool Polygon::nearest(const Ray& ray, double t_min, double t_max, ShapeHit& hit) const {
  if (m_degenerate) return false;
  const double slope = dot(m_normal, ray.direction);
  const double t = (m_offset - dot(m_normal, ray.origin)) / slope;
  if (!(t > t_min && t < t_max)) return false;  // a slope of 0 gives infinity or no number
  const double u = ray.origin[m_u] + t * ray.direction[m_u];
  const double v = ray.origin[m_v] + t * ray.direction[m_v];
  if (!(u >= m_lo_u && u <= m_hi_u && v >= m_lo_v && v <= m_hi_v)) return false;
  bool odd = false;
  if (m_few_edges != 0) {
    for (std::uint32_t i = 0; i < m_few_edges; ++i) odd ^= EvenOdd::crosses(m_few[i], u, v);
  } else {
    odd = m_many.contains(u, v);
  }
  if (!odd) return false;
  hit = {t, 0, 0.0, 0.0};
  return true;
}

Vec3 Polygon::normal(const Vec3&, const ShapeHit&) const { return m_normal; }

std::unique_ptr<Shape> Polygon::baked(const Transform& t) const {
  auto moved = std::make_unique<Polygon>(*this);
  if (m_degenerate) return moved;
  // Points stay closed exactly: equal points move to equal ones. Flatness is judged before.
  for (Vec3& p : moved->m_points) p = t.point(p);
  moved->m_normal = normalized(t.normal(m_normal));
  moved->m_few_edges = 0;
  moved->m_many = EvenOdd();
  moved->flatten();
  return moved;
}

}  // namespace lentray::core
