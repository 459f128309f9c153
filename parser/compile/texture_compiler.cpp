#include "parser/compile/texture_compiler.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/base/memory_stages.h"
#include "core/material/normals.h"
#include "core/material/picture.h"
#include "core/material/pigments.h"
#include "core/material/textures.h"
#include "core/object/uv_warp.h"
#include "parser/compile/density_reader.h"
#include "parser/compile/finish.h"
#include "parser/compile/medium.h"
#include "parser/compile/pattern_compiler.h"
#include "parser/compile/picture_reader.h"

namespace lentray::parser {
namespace {

// +Q: where a calculation begins or ends (measured on stock: image.quality).
constexpr int kUnlitQuality = 1;
constexpr int kQuickColourQuality = 5;
constexpr int kNormalQuality = 8;
constexpr int kMediaQuality = 9;

/// The pigment's own colour, whatever the light.
std::shared_ptr<const core::Finish> unlit_finish() {
  core::Finish finish;
  finish.ambient = {};
  finish.emission = core::Rgb(1.0f);
  finish.diffuse = 0.0;
  return std::make_shared<const core::Finish>(finish);
}

/// The space of texture coordinates, wherever the pattern lies.
core::Placement uv_placement() { return core::Placement({core::make_uv_warp()}); }

core::Colour first_colour(const PigmentDesc& pigment) {
  return pigment.colour_map ? pigment.colour_map->entries.front().item : pigment.colour;
}

/// Where a plain texture is looked for.
std::uint8_t place_of(const core::Colour& colour, const core::Finish* finish) {
  auto mixed = static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(finish));
  for (const float x : {colour.rgb.r, colour.rgb.g, colour.rgb.b, colour.filter, colour.transmit}) {
    mixed = (mixed ^ std::bit_cast<std::uint32_t>(x)) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 32;
  }
  return static_cast<std::uint8_t>(mixed);
}

/// What a description was compiled to. Holds the description, so that its address stays its own.
template <typename Desc, typename Compiled>
class Cache {
 public:
  /// One to which only who asks refers is not kept: nobody will ask for it again.
  template <typename Compile>
  std::shared_ptr<const Compiled> get(const Ref<Desc>& desc, Compile compile) {
    return desc.use_count() == 1 ? compile() : get_of_shared(desc, compile);
  }
  /// Of a description whose owner several may share.
  template <typename Compile>
  std::shared_ptr<const Compiled> get_of_shared(const Ref<Desc>& desc, Compile compile) {
    const auto found = m_entries.find(desc.get());
    if (found != m_entries.end()) return found->second.second;
    auto compiled = compile();
    m_entries.emplace(desc.get(), std::pair(desc, compiled));
    m_new.push_back(desc.get());
    return compiled;
  }
  /// Of those that are new since the last call.
  void forget_unused() {
    for (const Desc* desc : m_new) {
      const auto found = m_entries.find(desc);
      if (found->second.first.use_count() == 1) m_entries.erase(found);
    }
    m_new.clear();
  }

 private:
  std::unordered_map<const Desc*, std::pair<Ref<Desc>, std::shared_ptr<const Compiled>>> m_entries;
  std::vector<const Desc*> m_new;
};

/// How much memory textures take, as the allocator has it. It takes its time to say, so the first few are measured
/// and the others count as their mean.
class TextureBytes {
 public:
  /// What `make` makes; `pictures` are its bytes that do not count.
  template <typename Make, typename Pictures>
  auto count(Make make, Pictures pictures) {
    if (++m_count > kMeasured) return make();
    const std::uint64_t pictures_before = pictures(), before = core::heap_bytes();
    auto made = make();
    const std::uint64_t more = core::heap_bytes_since(before);
    m_bytes += more - std::min(more, pictures() - pictures_before);
    return made;
  }
  std::uint64_t all() const {
    return m_count > kMeasured ? m_bytes / kMeasured * m_count : m_bytes;
  }

