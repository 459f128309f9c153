// Polygons against the plain even-odd rule, meshes against trying every triangle.
#include <gtest/gtest.h>

#include <numbers>

#include "core/shape/mesh.h"
#include "core/shape/polygon.h"
#include "core/shape/triangle.h"
#include "tests/unit/shape/geometry_help.h"

namespace lentray::core {
namespace {

using geometry_test::Random;
constexpr double kGeometryPolygonMeshInf = Bounds::kInf;

/// A star of n points in the plane z = 0, closed.
std::vector<Vec3> star(int n, double inner, double outer, double turn = 0.0) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double a = turn + 2.0 * std::numbers::pi * i / n, r = i % 2 ? inner : outer;
    points.push_back({r * std::cos(a), r * std::sin(a), 0.0});
  }
  points.push_back(points[0]);
  return points;
}

/// Even-odd by counting the crossings to the right, of contours given one by one.
bool plain_even_odd(const std::vector<std::vector<Vec3>>& contours, double x, double y) {
  bool odd = false;
  for (const auto& c : contours) {
    for (std::size_t i = 0; i < c.size(); ++i) {
      const Vec3 &a = c[i], &b = c[(i + 1) % c.size()];
      if ((a.y >= y) == (b.y >= y)) continue;
      odd ^= x <= a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
  }
  return odd;
}

void compare(const Polygon& polygon, const std::vector<std::vector<Vec3>>& contours,
             unsigned seed) {
  ASSERT_FALSE(polygon.is_degenerate());
  Random random(seed);
  int met = 0;
  for (int k = 0; k < 20000; ++k) {
    const double x = random.in(-1.2, 1.2), y = random.in(-1.2, 1.2);
    ShapeHit hit;
    const bool in = polygon.nearest({{x, y, -2}, {0, 0, 1}}, 0, kGeometryPolygonMeshInf, hit);
    ASSERT_EQ(in, plain_even_odd(contours, x, y)) << x << " " << y;
    met += in;
  }
  EXPECT_GT(met, 100);
}

TEST(UnitCorePolygon, FastTestsMatchPlainEvenOdd) {
  compare(Polygon(star(144, 0.9, 1.0)), {star(144, 0.9, 1.0)}, 1);
  compare(Polygon(star(36, 0.2, 1.0)), {star(36, 0.2, 1.0)}, 2);
  compare(Polygon(star(4, 1.0, 1.0)), {star(4, 1.0, 1.0)}, 3);
  compare(Polygon(star(3, 1.0, 1.0, 0.3)), {star(3, 1.0, 1.0, 0.3)}, 4);
  compare(Polygon(star(5, 1.0, 1.0, 0.3)), {star(5, 1.0, 1.0, 0.3)}, 5);
  compare(Polygon(star(9000, 0.8, 1.0)), {star(9000, 0.8, 1.0)}, 6);
  std::vector<Vec3> crossed;  // a pentagram: the middle is out
  for (int i = 0; i <= 5; ++i)
    crossed.push_back(star(5, 1.0, 1.0)[static_cast<std::size_t>(2 * i % 5)]);
  compare(Polygon(crossed), {crossed}, 7);
  ShapeHit hit;
  EXPECT_FALSE(Polygon(crossed).nearest({{0, 0, -1}, {0, 0, 1}}, 0, kGeometryPolygonMeshInf, hit));
}

TEST(UnitCorePolygon, ContoursMakeHolesAndAnOpenOneIsClosed) {
  std::vector<Vec3> points = star(8, 1.0, 1.0);
  const std::vector<Vec3> hole = star(4, 0.3, 0.3), island = star(3, 0.1, 0.1);
  points.insert(points.end(), hole.begin(), hole.end());
  points.insert(points.end(), island.begin(), island.end() - 1);  // left open
  compare(Polygon(points), {star(8, 1.0, 1.0), hole, island}, 8);
}

TEST(UnitCorePolygon, TransformsAndAllPlanes) {
  Random random(9);
  const std::vector<Vec3> points = star(30, 0.5, 1.0);
  const Polygon flat(points);
  for (int round = 0; round < 40; ++round) {
    const Transform t = random.any_transform();
    const auto moved = flat.baked(t);
    for (int k = 0; k < 200; ++k) {
      const Vec3 p{random.in(-1, 1), random.in(-1, 1), 0.0};
      const Vec3 d = random.direction();
      if (std::fabs(d.z) < 0.05) continue;
      const Ray local{p - d, d}, world{t.point(p - d), t.vector(d)};
      ShapeHit a, b;
      const bool met = flat.nearest(local, 0, kGeometryPolygonMeshInf, a);
      ASSERT_EQ(moved->nearest(world, 0, kGeometryPolygonMeshInf, b), met);
      if (met) {
        EXPECT_NEAR(b.t, 1.0, 1e-9);
      }
    }
    EXPECT_GT(dot(moved->normal({}, {}), normalized(t.normal(flat.normal({}, {})))), 1 - 1e-9);
  }
}

TEST(UnitCorePolygon, NeighboursShareTheirEdgeOnce) {
  // Rays exactly at the common edge of two rectangles meet exactly one of them.
  const Polygon left({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  const Polygon right({{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 0, 0}});
  for (int k = 1; k < 20; ++k) {
    const Ray ray{{1.0, k / 20.0, -1}, {0, 0, 1}};
    ShapeHit hit;
    EXPECT_EQ(left.nearest(ray, 0, kGeometryPolygonMeshInf, hit) +
                  right.nearest(ray, 0, kGeometryPolygonMeshInf, hit),
              1);
  }
}

TEST(UnitCorePolygon, DegenerateOnesAreDropped) {
  EXPECT_TRUE(Polygon({{0, 0, 0}, {1, 0, 0}}).is_degenerate());
  EXPECT_TRUE(Polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 0, 0}}).is_degenerate());
  EXPECT_TRUE(Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 1e-9}, {0, 1, 0}, {0, 0, 0}}).is_degenerate());
  EXPECT_TRUE(
      Polygon({{0, 0, 0}, {.002, 0, 0}, {.002, .002, 0}, {0, .002, 0}, {0, 0, 0}}).is_degenerate());
  EXPECT_FALSE(Polygon({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}).is_degenerate());
  EXPECT_TRUE(Polygon({}).bounds().is_empty());
}

