// Builds light buffers, one after the other: its storage is used again. One a thread.
// World space. Borrows the casters.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "core/accel/light_buffer.h"
#include "core/accel/light_casters.h"
#include "core/accel/light_drawing.h"

namespace lentray::core {

class LightBufferBuilder {
 public:
  /// `tolerance`: as LightBuffer's.
  LightBufferBuilder(const LightCasters& casters, double tolerance)
      : m_all(casters), m_tolerance(tolerance) {}
  /// Into a buffer that has only its light.
  void build(LightBuffer& buffer, std::uint32_t cells);

 private:
  using Entry = LightBuffer::Entry;
  using Grid = LightBuffer::Grid;
  /// `box` is relative to the light.
  struct Placed {
    LightBuffer::Caster caster;
    Bounds box;
    double distance;
  };
  struct Shown {  ///< a caster on a face
    std::uint32_t caster;
    LightWindow window;
  };
  struct Found {  ///< an entry with its cell
    std::uint32_t cell;
    Entry entry;
  };
  struct Dark {  ///< of a cell
    float full_w = std::numeric_limits<float>::infinity();
    std::uint32_t cover = 0;  ///< what blocks all beyond
  };

  void place(const LightCaster& caster);
  bool is_crowd(std::uint32_t cells) const;
  void add_grids(int face, std::uint32_t cells);
  void fill(Grid& grid);
  void keep(Grid& grid);
  void sort_cell(Entry* first, Entry* last) const;
  static LightDrawing::Subject subject_of(const Placed& placed) {
    return {*placed.caster.object, placed.caster.shape, placed.caster.kind, placed.box,
            placed.distance};
  }

  const LightCasters& m_all;
  const double m_tolerance;
  LightBuffer* m_buffer = nullptr;  ///< that is being built
  LightDrawing m_drawing{{}};
  std::vector<Placed> m_placed;
  std::vector<std::uint8_t> m_drawn;  ///< of the casters: has its volume
  std::vector<Entry> m_entries;
  // Of the face and the grid that are being filled.
  std::vector<Shown> m_shown;
  std::vector<LightCell> m_touched;
  std::vector<Found> m_found;
  std::vector<Dark> m_dark;
  std::vector<Entry> m_sorted;
  std::vector<std::uint32_t> m_next;
};

}  // namespace lentray::core
