// Rays a second through the bounding hierarchy, on one thread, beside Embree 3 on the same
// scenes and rays. Not the same precision: Embree works in float throughout (robust mode),
// Hierarchy has conservative float boxes and double primitives, and its answer names the object
// first in the scene among equals.
//   flake      7381 spheres that touch each other (SPD "balls")
//   triangles  100,000 small ones in a cube
//   gears      64 toothed wheels of triangles (SPD "gears")
// coherent: camera rays, row by row; incoherent: from the points these hit, in random directions;
// shadow: from the same points to one light, any hit.
#include <benchmark/benchmark.h>
#include <embree3/rtcore.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/object/leaf.h"
#include "core/shape/sphere.h"
#include "core/shape/triangle.h"

namespace lentray::core {
namespace {

struct Ball {
  Vec3 centre;
  double radius;
};
using Corners = std::array<Vec3, 3>;

struct Model {
  std::vector<Ball> balls;
  std::vector<Corners> triangles;
  Vec3 eye, target, light;
};

constexpr double kPi = std::numbers::pi;

Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
  return Transform::axis_rotation(axis, angle).vector(v);
}

void add_flake(std::vector<Ball>& balls, const Vec3& centre, double radius, const Vec3& up,
               int levels) {
  balls.push_back({centre, radius});
  if (levels == 0) return;
  const Vec3 axis = cross({0, 0, 1}, up);
  const double angle = std::acos(up.z);
  for (int i = 0; i < 9; ++i) {
    const double height = i < 6 ? 0.0 : 0.8164965809;
    const double around = i < 6 ? i * kPi / 3 : i * 2 * kPi / 3 + kPi / 6;
    const double flat = std::sqrt(1.0 - height * height);
    Vec3 d{flat * std::cos(around), flat * std::sin(around), height};
    if (length(axis) > 1e-9) d = turned(d, axis, angle);
    add_flake(balls, centre + d * (radius * 4 / 3), radius / 3, normalized(d), levels - 1);
  }
}

void add_gear(std::vector<Corners>& out, const Vec3& at, double radius, double thickness) {
  constexpr int kTeeth = 36;
  std::vector<Vec3> rim;
  for (int tooth = 0; tooth < kTeeth; ++tooth) {
    for (const auto& [where, r] :
         {std::pair{-0.19, 1.0}, std::pair{0.19, 1.0}, std::pair{0.3, 0.9}, std::pair{0.7, 0.9}}) {
      const double a = (tooth + where) * 2 * kPi / kTeeth;
      rim.push_back(at + Vec3{r * radius * std::cos(a), r * radius * std::sin(a), 0});
    }
  }
  const Vec3 down{0, 0, -thickness};
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec3 a = rim[i], b = rim[(i + 1) % rim.size()];
    out.push_back({at, a, b});
    out.push_back({at + down, a + down, b + down});
    out.push_back({a, b, b + down});
    out.push_back({a, b + down, a + down});
  }
}

Model make_model(const std::string& name) {
  Model model;
  if (name == "flake") {
    add_flake(model.balls, {0, 0, 0}, 0.5, {0, 0, 1}, 4);
    model.eye = {2.1, 1.3, 1.7};
    model.light = {4, 3, 2};
  } else if (name == "gears") {
    const double radius = 1.0 / (4 - 3 * 0.05);
    for (int i = 0; i < 64; ++i) {
      const Vec3 at{-1 + radius + 1.9 * radius * (i % 4), -1 + radius + 1.9 * radius * (i / 4 % 4),
                    1.0 - 0.25 * (i / 16)};
      add_gear(model.triangles, at, 0.995 * radius, 0.1);
    }
    model.eye = {-1.1, -2.1, 2.6};
    model.light = {2, 4, 4};
  } else {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto point = [&] { return Vec3{unit(random), unit(random), unit(random)}; };
    for (int i = 0; i < 100000; ++i) {
      const Vec3 a = point();
      model.triangles.push_back({a, a + point() * 0.02, a + point() * 0.02});
    }
    model.eye = {2.1, 1.3, 1.7};
    model.light = {4, 3, 2};
  }
  return model;
}

struct EmbreeScene {
  explicit EmbreeScene(const Model& model)
      : device(rtcNewDevice("threads=1,set_affinity=0")), scene(rtcNewScene(device)) {
    rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    const bool spheres = !model.balls.empty();
    RTCGeometry geometry = rtcNewGeometry(
        device, spheres ? RTC_GEOMETRY_TYPE_SPHERE_POINT : RTC_GEOMETRY_TYPE_TRIANGLE);
    const std::size_t count = spheres ? model.balls.size() : 3 * model.triangles.size();
    auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, spheres ? RTC_FORMAT_FLOAT4 : RTC_FORMAT_FLOAT3,
        (spheres ? 4 : 3) * sizeof(float), count));
    const auto put = [&v](double x) { *v++ = static_cast<float>(x); };
    for (const Ball& b : model.balls) {
      for (int a = 0; a < 3; ++a) put(b.centre[a]);
      put(b.radius);
    }
    for (const Corners& t : model.triangles) {
      for (const Vec3& p : t) {
        for (int a = 0; a < 3; ++a) put(p[a]);
      }
    }
    if (!spheres) {
      auto* index = static_cast<std::uint32_t*>(
          rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                  3 * sizeof(std::uint32_t), model.triangles.size()));
      for (std::uint32_t i = 0; i < count; ++i) index[i] = i;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
  }
  ~EmbreeScene() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  RTCDevice device;
  RTCScene scene;
};