/// A bumpy closed surface of about 2 n^2 triangles.
MeshData bumpy(int n, unsigned seed) {
  Random random(seed);
  MeshData data;
  const auto id = [n](int i, int j) { return static_cast<std::uint32_t>(i * n + j % n); };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      const double a = std::numbers::pi * i / n, b = 2.0 * std::numbers::pi * j / n;
      const double r = i == 0 || i == n ? 1.0 : random.in(0.8, 1.2);
      data.vertices.push_back(
          {r * std::sin(a) * std::cos(b), r * std::cos(a), r * std::sin(a) * std::sin(b)});
    }
  }
  for (int j = 0; j < n; ++j) {  // the poles are one point each
    data.vertices[id(0, j)] = {0, 1, 0};
    data.vertices[id(n, j)] = {0, -1, 0};
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      data.faces.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      data.faces.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  }
  return data;
}

TEST(UnitCoreMesh, MatchesEveryTriangleTried) {
  const MeshData data = bumpy(24, 3);
  const auto triangles = std::make_shared<const TriangleMesh>(data);
  EXPECT_EQ(triangles->dropped(), 48u);  // two degenerate ones a column at the poles
  const Mesh mesh(triangles, Vec3{0, 1, 0}, true);
  std::vector<Triangle> all;
  for (const MeshTriple& f : data.faces) {
    all.emplace_back(data.vertices[f[0]], data.vertices[f[1]], data.vertices[f[2]]);
  }
  Random random(4);
  int met = 0;
  for (int k = 0; k < 3000; ++k) {
    const Ray ray = random.ray(random.in(0.0, 3.0), 1.0);
    double nearest = kGeometryPolygonMeshInf;
    std::size_t count = 0;
    for (const Triangle& t : all) {
      ShapeHit hit;
      if (!t.nearest(ray, 1e-6, kGeometryPolygonMeshInf, hit)) continue;
      nearest = std::min(nearest, hit.t);
      ++count;
    }
    ShapeHit hit;
    ShapeHits hits;
    mesh.all(ray, 1e-6, kGeometryPolygonMeshInf, hits);
    EXPECT_EQ(hits.size(), count);
    ASSERT_EQ(mesh.nearest(ray, 1e-6, kGeometryPolygonMeshInf, hit), count > 0);
    EXPECT_EQ(mesh.any(ray, 1e-6, kGeometryPolygonMeshInf), count > 0);
    if (count == 0) continue;
    EXPECT_EQ(hit.t, nearest);
    EXPECT_FALSE(mesh.nearest(ray, 1e-6, nearest, hit));
    ++met;
  }
  EXPECT_GT(met, 1000);
}