 private:
  static constexpr std::uint64_t kMeasured = 256;
  std::uint64_t m_count = 0, m_bytes = 0;
};

/// A map with its entries compiled.
template <typename Map, typename Compile = std::identity>
auto compiled_map(const Map& map, Compile compile = {}) {
  std::vector<std::pair<double, std::decay_t<decltype(compile(map.entries.front().item))>>> entries;
  for (const auto& entry : map.entries) entries.emplace_back(entry.value, compile(entry.item));
  return core::BlendMap(std::move(entries));
}
/// The same for all that have the map.
template <typename Map, typename Item, typename... Compile>
core::BlendMap<Item> shared_map(Cache<Map, core::BlendMap<Item>>& known, const Ref<Map>& map,
                                Compile... compile) {
  return *known.get(map, [&] {
    return std::make_shared<const core::BlendMap<Item>>(compiled_map(*map, compile...));
  });
}

}  // namespace

struct TextureCompiler::Impl {
  TextureSettings settings;
  std::set<std::string> not_yet;
  bool has_crand = false, has_subsurface = false;
  Ref<FinishDesc> too_opaque;
  PictureReader pictures;
  PatternBuild build;
  Cache<TextureDesc, core::Texture> textures;
  Cache<PigmentDesc, core::Pigment> pigments;
  Cache<NormalDesc, core::NormalPerturbation> normals;
  Cache<FinishDesc, core::Finish> finishes;
  Cache<MediaDesc, core::Medium> media;
  // What is moved has a description of its own and shares its map.
  Cache<ColourMapDesc, core::BlendMap<core::Colour>> colour_maps;
  Cache<PigmentMapDesc, core::BlendMap<core::PigmentPtr>> pigment_maps;
  Cache<NormalMapDesc, core::BlendMap<core::NormalPtr>> normal_maps;
  Cache<SlopeMapDesc, core::BlendMap<core::SlopePoint>> slope_maps;
  Cache<TextureMapDesc, core::BlendMap<core::TexturePtr>> texture_maps;
  Cache<DensityMapDesc, PigmentMapDesc> density_maps;
  std::map<std::string, std::shared_ptr<const core::DensityGrid>> density_grids;  ///< by path
  std::vector<core::TexturePtr> made;  ///< all that was asked for
  TextureBytes bytes;
  /// Some of the plain textures that were made: most scenes have few, on many objects.
  struct Plain {
    core::Colour colour;
    std::shared_ptr<const core::Finish> finish;
    core::TexturePtr made;
  };
  std::array<Plain, 256> plain;

  explicit Impl(const TextureSettings& s)
      : settings(s),
        pictures(not_yet), build{settings, not_yet,
                                 [this](const Ref<PigmentDesc>& p) { return compile_of_shared(p); },
                                 [this](const ImageDesc& image) {
                                   return pictures.get(image, false);
                                 },
                                 [this](const FoundFile& file) { return density_grid(file); }} {}

  /// Whether it is one colour everywhere, as most are.
  bool is_plain(const TextureDesc& texture) const {
    return settings.quality > kQuickColourQuality && texture.layers.size() == 1 &&
           texture.layers.front().is_plain();
  }

  template <typename Make>
  core::TexturePtr counted(Make make) {
    made.push_back(bytes.count(make, [this] { return pictures.bytes(); }));
    return made.back();
  }

  core::TexturePtr compile_plain(const TextureLayerDesc& layer) {
    const core::Colour& colour = layer.pigment->colour;
    auto finish = compile(layer.finish);
    Plain& same = plain[place_of(colour, finish.get())];
    if (!same.made || same.finish != finish || same.colour != colour) {
      same.made = counted([&]() -> core::TexturePtr {
        std::vector<core::TextureLayer> one{{core::make_plain_pigment(colour), finish}};
        return std::make_shared<core::LayeredTexture>(std::move(one));
      });
      same.colour = colour;
      same.finish = std::move(finish);
    }
    return same.made;
  }

