#include "parser/build/text_shape.h"

#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

namespace lentray::parser {
namespace {

using core::CurvePiece;
using core::Vec2;

class FontFile {
 public:
  explicit FontFile(const std::string& path) {
    if (FT_Init_FreeType(&m_library) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Face(m_library, path.c_str(), 0, &m_face) != 0) {
      FT_Done_FreeType(m_library);
      throw std::runtime_error("cannot read the font '" + path + "'");
    }
    select_character_map();
  }
  ~FontFile() {
    FT_Done_Face(m_face);
    FT_Done_FreeType(m_library);
  }
  FontFile(const FontFile&) = delete;
  FontFile& operator=(const FontFile&) = delete;
  FT_Face face() const { return m_face; }

 private:
  /// Macintosh Roman before Unicode, as stock prefers for plain text.
  void select_character_map() {
    static constexpr std::array<std::pair<int, int>, 4> kPreferred{{{1, 0}, {3, 1}, {0, 3}, {3, 0}}};
    for (const auto& [platform, encoding] : kPreferred) {
      for (int i = 0; i < m_face->num_charmaps; ++i) {
        const FT_CharMap map = m_face->charmaps[i];
        if (map->platform_id == platform && map->encoding_id == encoding) {
          FT_Set_Charmap(m_face, map);
          return;
        }
      }
    }
  }

  FT_Library m_library = nullptr;
  FT_Face m_face = nullptr;
};

/// Collects the curves of an outline in ems.
struct Collector {
  double em = 1.0;
  std::vector<CurvePiece> pieces;
  Vec2 first, last;

  Vec2 point(const FT_Vector* p) const {
    return {static_cast<double>(p->x) / em, static_cast<double>(p->y) / em};
  }
  void close() {
    if (!(last == first)) pieces.push_back(CurvePiece::line(last, first));
    last = first;
  }
  static Collector& of(void* user) { return *static_cast<Collector*>(user); }
  static int move(const FT_Vector* to, void* user) {
    of(user).close();
    of(user).first = of(user).last = of(user).point(to);
    return 0;
  }
  static int line(const FT_Vector* to, void* user) {
    Collector& c = of(user);
    const Vec2 end = c.point(to);
    if (!(end == c.last)) c.pieces.push_back(CurvePiece::line(c.last, end));
    c.last = end;
    return 0;
  }
  static int conic(const FT_Vector* control, const FT_Vector* to, void* user) {
    Collector& c = of(user);
    c.pieces.push_back(CurvePiece::conic(c.last, c.point(control), c.point(to)));
    c.last = c.point(to);
    return 0;
  }
  static int cubic(const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
    Collector& c = of(user);
    c.pieces.push_back(CurvePiece::bezier(c.last, c.point(a), c.point(b), c.point(to)));
    c.last = c.point(to);
    return 0;
  }
};

std::shared_ptr<const core::Outline> outline_of(FT_GlyphSlot glyph, double em) {
  Collector collector;
  collector.em = em;
  FT_Outline_Funcs functions{&Collector::move, &Collector::line, &Collector::conic,
                             &Collector::cubic, 0, 0};
  FT_Outline_Decompose(&glyph->outline, &functions, &collector);
  collector.close();
  if (collector.pieces.empty()) return nullptr;
  return std::make_shared<const core::Outline>(std::move(collector.pieces));
}

}  // namespace

std::vector<PlacedGlyph> layout_text(const TextShape& text) {
  const FontFile font(text.font);
  const FT_Face face = font.face();
  const double em = face->units_per_EM;
  std::map<FT_UInt, std::shared_ptr<const core::Outline>> outlines;
  std::vector<PlacedGlyph> glyphs;
  core::Vec3 pen;
  FT_UInt before = 0;
  bool first = true;
  for (const unsigned char character : text.text) {
    const FT_UInt index = FT_Get_Char_Index(face, character);
    if (FT_Load_Glyph(face, index, FT_LOAD_NO_SCALE) != 0) continue;
    FT_Vector kerning{};
    if (!first) FT_Get_Kerning(face, before, index, FT_KERNING_UNSCALED, &kerning);
    const auto bearing = static_cast<double>(face->glyph->metrics.horiBearingX);
    // The space left of the first character does not count.
    const double start = first ? -bearing : static_cast<double>(kerning.x);
    auto& outline = outlines[index];
    if (!outline) outline = outline_of(face->glyph, em);
    if (outline) glyphs.push_back({outline, pen + core::Vec3{start / em, 0.0, 0.0}});
    pen.x += (static_cast<double>(face->glyph->metrics.horiAdvance) + start) / em;
    pen += text.offset;
    before = index;
    first = false;
  }
  return glyphs;
}

}  // namespace lentray::parser
