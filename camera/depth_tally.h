// What the rays of a depth survey (camera/depth_survey.h) met, added up: by object, and for the whole
// picture. The same looks in the same order give the same survey. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "camera/depth_survey.h"
#include "camera/lenticular.h"
#include "camera/scene_probe.h"

namespace lentray::camera {

/// The first thing that a pixel's ray meets.
struct SheetLook {
  std::int64_t column = 0;
  bool is_dark = false;           ///< the lens shows nothing there
  std::optional<ProbeHit> hit{};  ///< empty: the background
  PlanPoint point{};              ///< of the hit
};

class DepthTally {
 public:
  explicit DepthTally(const Lenticular& sheet);

  /// A look that extends what is known of its object.
  void add(const SheetLook& look);
  /// The same of one that stands for a share of the picture.
  void count(const SheetLook& look);
  /// All but is_whole. Nothing can be added behind it.
  DepthSurvey survey();

 private:
  struct Gathered {
    SeenObject object;
    std::uint64_t pixels = 0;
    std::size_t crowd = 512;  ///< points of the outline from which on those inside are dropped
  };
  std::size_t index_of(const ProbeHit& hit);
  void extend(const PlanPoint& point, double bend, Gathered& gathered);

  const Lenticular& m_sheet;
  const std::vector<double> m_bends;  ///< by column
  DepthSurvey m_out;
  std::vector<Gathered> m_gathered;
  std::unordered_map<const void*, std::size_t> m_by_id;
  std::map<std::string, std::size_t> m_by_name;
  std::vector<double> m_depths;  ///< of the pixels that count
  std::uint64_t m_counted = 0, m_open = 0;
};

}  // namespace lentray::camera
