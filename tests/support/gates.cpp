#include "tests/support/gates.h"

#include <cmath>
#include <string_view>
#include <vector>

#include "core/object/gated.h"
#include "core/scene/scene.h"
#include "parser/compile/scene.h"
#include "parser/read_scene.h"
#include "parser/source/diagnostics.h"
#include "tools/common/process.h"

namespace lentray::test {
namespace {

using core::Vec3;

std::vector<Vec3> directions(const Vec3& eye) {
  const Vec3 ahead = core::normalized(-eye);
  const Vec3 right = core::normalized(core::cross(Vec3{0, 1, 0}, ahead));
  const Vec3 up = core::cross(ahead, right);
  const double reach = std::tan(40.0 * 3.14159265358979 / 180.0);
  std::vector<Vec3> out;
  for (int row = 0; row < 60; ++row) {
    for (int column = 0; column < 80; ++column) {
      const double x = (column + 0.5) / 40.0 - 1.0, y = 0.75 * (1.0 - (row + 0.5) / 30.0);
      out.push_back(core::normalized(ahead + right * (x * reach) + up * (y * reach)));
    }
  }
  return out;
}

/// Where each ray meets the first surface; infinite where there is none.
std::vector<double> distances(const core::SceneParts& parts, const Vec3& eye, bool open) {
  core::HitLists lists;
  std::vector<double> out;
  for (const Vec3& direction : directions(eye)) {
    core::Hit hit;
    for (const auto& object : parts.objects) {
      const core::Object& asked = open ? core::ungated(*object) : *object;
      asked.nearest({eye, direction}, 1e-6, hit.t, hit,
                    core::RayQuery(lists, core::RayKind::kCamera));
    }
    out.push_back(hit.t);
  }
  return out;
}

}  // namespace

std::size_t rays_that_gates_turn_away(const std::string& sdl, const Vec3& eye) {
  const tool::TemporaryFolder folder;
  tool::write_text(folder / "gates.pov", sdl);
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  for (const parser::Stream s : {parser::Stream::kDebug, parser::Stream::kRender,
                                 parser::Stream::kStatistics, parser::Stream::kWarning}) {
    diagnostics.connect(s, [](std::string_view) {});
  }
  parser::ParserOptions options;
  options.library_paths = {"/usr/share/povray/include", "/usr/share/povray-3.7/include"};
  parser::SceneDesc scene =
      parser::read_descriptions((folder / "gates.pov").string(), sources, diagnostics, options);
  const core::SceneParts parts = parser::build_scene(scene, diagnostics);
  const std::vector<double> gated = distances(parts, eye, false),
                            open = distances(parts, eye, true);
  std::size_t different = 0;
  for (std::size_t i = 0; i < gated.size(); ++i) different += gated[i] != open[i];
  return different;
}

}  // namespace lentray::test
