#include "tests/fuzz/file_input.h"

#include <limits>
#include <memory>
#include <string_view>
#include <utility>

#include "core/base/memory_limit.h"
#include "core/trace/integrator.h"
#include "core/trace/thread_context.h"
#include "parser/read_scene.h"
#include "shadow/tester_factory.h"
#include "tests/fuzz/input_file.h"

namespace lentray::test {
namespace {

using namespace std::literals;
using core::Vec3;

struct Kind {
  std::string_view head, word;
};
constexpr Kind kPictures[] = {{"\x89PNG\r\n\x1a\n"sv, "png"},
                              {"GIF8"sv, "gif"},
                              {"\xff\xd8"sv, "jpeg"},
                              {"BM"sv, "sys"},
                              {"P6"sv, "ppm"},
                              {"P5"sv, "pgm"},
                              {"II*\0"sv, "tiff"},
                              {"MM\0*"sv, "tiff"},
                              {"v/1\1"sv, "exr"},
                              {"#?RADIANCE"sv, "hdr"},
                              {""sv, "tga"}};
constexpr std::string_view kFonts[] = {"\0\1\0\0"sv, "OTTO"sv, "true"sv, "ttcf"sv};

class SceneFiles final : public parser::Files {
 public:
  explicit SceneFiles(std::string scene) : m_scene(std::move(scene)) {}
  bool exists(const std::string& path) const override { return parser::disk_files().exists(path); }
  std::optional<std::string> find_loosely(const std::string&, const std::string&) const override {
    return std::nullopt;
  }
  std::optional<std::string> read(const std::string& path) const override {
    return parser::disk_files().read(path);
  }
  std::optional<std::string> read_scene(const std::string&) const override { return m_scene; }
  bool may_write(const std::string&) const override { return false; }
  std::unique_ptr<parser::FileWriter> open(const std::string&, bool) override { return nullptr; }

 private:
  std::string m_scene;
};

void trace(const core::Scene& scene) {
  core::ThreadContext context(scene, false);
  const auto testers = shadow::make_tester_factory("off");
  const auto tester = testers->make(context);
  core::Integrator integrator(context, *tester);
  constexpr int kSide = 8;
  for (int k = 0; k < kSide * kSide; ++k) {
    const Vec3 along{(k % kSide + 0.5) / kSide - 0.5, (k / kSide + 0.5) / kSide - 0.5, 1.0};
    integrator.trace({{0, 0, -2}, normalized(along)}, {});
  }
}

struct MemoryLimit {
  MemoryLimit() { core::limit_memory(1024.0 * 1024.0 * 1024.0); }
  ~MemoryLimit() { core::limit_memory(std::numeric_limits<double>::infinity()); }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
};

/// The message, if one ends it.
std::string use(std::string text) {
  const MemoryLimit limit;
  SceneFiles files(std::move(text));
  parser::SourceManager sources(files);
  parser::Diagnostics diagnostics(sources);
  for (std::size_t i = 0; i < parser::kStreams; ++i)
    diagnostics.connect(static_cast<parser::Stream>(i), {});
  try {
    trace(core::Scene(parser::read_scene("scene.pov", sources, diagnostics, {}).parts, {}));
  } catch (const parser::ParseError& error) {
    return error.message();
  }
  return {};
}

constexpr const char* kLight = "light_source { <5, 5, -10>, rgb 1 }\n";

}  // namespace

std::string use_picture(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Kind* kind = kPictures;
  while (!bytes.starts_with(kind->head)) ++kind;
  const InputFile file(data, size);
  const std::string image = std::string(kind->word) + ' ' + file.quoted();
  return use(kLight + ("plane { z, 3 pigment { image_map { " + image +
                       " interpolate 2 } } normal { bump_map { " + image +
                       " bump_size 2 } } }\nheight_field { " + image +
                       " translate -0.5 pigment { image_pattern { " + image +
                       " } } }\nsphere { 0, 0.3 texture { material_map { " + image +
                       " texture { pigment { rgb x } } texture { pigment { rgb y } } } } }\n"));
}

std::string use_data(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const InputFile file(data, size);
  for (const std::string_view head : kFonts) {
    if (!bytes.starts_with(head)) continue;
    return use(kLight +
               ("text { ttf " + file.quoted() +
                " \"aB&g%\" 0.4, <0.01, 0, 0> scale 0.6 translate -x pigment { rgb 1 } }"));
  }
  return use(kLight + ("box { -0.6, 0.6 pigment { density_file df3 " + file.quoted() +
                       " interpolate 1 translate -0.5 } normal { density_file df3 " +
                       file.quoted() + " interpolate 2 } }"));
}

}  // namespace lentray::test