  core::PigmentPtr compile(const Ref<PigmentDesc>& pigment) {
    return pigments.get(pigment, [&] { return compile_fresh(*pigment); });
  }
  /// Of a pattern, which what has been moved shares.
  core::PigmentPtr compile_of_shared(const Ref<PigmentDesc>& pigment) {
    return pigments.get_of_shared(pigment, [&] { return compile_fresh(*pigment); });
  }
  core::BlendMap<core::PigmentPtr> compile(const Ref<PigmentMapDesc>& map) {
    return shared_map(pigment_maps, map, [&](const Ref<PigmentDesc>& p) { return compile(p); });
  }

  core::PigmentPtr compile_density(const DensityDesc& density) {
    return compile_fresh(as_pigment(density, [this](const Ref<DensityMapDesc>& map) {
      return density_maps.get(map, [&] { return as_pigment_map(*map); });
    }));
  }
  std::shared_ptr<const core::DensityGrid> density_grid(const FoundFile& file) {
    std::shared_ptr<const core::DensityGrid>& grid = density_grids[file.path];
    if (!grid) grid = read_density_file(file);
    return grid;
  }

  core::PigmentPtr compile_fresh(const PigmentDesc& pigment) {
    if (settings.quality <= kQuickColourQuality && pigment.quick_colour) {
      return core::make_plain_pigment(*pigment.quick_colour);
    }
    const PatternDesc& pattern = pigment.pattern;
    if (pattern.kind == PatternKind::kPlain) return core::make_plain_pigment(pigment.colour);
    if (pattern.kind == PatternKind::kImageMap) {
      return core::make_picture_pigment(compile_placement(pattern),
                                        pictures.get(*pattern.own->image, true));
    }
    if (pattern.kind == PatternKind::kUvMapping) {
      if (!pigment.pigment_map) return core::make_plain_pigment(first_colour(pigment));
      return core::make_placed_pigment(uv_placement(),
                                       compile(pigment.pigment_map).items().front());
    }
    if (pattern.kind == PatternKind::kAverage) {
      return core::make_average_pigment(compile_placement(pattern), compile(pigment.pigment_map));
    }
    core::PlacedPattern placed = compile_placed(pattern, build);
    if (pigment.pigment_map) {
      return core::make_pigment_map_pigment(std::move(placed), compile(pigment.pigment_map));
    }
    if (!pigment.colour_map) {
      return core::make_colour_map_pigment(std::move(placed), default_colours(pattern.kind));
    }
    return core::make_colour_map_pigment(std::move(placed),
                                         shared_map(colour_maps, pigment.colour_map));
  }

  core::NormalPtr compile(const Ref<NormalDesc>& normal) {
    if (!normal || settings.quality < kNormalQuality) return nullptr;
    return normals.get(normal, [&] { return compile_fresh(*normal); });
  }
  core::BlendMap<core::NormalPtr> compile(const Ref<NormalMapDesc>& map) {
    return shared_map(normal_maps, map, [&](const Ref<NormalDesc>& n) { return compile(n); });
  }

  core::DisplacementPtr compile_displacement(const NormalDesc& normal) {
    const PatternDesc& p = normal.pattern;
    const double amount = single(normal.amount);
    switch (p.kind) {
      case PatternKind::kBumps: return core::make_bumps_displacement(amount);
      case PatternKind::kDents:
        return core::make_dents_displacement(amount, noise_generator(p, settings));
      case PatternKind::kWrinkles: return core::make_wrinkles_displacement(amount);
      case PatternKind::kRipples:
        return core::make_ripples_displacement(amount, settings.number_of_waves,
                                               single(p.frequency), single(p.phase));
      case PatternKind::kWaves:
        return core::make_waves_displacement(amount, settings.number_of_waves, single(p.frequency),
                                             single(p.phase));
      case PatternKind::kQuilted:
        return core::make_quilted_displacement(amount, single(p.own->quilt0),
                                               single(p.own->quilt1));
      case PatternKind::kFacets:
        return core::make_facets_displacement(p.own->facets_size, p.own->facets_coords,
                                              p.own->facets_metric);
      case PatternKind::kBumpMap:
        return core::make_picture_displacement(pictures.get(*p.own->image, false), amount,
                                               p.own->image->use == ImageDesc::Use::kIndex);
      default: return nullptr;
    }
  }

