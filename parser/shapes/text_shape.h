// text { ttf ... }: the outlines and places of its glyphs. One em is one unit, baseline on the x axis,
// the first glyph's left edge at x = 0. Space: object.
// Source: reference manual 3.7, "Text"; spacing compared with stock by tests/image/shapes_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/vec3.h"
#include "core/shape/outline.h"
#include "parser/descriptions/object.h"

namespace lentray::parser {

struct PlacedGlyph {
  std::shared_ptr<const core::Outline> outline;  ///< null: a blank, nothing to see
  core::Vec3 offset;
  core::Vec2 lo,
      hi;  ///< the box that the font gives the glyph, offset included; a blank's is a point
};

/// Keeps the fonts it has opened, with the outlines of their glyphs: texts share them. One thread.
class TextLayout {
 public:
  TextLayout();
  ~TextLayout();
  /// Throws std::runtime_error if the font cannot be read.
  std::vector<PlacedGlyph> place(const TextShape& text);

 private:
  class Font;
  std::map<std::string, std::unique_ptr<Font>> m_fonts;  ///< by path
};

}  // namespace lentray::parser