struct Setting {
  explicit Setting(const std::string& name) : model(make_model(name)), embree(model) {
    for (const Ball& b : model.balls) add(std::make_unique<Sphere>(b.centre, b.radius));
    for (const Corners& t : model.triangles) add(std::make_unique<Triangle>(t[0], t[1], t[2]));
    hierarchy = std::make_unique<Hierarchy>(objects);
    make_rays();
  }

  void add(std::unique_ptr<Shape> shape) {
    objects.push_back(std::make_unique<Leaf>(std::move(shape), Transform()));
    objects.back()->set_opaque(true);
  }
  void make_rays() {
    constexpr int kSize = 512;
    const Vec3 ahead = normalized(model.target - model.eye);
    const Vec3 right = normalized(cross(ahead, {0, 0, 1})), up = cross(right, ahead);
    const double scale = 2.0 * std::tan(22.5 * kPi / 180) / kSize;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    HitLists lists;
    for (int y = 0; y < kSize; ++y) {
      for (int x = 0; x < kSize; ++x) {
        const Vec3 d =
            ahead + right * ((x - kSize / 2 + 0.5) * scale) - up * ((y - kSize / 2 + 0.5) * scale);
        coherent.push_back({model.eye, normalized(d)});
        Hit hit;
        if (!hierarchy->nearest(coherent.back(), 1e-4, 1e30, RayKind::kCamera, hit, lists, nullptr))
          continue;
        const Vec3 p = coherent.back().at(hit.t * (1 - 1e-6));
        incoherent.push_back({p, normalized({normal(random), normal(random), normal(random)})});
        shadow.push_back({p, normalized(model.light - p)});
      }
    }
  }

  Model model;
  std::vector<std::unique_ptr<Object>> objects;
  std::unique_ptr<Hierarchy> hierarchy;
  EmbreeScene embree;
  std::vector<Ray> coherent, incoherent, shadow;
};

const Setting& setting(const std::string& name) {
  static std::map<std::string, std::unique_ptr<Setting>> all;
  auto& s = all[name];
  if (!s) s = std::make_unique<Setting>(name);
  return *s;
}

void report(benchmark::State& state, std::size_t rays, std::size_t hits) {
  state.counters["Mrays/s"] = benchmark::Counter(
      static_cast<double>(rays * state.iterations()) / 1e6, benchmark::Counter::kIsRate);
  state.counters["hit"] = static_cast<double>(hits) / static_cast<double>(rays);
}

void run_lentray(benchmark::State& state, const std::string& name, const std::string& kind) {
  const Setting& s = setting(name);
  const auto& rays = kind == "coherent" ? s.coherent : kind == "shadow" ? s.shadow : s.incoherent;
  HitLists lists;
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (const Ray& ray : rays) {
      Hit hit;
      hits += kind == "shadow"
                  ? s.hierarchy->any_opaque(ray, 1e-4, 1e30, lists, nullptr) != nullptr
                  : s.hierarchy->nearest(ray, 1e-4, 1e30, RayKind::kCamera, hit, lists, nullptr);
    }
    benchmark::DoNotOptimize(hits);
  }
  report(state, rays.size(), hits);
}

RTCRay embree_ray(const Ray& ray) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = 1e-4f;
  r.tfar = 1e30f;
  r.mask = ~0u;
  return r;
}

void run_embree(benchmark::State& state, const std::string& name, const std::string& kind) {
  const Setting& s = setting(name);
  const auto& rays = kind == "coherent" ? s.coherent : kind == "shadow" ? s.shadow : s.incoherent;
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = kind == "coherent" ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                       : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    for (const Ray& ray : rays) {
      if (kind == "shadow") {
        RTCRay r = embree_ray(ray);
        rtcOccluded1(s.embree.scene, &context, &r);
        hits += r.tfar < 0.0f;
      } else {
        RTCRayHit r{};
        r.ray = embree_ray(ray);
        r.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(s.embree.scene, &context, &r);
        hits += r.hit.geomID != RTC_INVALID_GEOMETRY_ID;
      }
    }
    benchmark::DoNotOptimize(hits);
  }
  report(state, rays.size(), hits);
}

void build_lentray(benchmark::State& state, const std::string& name) {
  const Setting& s = setting(name);
  for (auto _ : state) {
    const Hierarchy hierarchy(s.objects);
    benchmark::DoNotOptimize(hierarchy.memory());
  }
}

}  // namespace
}  // namespace lentray::core

int main(int argc, char** argv) {
  using namespace lentray::core;
  for (const std::string scene : {"flake", "triangles", "gears"}) {
    for (const std::string kind : {"coherent", "incoherent", "shadow"}) {
      benchmark::RegisterBenchmark((scene + "/" + kind + "/lentray").c_str(), run_lentray, scene,
                                   kind)
          ->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark((scene + "/" + kind + "/embree").c_str(), run_embree, scene,
                                   kind)
          ->Unit(benchmark::kMillisecond);
    }
    benchmark::RegisterBenchmark((scene + "/build/lentray").c_str(), build_lentray, scene)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
