#include "parser/dump/scene_json.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <map>
#include <type_traits>

#include "parser/dump/field_lists.h"
#include "parser/dump/names.h"

namespace lentray::parser {
namespace {

using Json = nlohmann::ordered_json;

template <typename T, template <typename...> typename Of>
inline constexpr bool kIs = false;
template <typename... Args, template <typename...> typename Of>
inline constexpr bool kIs<Of<Args...>, Of> = true;

Json number(double x) {
  if (std::isnan(x)) return "nan";
  if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
  return x;
}

/// The double whose shortest text is the float's.
Json number(float x) {
  if (!std::isfinite(x)) return number(static_cast<double>(x));
  char text[32];
  *std::to_chars(text, text + sizeof text - 1, x).ptr = '\0';
  return std::strtod(text, nullptr);
}

class Dumper {
 public:
  /// Without sources, locations are left out: so are defaults made.
  explicit Dumper(const SourceManager* sources) : m_sources(sources) {}

  template <typename T>
  Json value(const T& v) {
    if constexpr (std::is_same_v<T, ObjectDesc>)
      return other(v);
    else if constexpr (HasFields<T>)
      return fields(v);
    else if constexpr (std::is_same_v<T, FoundFile>)
      return v.path;
    else if constexpr (std::is_same_v<T, bool> || std::is_integral_v<T> ||
                       std::is_same_v<T, std::string> || std::is_same_v<T, std::string_view>)
      return v;
    else if constexpr (std::is_floating_point_v<T>)
      return number(v);
    else if constexpr (std::is_enum_v<T>)
      return name_of(v);
    else if constexpr (kIs<T, std::optional>)
      return v ? value(*v) : Json();
    else if constexpr (kIs<T, std::shared_ptr>)
      return shared(v);
    else if constexpr (kIs<T, std::variant>)
      return std::visit([this](const auto& shape) { return value(shape); }, v);
    else if constexpr (kIs<T, std::pair>)
      return Json::array({value(v.first), value(v.second)});
    else
      return other(v);
  }

 private:
  Json other(const core::Vec3& v) { return Json::array({number(v.x), number(v.y), number(v.z)}); }
  Json other(const core::Vec2& v) { return Json::array({number(v.u), number(v.v)}); }
  Json other(const core::Rgb& c) { return Json::array({number(c.r), number(c.g), number(c.b)}); }
  Json other(const core::Colour& c) {
    Json out = other(c.rgb);
    out.push_back(number(c.filter));
    out.push_back(number(c.transmit));
    return out;
  }
  Json other(const core::Transform& t) { return t.is_identity() ? Json() : list(t.rows()); }
  Json other(const Location& l) {
    if (!m_sources || l.file == 0) return {};
    return m_sources->place(l);
  }
  Json other(const ObjectDesc& object) {
    if (!object.texture_waits) return fields(object);
    ObjectDesc settled = object;
    settle_texture(settled);
    return fields(settled);
  }
  // No part of what the scene says.
  Json other(const CompiledSlot&) { return {}; }
  Json other(const Nesting&) { return {}; }
  Json other(const LoadedPhotons&) { return {}; }
  template <typename T>
  Json other(const Sparse<T>& v) {
    return value(*v);
  }
  template <typename Item>
  Json other(const BlendEntry<Item>& entry) {
    return Json{{"at", number(entry.value)}, {"is", value(entry.item)}};
  }
  template <typename Item, typename Allocator>
  Json other(const std::vector<Item, Allocator>& items) {
    return list(items);
  }
  template <typename Item, std::size_t kSize>
  Json other(const std::array<Item, kSize>& items) {
    return list(items);
  }

  template <typename Items>
  Json list(const Items& items) {
    Json out = Json::array();
    for (const auto& item : items) out.push_back(value(item));
    return out;
  }

  /// None is -1.
  Json other(const core::MeshTriples& triples) {
    Json out = Json::array();
    for (const auto& [a, b, c] : triples.list) {
      out.push_back({static_cast<std::int32_t>(a), static_cast<std::int32_t>(b),
                     static_cast<std::int32_t>(c)});
    }
    return out;
  }

  Json shared(const std::shared_ptr<const core::TriangleMesh>&) { return {}; }
  Json shared(const Ref<FunctionDesc>& f) {
    if (!f) return {};
    Json out{{"name", f->name}, {"parameters", f->function->parameters()}};
    if (f->function->results() > 1) out["results"] = f->function->results();
    if (f->pigment) out["pigment"] = shared(f->pigment);
    return out;
  }
  /// Copies of a CSG share its parts.
  Json shared(const std::shared_ptr<const Children>& children) {
    if (!children) return {};
    if (children.use_count() == 1) return list(*children);
    const auto [place, fresh] = m_ids.try_emplace(children.get(), m_ids.size() + 1);
    if (!fresh) return Json{{"same_as", place->second}};
    const std::size_t id = place->second;
    return Json{{"id", id}, {"parts", list(*children)}};
  }
  template <typename T>
  Json shared(const std::shared_ptr<const T>& v) {
    if (!v) return {};
    if (v.use_count() == 1) return value(*v);
    const auto [place, fresh] = m_ids.try_emplace(v.get(), m_ids.size() + 1);
    if (!fresh) return Json{{"same_as", place->second}};
    Json out{{"id", place->second}};  // before what it holds, which gets its own
    out.update(value(*v));
    return out;
  }

  template <typename T>
  Json fields(const T& v) {
    static const std::map<std::string, Json> unset = defaults<T>();
    Json out = Json::object();
    Fields<T>::visit(v, [&](const char* name, const auto& member) {
      Json made = value(member);
      if constexpr (std::is_same_v<decltype(member), const Sparse<RareParts>&> ||
                    std::is_same_v<decltype(member), const Sparse<WarpParameters>&> ||
                    std::is_same_v<decltype(member), const core::BlackHole&>)
        return out.update(made);
      if (made != unset.at(name)) out[name] = std::move(made);
    });
    return out;
  }

  template <typename T>
  static std::map<std::string, Json> defaults() {
    std::map<std::string, Json> out;
    Dumper plain(nullptr);
    Fields<T>::visit(
        T{}, [&](const char* name, const auto& member) { out[name] = plain.value(member); });
    return out;
  }

  const SourceManager* m_sources;
  std::map<const void*, std::size_t> m_ids;
};

}  // namespace

nlohmann::ordered_json scene_json(const SceneDesc& scene, const SourceManager& sources) {
  return Dumper(&sources).value(scene);
}

}  // namespace lentray::parser
