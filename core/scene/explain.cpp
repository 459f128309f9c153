#include "core/scene/explain.h"

#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string_view>
#include <vector>

#include "core/accel/hierarchy.h"
#include "core/accel/light_buffer.h"

namespace lentray::core {
namespace {

constexpr int kColumn = 22;

std::ostream& line(std::ostream& out, std::string_view label) {
  return out << "  " << std::left << std::setw(kColumn) << label;
}

/// Comma-separated, broken into lines under the label's column.
void list(std::ostream& out, std::string_view label, const std::vector<std::string>& items) {
  constexpr std::size_t kWidth = 96;
  line(out, label);
  std::size_t used = kColumn + 2;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const std::string text = items[i] + (i + 1 < items.size() ? "," : "");
    if (used + text.size() + 1 > kWidth) {
      out << '\n' << std::string(kColumn + 2, ' ');
      used = kColumn + 2;
    }
    out << text << ' ';
    used += text.size() + 1;
  }
  if (items.empty()) out << "none";
  out << '\n';
}

std::string size_text(std::size_t bytes) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(1);
  if (bytes < 10 * 1024) {
    out << bytes << " bytes";
  } else if (bytes < 10 * 1024 * 1024) {
    out << static_cast<double>(bytes) / 1024.0 << " KiB";
  } else {
    out << static_cast<double>(bytes) / (1024.0 * 1024.0) << " MiB";
  }
  return out.str();
}

void explain_light_buffers(const Scene& scene, std::ostringstream& out) {
  std::size_t buffers = 0, memory = 0;
  LightBuffer::Statistics sum;
  for (std::size_t i = 0; i < scene.lights().size(); ++i) {
    const LightBuffer* buffer = scene.light_buffer(i);
    if (!buffer) continue;
    const LightBuffer::Statistics s = buffer->statistics();
    ++buffers;
    memory += buffer->memory();
    sum.cells += s.cells;
    sum.entries += s.entries;
    sum.dark_cells += s.dark_cells;
  }
  if (buffers == 0) return;
  out << "Light buffers\n";
  line(out, "lights") << buffers << '\n';
  line(out, "cells") << sum.cells << ", " << sum.dark_cells << " of them dark from some way on\n";
  line(out, "objects in cells") << sum.entries << '\n';
  line(out, "memory") << size_text(memory) << '\n';
}

}  // namespace

std::string explain(const Scene& scene) {
  const Needs& needs = scene.needs();
  std::ostringstream out;
  out << "Scene\n";
  line(out, "objects") << scene.objects().size() << " after splitting unions\n";
  std::vector<std::string> primitives;
  for (const auto& [name, count] : needs.primitives) {
    primitives.push_back(std::to_string(count) + " " + name);
  }
  list(out, "primitives", primitives);
  line(out, "lights") << scene.lights().size() << '\n';

  out << "Needs\n";
  std::vector<std::string> present, absent;
  for (const auto& [name, member] : kNeededFeatures) {
    (needs.*member ? present : absent).emplace_back(name);
  }
  list(out, "used", present);
  list(out, "not needed", absent);
  line(out, "trace level") << needs.greatest_depth << " at most (max_trace_level "
                           << scene.settings().max_trace_level << ")\n";

  if (const auto& radiosity = scene.settings().radiosity) {
    line(out, "radiosity") << radiosity->count << " rays a sample, " << radiosity->recursion_limit
                           << (radiosity->recursion_limit == 1 ? " bounce" : " bounces")
                           << ", error_bound " << radiosity->error_bound << '\n';
  }
  if (const auto& photons = scene.settings().photons) {
    line(out, "photons");
    if (photons->count > 0) {
      out << "count " << photons->count;
    } else {
      out << "spacing " << photons->spacing;
    }
    out << ", gather " << photons->gather_min << " to " << photons->gather_max << '\n';
  }
  if (const auto& subsurface = scene.settings().subsurface; subsurface && needs.subsurface) {
    line(out, "subsurface light") << subsurface->samples_diffuse << " and "
                                  << subsurface->samples_single << " samples\n";
  }

  const Hierarchy::Statistics shape = scene.hierarchy().statistics();
  const bool tree = shape.nodes > 0 || shape.objects == shape.infinite;
  out << (tree ? "Bounding hierarchy\n" : shape.cells > 0 ? "Grid\n" : "List\n");
  line(out, "bounded objects") << shape.objects - shape.infinite << '\n';
  line(out, "infinite objects") << shape.infinite << '\n';
  if (tree) {
    line(out, "nodes of 8 boxes") << shape.nodes << ", depth " << shape.depth << '\n';
    line(out, "leaves") << shape.leaves << '\n';
  } else if (shape.cells > 0) {
    line(out, "cells") << shape.cells << ", objects in them " << shape.entries << '\n';
  }
  line(out, "memory") << size_text(scene.hierarchy().memory()) << '\n';
  explain_light_buffers(scene, out);
  return out.str();
}

}  // namespace lentray::core