  core::NormalPtr compile_pattern_normal(const NormalDesc& normal) {
    const bool keep = normal.no_bump_scale;
    if (auto displacement = compile_displacement(normal)) {
      return core::make_displaced_normal(compile_placement(normal.pattern), std::move(displacement),
                                         keep);
    }
    std::optional<core::BlendMap<core::SlopePoint>> slopes;
    if (normal.slope_map) slopes = shared_map(slope_maps, normal.slope_map);
    return core::make_slope_normal(compile_placed(normal.pattern, build), single(normal.amount),
                                   single(normal.accuracy), std::move(slopes), keep);
  }

  core::NormalPtr compile_fresh(const NormalDesc& normal) {
    const PatternDesc& pattern = normal.pattern;
    if (pattern.kind == PatternKind::kPlain) return nullptr;
    if (pattern.kind == PatternKind::kUvMapping) {
      if (!normal.normal_map) return nullptr;
      auto inner = compile(normal.normal_map).items().front();
      return inner ? core::make_placed_normal(uv_placement(), std::move(inner), false) : nullptr;
    }
    if (!normal.normal_map) return compile_pattern_normal(normal);
    if (pattern.kind == PatternKind::kAverage) {
      return core::make_average_normal(compile_placement(pattern), compile(normal.normal_map),
                                       normal.no_bump_scale);
    }
    return core::make_normal_map(compile_placed(pattern, build), compile(normal.normal_map),
                                 normal.no_bump_scale);
  }

  std::shared_ptr<const core::Finish> compile(const Ref<FinishDesc>& finish) {
    return finishes.get(finish, [&] {
      auto compiled = std::make_shared<const core::Finish>(
          compile_finish(*finish, settings.least_translucency));
      if (compiled->subsurface) {
        has_subsurface = true;
        const bool is_as_written =
            compiled->subsurface->translucency == finish->subsurface->translucency;
        if (!too_opaque && !is_as_written) too_opaque = finish;
      }
      has_crand = has_crand || compiled->crand > 0.0;
      return compiled;
    });
  }

  core::TextureLayer compile_layer(const TextureLayerDesc& layer) {
    core::TextureLayer result;
    result.pigment = compile(layer.pigment);
    result.finish = compile(layer.finish);
    result.normal = compile(layer.normal);
    // A kept scale leaves the length free; the tracer wants it 1.
    if (result.normal && layer.normal->no_bump_scale) {
      result.normal = core::make_placed_normal(core::Placement(), result.normal, false);
    }
    return result;
  }

  core::TexturePtr compile_patterned(const TextureLayerDesc& layer) {
    const PatternDesc& pattern = *layer.pattern;
    const core::BlendMap<core::TexturePtr> map =
        shared_map(texture_maps, layer.map, [&](const Ref<TextureDesc>& t) { return compile(t); });
    switch (pattern.kind) {
      case PatternKind::kUvMapping:
        // Where the point lies does not matter then, but normals follow the transforms.
        return core::make_placed_texture(compile_placement(pattern).then(uv_placement()),
                                         map.items().front());
      case PatternKind::kAverage:
        return core::make_average_texture(compile_placement(pattern), map);
      case PatternKind::kMaterialMap:
        // Numbers of textures are what the file holds, whatever its gamma.
        return core::make_material_map(compile_placement(pattern),
                                       pictures.get(*pattern.own->image, false), map);
      default: return core::make_texture_map(compile_placed(pattern, build), map);
    }
  }

