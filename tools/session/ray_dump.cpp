#include "tools/session/ray_dump.h"

#include <cstdio>
#include <optional>

#include "core/image/file_swap.h"
#include "core/image/open_file.h"
#include "core/image/writer.h"

namespace lentray::tool {
namespace {

void dump_ray(const camera::Camera& camera, std::uint32_t column, std::uint32_t row,
              std::uint32_t index, std::FILE* out) {
  core::Ray r;
  const core::PixelPlace centre{.column = static_cast<std::int32_t>(column),
                                .row = static_cast<std::int32_t>(row)};
  const bool shows =
      camera.rays_a_place() > 1
          ? camera.one_ray_at(centre, camera.ray_of(camera.eye_place(column, row), index), r)
          : camera.ray(column + 0.5, row + 0.5, r);
  if (!shows) {
    std::fprintf(out, "%u %u dark\n", column, row);
    return;
  }
  std::fprintf(out, "%u %u %.17g %.17g %.17g %.17g %.17g %.17g\n", column, row, r.origin.x,
               r.origin.y, r.origin.z, r.direction.x, r.direction.y, r.direction.z);
}

}  // namespace

void dump_rays(const camera::Camera& camera, const std::string& path) {
  std::optional<core::FileSwap> swap;
  std::FILE* out = stdout;
  core::OpenFile owned;
  if (path != "-") {
    swap.emplace(path);
    owned.reset(std::fopen(swap->temporary().c_str(), "w"));
    if (!owned) throw core::ImageError("cannot write '" + path + "'");
    out = owned.get();
  }
  std::fprintf(out,
               "# lentray rays, camera %s, %u x %u pixels\n"
               "# column row  origin x y z  unit direction x y z | column row dark\n",
               std::string(camera.name()).c_str(), camera.width(), camera.height());
  for (std::uint32_t row = 0; row < camera.height(); ++row) {
    for (std::uint32_t column = 0; column < camera.width(); ++column) {
      for (std::uint32_t index = 0; index < camera.rays_a_place(); ++index) {
        dump_ray(camera, column, row, index, out);
      }
    }
  }
  const bool failed = std::fflush(out) != 0 || std::ferror(out) != 0;
  if (failed) throw core::ImageError("cannot write '" + path + "': no space, or the disk failed");
  owned.reset();
  if (swap) swap->commit();
}

}  // namespace lentray::tool
