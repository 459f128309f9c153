// The directions of a light, cut into cells: points that the light sees next to each other most
// often have the same blocker, wherever the picture shows them. See cache_policy.h.
#pragma once

#include <cstdint>
#include <vector>

#include "shadow/cache_policy.h"

namespace lentray::shadow {

/// Three sizes of cells, each with the blocker found last in it, the last of the place in the ray
/// tree, and the four neighbours of the cell of the middle size. Cells are hashed into a table a light: a collision costs a probe.
class DirectionPolicy {
 public:
  static constexpr std::string_view kName = "grid";
  static constexpr std::size_t kProbes = 6;
  explicit DirectionPolicy(const core::Scene& scene);
  std::size_t slots() const { return m_lights.size() * kEach; }
  /// The cells about the direction alone, the finest first.
  Keys<3> cells(const core::ShadowQuery& query) const {
    const Place place = place_of(query);
    return {cell(query, place, kFine), cell(query, place, kMiddle), cell(query, place, kCoarse)};
  }
  Keys<8> keys(const core::ShadowQuery& query) const {
    const Place place = place_of(query);
    const auto beside = [&](double du, double dv) {
      const double step = 2.0 / kMiddle;
      return cell(query, {place.face, place.u + du * step, place.v + dv * step}, kMiddle);
    };
    return {cell(query, place, kFine),
            cell(query, place, kMiddle),
            tree(query),
            cell(query, place, kCoarse),
            beside(-1, 0),
            beside(1, 0),
            beside(0, -1),
            beside(0, 1)};
  }
  Keys<4> homes(const core::ShadowQuery& query) const {
    const Place place = place_of(query);
    return {cell(query, place, kFine), cell(query, place, kMiddle), tree(query),
            cell(query, place, kCoarse)};
  }

 private:
  static constexpr std::size_t kCells = 1 << 18;  ///< slots of a light for cells
  static constexpr std::size_t kEach = kCells + core::kTreePlaces;
  /// Cells along a face of the cube; of the sizes tried those with the most hits on balls.
  static constexpr double kFine = 1024.0, kMiddle = 384.0, kCoarse = 96.0;

  /// A direction as a face of the cube about the light, and -1..1 along it.
  struct Place {
    std::uint32_t face = 0;
    double u = 0.0, v = 0.0;
  };
  /// A light amid the objects looks through the faces of a cube, one far away through a window as
  /// large as they are. Rays of a parallel light differ by where they pass.
  enum class Kind : std::uint8_t { kCube, kWindow, kParallel };
  struct LightFrame {
    Kind kind = Kind::kCube;
    core::Vec3 along;       ///< unit, to the light
    core::Vec3 across, up;  ///< so long that -1 to 1 spans the objects
  };

  Place place_of(const core::ShadowQuery& query) const;
  static std::size_t cell(const core::ShadowQuery& query, const Place& place, double cells) {
    // A cell beyond the border for its neighbours.
    const auto i = static_cast<std::uint64_t>((place.u + 1.0) * 0.5 * cells + 1.0);
    const auto k = static_cast<std::uint64_t>((place.v + 1.0) * 0.5 * cells + 1.0);
    // Four by four cells side by side in memory.
    std::uint64_t key =
        (i / 4 * 1024u + k / 4) * 6u + place.face + static_cast<std::uint64_t>(cells);
    key = (key * 0x9e3779b97f4a7c15ull >> 50) * 16u + i % 4 * 4 + k % 4;
    return query.light * kEach + static_cast<std::size_t>(key);
  }
  static std::size_t tree(const core::ShadowQuery& query) {
    return query.light * kEach + kCells + query.tree_place;
  }

  std::vector<LightFrame> m_lights;
};

}  // namespace lentray::shadow
