#include "parser/shapes/text_shape.h"

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include "parser/base/text.h"

namespace lentray::parser {
namespace {

using core::CurvePiece;
using core::Vec2;

class FontFile {
 public:
  explicit FontFile(const FoundFile& found) {
    if (FT_Init_FreeType(&m_library) != 0) throw std::runtime_error("FreeType does not start");
    if (FT_New_Face(m_library, found.handle.c_str(), 0, &m_face) != 0) {
      FT_Done_FreeType(m_library);
      throw std::runtime_error("cannot read the font '" + found.path + "'");
    }
    list_character_maps();
  }
  ~FontFile() {
    FT_Done_Face(m_face);
    FT_Done_FreeType(m_library);
  }
  FontFile(const FontFile&) = delete;
  FontFile& operator=(const FontFile&) = delete;
  FT_Face face() const { return m_face; }

  /// The first that the font's tables have, in stock's order; 0: none.
  FT_UInt index_of(FT_ULong character, bool unicode) const {
    static constexpr std::array<std::size_t, kMaps> kPlain{0, 1, 2, 3}, kUnicode{2, 1, 0, 3};
    for (const std::size_t k : unicode ? kUnicode : kPlain) {
      if (!m_maps[k] || FT_Set_Charmap(m_face, m_maps[k]) != 0) continue;
      if (const FT_UInt index = FT_Get_Char_Index(m_face, character)) return index;
    }
    return 0;
  }

 private:
  void list_character_maps() {
    static constexpr std::array<std::pair<int, int>, kMaps> kEncodings{
        {{1, 0}, {3, 1}, {0, 3}, {3, 0}}};
    for (std::size_t k = 0; k < kMaps; ++k) {
      for (int i = 0; i < m_face->num_charmaps && !m_maps[k]; ++i) {
        const FT_CharMap map = m_face->charmaps[i];
        if (std::pair<int, int>(map->platform_id, map->encoding_id) == kEncodings[k])
          m_maps[k] = map;
      }
    }
  }

  static constexpr std::size_t kMaps = 4;
  /// Macintosh Roman, Unicode of Windows, Unicode, symbols of Windows; null: the font has none.
  std::array<FT_CharMap, kMaps> m_maps{};
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
  // Half units, so that points in the middle of two others stay there: FreeType counts in integers.
  constexpr int kHalves = 1;
  Collector collector;
  collector.em = em * (1 << kHalves);
  FT_Outline_Funcs functions{&Collector::move,  &Collector::line, &Collector::conic,
                             &Collector::cubic, kHalves,          0};
  FT_Outline_Decompose(&glyph->outline, &functions, &collector);
  collector.close();
  if (collector.pieces.empty()) return nullptr;
  return std::make_shared<const core::Outline>(std::move(collector.pieces));
}

}  // namespace

class TextLayout::Font {
 public:
  /// Lengths in the font's units.
  struct Glyph {
    bool is_there = false;
    double bearing = 0.0, advance = 0.0;
    double width = 0.0, top = 0.0, height = 0.0;   ///< of its box, which starts at `bearing`
    std::shared_ptr<const core::Outline> outline;  ///< null: nothing to see
  };

  explicit Font(const FoundFile& found) : m_file(found) {}
  FT_Face face() const { return m_file.face(); }
  FT_UInt index_of(FT_ULong character, bool unicode) const {
    return m_file.index_of(character, unicode);
  }
  double em() const { return face()->units_per_EM; }

  const Glyph& glyph(FT_UInt index) {
    const auto [at, is_new] = m_glyphs.try_emplace(index);
    if (!is_new || FT_Load_Glyph(face(), index, FT_LOAD_NO_SCALE) != 0) return at->second;
    const FT_Glyph_Metrics& metrics = face()->glyph->metrics;
    at->second = {true,
                  static_cast<double>(metrics.horiBearingX),
                  static_cast<double>(metrics.horiAdvance),
                  static_cast<double>(metrics.width),
                  static_cast<double>(metrics.horiBearingY),
                  static_cast<double>(metrics.height),
                  outline_of(face()->glyph, em())};
    return at->second;
  }

 private:
  FontFile m_file;
  std::map<FT_UInt, Glyph> m_glyphs;
};

TextLayout::TextLayout() = default;
TextLayout::~TextLayout() = default;

std::vector<PlacedGlyph> TextLayout::place(const TextShape& text) {
  std::unique_ptr<Font>& font = m_fonts[text.font.path];
  if (!font) font = std::make_unique<Font>(text.font);
  const FT_Face face = font->face();
  const double em = font->em();
  std::vector<PlacedGlyph> glyphs;
  core::Vec3 pen;
  FT_UInt before = 0;
  bool first = true;
  for (const char32_t character : characters_of(text.text)) {
    const FT_UInt index = font->index_of(character, text.unicode);
    const Font::Glyph& glyph = font->glyph(index);
    if (!glyph.is_there) continue;
    FT_Vector kerning{};
    if (!first) FT_Get_Kerning(face, before, index, FT_KERNING_UNSCALED, &kerning);
    // The space left of the first character does not count.
    const double start = first ? -glyph.bearing : static_cast<double>(kerning.x);
    const core::Vec3 place = pen + core::Vec3{start / em, 0.0, 0.0};
    // Stock's box of what reaches to the left of the pen is as wide as from there on.
    const double width = glyph.width + std::max(0.0, -glyph.bearing);
    const Vec2 corner{place.x + glyph.bearing / em, place.y + (glyph.top - glyph.height) / em};
    glyphs.push_back(
        {glyph.outline, place, corner, {corner.u + width / em, corner.v + glyph.height / em}});
    pen.x += (glyph.advance + start) / em;
    pen += core::Vec3{text.offset.x, text.offset.y, 0.0};
    before = index;
    first = false;
  }
  return glyphs;
}

}  // namespace lentray::parser
