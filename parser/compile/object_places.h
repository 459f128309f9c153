// Where the objects of a scene's list stand in its text, and what people call them.
// Errors: none. One thread.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/source/source.h"

namespace lentray::core {
class Object;
}

namespace lentray::parser {

struct ObjectPlace {
  Location where;
  std::string_view keyword;  ///< of its statement; a reserved word
};

struct ObjectPlaces {
  /// In the order of core::SceneParts::objects, which core::Object::whole() counts.
  std::vector<ObjectPlace> wholes;
  /// Parts of unions that the scene is split at. Those of one from an identifier have its place.
  std::vector<std::pair<const core::Object*, ObjectPlace>> parts;

  /// To be called once the scene is built, before place_of().
  void sort_parts();
  /// Null: not known. `id`: the object; `whole`: its number.
  const ObjectPlace* place_of(const void* id, std::size_t whole) const;
};

/// "sphere at scene.pov:12:1"; "Chair at scene.pov:30:1" of `object { Chair }`.
std::string object_name(const ObjectPlace& place, const SourceManager& sources);

}  // namespace lentray::parser