  core::TexturePtr compile(const Ref<TextureDesc>& texture) {
    return textures.get(texture, [&] { return compile_fresh(*texture); });
  }

  core::TexturePtr compile_fresh(const TextureDesc& texture) {
    // A patterned texture is never layered: the grammar refuses it.
    if (texture.layers.back().is_patterned()) return compile_patterned(texture.layers.back());
    std::vector<core::TextureLayer> layers;
    if (settings.quality <= kUnlitQuality) {
      // Of layers stock shows the bottom one.
      auto pigment = core::make_opaque_pigment(compile(texture.layers.front().pigment));
      layers.push_back({std::move(pigment), unlit_finish(), nullptr});
      return std::make_shared<core::LayeredTexture>(std::move(layers));
    }
    for (const TextureLayerDesc& layer : texture.layers) layers.push_back(compile_layer(layer));
    return std::make_shared<core::LayeredTexture>(std::move(layers));
  }
};

TextureCompiler::TextureCompiler(const TextureSettings& settings)
    : m_impl(std::make_unique<Impl>(settings)) {}
TextureCompiler::~TextureCompiler() = default;

std::shared_ptr<const core::Texture> TextureCompiler::texture(const Ref<TextureDesc>& texture,
                                                              const Ref<TextureDesc>& fallback) {
  const Ref<TextureDesc>& desc = texture ? texture : fallback;
  if (m_impl->is_plain(*desc)) return m_impl->compile_plain(desc->layers.front());
  return m_impl->textures.get(
      desc, [&] { return m_impl->counted([&] { return m_impl->compile_fresh(*desc); }); });
}

std::vector<core::TexturePtr> TextureCompiler::take_textures() { return std::move(m_impl->made); }

void TextureCompiler::forget_unused() {
  // What refers to others comes before them.
  m_impl->textures.forget_unused();
  m_impl->texture_maps.forget_unused();
  m_impl->pigments.forget_unused();
  m_impl->pigment_maps.forget_unused();
  m_impl->normals.forget_unused();
  m_impl->normal_maps.forget_unused();
  m_impl->slope_maps.forget_unused();
  m_impl->finishes.forget_unused();
  m_impl->colour_maps.forget_unused();
}

std::shared_ptr<const core::Pigment> TextureCompiler::pigment(const Ref<PigmentDesc>& pigment) {
  return m_impl->compile(pigment);
}

std::shared_ptr<const core::NormalPerturbation> TextureCompiler::normal(
    const Ref<NormalDesc>& normal) {
  return m_impl->compile(normal);
}

std::shared_ptr<const core::Interior> TextureCompiler::interior(const Ref<InteriorDesc>& interior,
                                                                const Ref<TextureDesc>& texture) {
  const auto made = compile_interior(interior, texture);
  if (made && interior) {
    for (const Ref<MediaDesc>& one : interior->media) {
      if (auto compiled = medium(one)) made->media.push_back(std::move(compiled));
    }
  }
  return made;
}

std::shared_ptr<const core::Medium> TextureCompiler::medium(const Ref<MediaDesc>& medium) {
  if (m_impl->settings.quality < kMediaQuality) return nullptr;
  return m_impl->media.get(medium, [&] {
    return compile_medium(*medium, m_impl->settings.media, [this](const DensityDesc& density) {
      return m_impl->compile_density(density);
    });
  });
}

bool TextureCompiler::has_subsurface() const { return m_impl->has_subsurface; }
std::uint64_t TextureCompiler::picture_bytes() const { return m_impl->pictures.bytes(); }
std::uint64_t TextureCompiler::texture_bytes() const { return m_impl->bytes.all(); }
const FinishDesc* TextureCompiler::too_opaque() const { return m_impl->too_opaque.get(); }
const std::set<std::string>& TextureCompiler::not_yet() const { return m_impl->not_yet; }
bool TextureCompiler::has_crand() const { return m_impl->has_crand; }

}  // namespace lentray::parser
