#include "core/base/counters.h"

namespace lentray::core {

void Counters::merge(const Counters& other) {
  camera_rays += other.camera_rays;
  reflected_rays += other.reflected_rays;
  refracted_rays += other.refracted_rays;
  cut_rays += other.cut_rays;
  dark_pixels += other.dark_pixels;
  antialiased_pixels += other.antialiased_pixels;
  bounds_tests += other.bounds_tests;
  primitive_tests += other.primitive_tests;
  for (const auto& [type, count] : other.tests_by_type) tests_by_type[type] += count;
  if (lights.size() < other.lights.size()) lights.resize(other.lights.size());
  for (std::size_t i = 0; i < other.lights.size(); ++i) lights[i].add(other.lights[i]);
}

void Counters::add_tests(std::string_view type, std::uint64_t number) {
  primitive_tests += number;
  const auto at = tests_by_type.find(type);
  if (at != tests_by_type.end()) {
    at->second += number;
  } else {
    tests_by_type.emplace(type, number);
  }
}

}  // namespace lentray::core