TEST(UnitCoreMesh, InsideByParityEvenThroughEdgesAndCorners) {
  const Mesh mesh(std::make_shared<const TriangleMesh>(bumpy(16, 5)), Vec3{0, 1, 0}, false);
  EXPECT_TRUE(mesh.inside({0, 0, 0}));  // straight at the pole
  EXPECT_TRUE(mesh.inside({0, 0.5, 0}));
  EXPECT_FALSE(mesh.inside({0, -1.5, 0}));  // through both poles
  EXPECT_FALSE(mesh.inside({0, 1.5, 0}));
  Random random(6);
  for (int k = 0; k < 2000; ++k) {
    const Vec3 d = random.direction();
    EXPECT_TRUE(mesh.inside(d * 0.6));
    EXPECT_FALSE(mesh.inside(d * 1.3));
    EXPECT_NE(mesh.inside(d), mesh.holds(d, true));
  }
  const Mesh skin(std::make_shared<const TriangleMesh>(bumpy(16, 5)), std::nullopt, false);
  EXPECT_FALSE(skin.inside({0, 0, 0}) || skin.holds({0, 0, 0}, true) || skin.traits().is_solid);
}

TEST(UnitCoreMesh, NormalsTexturesUvAndErrors) {
  MeshData data;
  data.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  data.normals = {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  data.uvs = {{0, 0}, {4, 0}, {0, 8}};
  data.faces = data.face_normals.list = data.face_uvs.list = {{0, 1, 2}};
  data.face_textures.set(0, {0, 0, 1});
  MeshData bad = data;
  Mesh mesh(std::make_shared<const TriangleMesh>(data), std::nullopt, true);
  const auto* red = reinterpret_cast<const Texture*>(&data);
  const auto* blue = reinterpret_cast<const Texture*>(&bad);
  mesh.set_textures({red, blue});
  ShapeHit hit;
  ASSERT_TRUE(mesh.nearest({{0.25, 0.5, -1}, {0, 0, 1}}, 0, kGeometryPolygonMeshInf, hit));
  const Vec3 n = mesh.normal({}, hit);
  EXPECT_DOUBLE_EQ(n.x, 0.25);
  EXPECT_DOUBLE_EQ(n.y, 0.5);
  EXPECT_DOUBLE_EQ(n.z, -0.25);
  EXPECT_EQ(mesh.uv({}, hit), (Vec2{1.0, 4.0}));
  MeshTexture share[3];
  ASSERT_EQ(mesh.textures_at(hit, share), 3);
  EXPECT_EQ(share[0].texture, red);
  EXPECT_EQ(share[2].texture, blue);
  EXPECT_DOUBLE_EQ(share[2].weight, 0.5);
  bad.faces[0][2] = 3;
  EXPECT_THROW(TriangleMesh{bad}, std::out_of_range);
}

}  // namespace
}  // namespace lentray::core
