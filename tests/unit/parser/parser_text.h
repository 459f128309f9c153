// SDL texts through the front end alone: statements are read past, everything else is executed.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/function/node.h"
#include "parser/interpreter/parser.h"
#include "tools/common/process.h"

namespace lentray::test {

/// Productions that keep nothing: a statement is a keyword and a block.
class NoProductions final : public parser::Productions {
 public:
  std::optional<parser::Value> rvalue(parser::Parser& parser) override {
    if (parser.peek().kind != parser::TokenKind::kKeyword) return std::nullopt;
    do {
      parser.next();
      skip_block(parser);
    } while (parser.at(parser::Keyword::kTexture));
    static const int kept = 0;
    return parser::Ref<parser::ObjectDesc>(std::shared_ptr<const void>(),
                                           reinterpret_cast<const parser::ObjectDesc*>(&kept));
  }
  void set_default(parser::Parser& parser) override { skip_block(parser); }
  bool inside(const parser::ObjectDesc&, const core::Vec3& p) override { return p.x > 0.0; }
  bool trace(const parser::ObjectDesc&, const core::Vec3& origin, const core::Vec3& direction,
             core::Vec3& point, core::Vec3& normal) override {
    point = origin + direction;
    normal = -direction;
    return true;
  }
  void extent(const parser::ObjectDesc&, core::Vec3& lo, core::Vec3& hi) override {
    lo = {-1, -2, -3};
    hi = {1, 2, 3};
  }
  parser::Ref<parser::FunctionDesc> pattern_function(parser::Parser& parser) override {
    parser.next();
    skip_block(parser);
    auto desc = std::make_shared<parser::FunctionDesc>();
    desc->function = core::compile_function(*core::constant_node(0.5), 3, 0, 1e6);
    return desc;
  }

 private:
  static void skip_block(parser::Parser& parser) {
    parser.expect(parser::Punct::kLeftCurly);
    for (int depth = 1; depth > 0;) {
      const parser::Token t = parser.next();
      if (t.kind == parser::TokenKind::kEnd) parser.fail_expected("'}'");
      if (t.is(parser::Punct::kLeftCurly)) ++depth;
      if (t.is(parser::Punct::kRightCurly)) --depth;
    }
  }
};

struct Parsed {
  std::string debug;       ///< what #debug wrote
  std::string error;       ///< the whole message; empty if there was none
  std::string message;     ///< its bare text
  parser::Position where;  ///< of the error
  std::vector<std::string> warnings;
  std::size_t tokens = 0;  ///< left for productions
};

/// Reads `text` as scene.pov, beside the other files, and all tokens after it.
inline Parsed parse_text(const std::string& text,
                         const std::map<std::string, std::string>& files = {},
                         parser::ParserOptions options = {}) {
  const tool::TemporaryFolder folder;
  for (const auto& [name, content] : files) tool::write_text(folder / name, content);
  tool::write_text(folder / "scene.pov", text);
  options.library_paths.push_back("/usr/share/povray-3.7/include");
  parser::SourceManager sources;
  parser::Diagnostics diagnostics(sources);
  Parsed out;
  diagnostics.connect(parser::Stream::kDebug, [&](std::string_view t) { out.debug += t; });
  diagnostics.connect(parser::Stream::kWarning, {});
  NoProductions productions;
  try {
    parser::Parser parser(sources, diagnostics, options, productions);
    parser.set_working_gamma(1.0);  // global_settings are read past: as if they had said so
    parser.open(folder / "scene.pov");
    for (; !parser.at_end(); ++out.tokens) parser.next();
  } catch (const parser::ParseError& error) {
    out.error = error.what();
    out.message = error.message();
    out.where = sources.position(error.where());
  }
  for (const auto& warning : diagnostics.warnings()) out.warnings.push_back(warning.message);
  return out;
}

}  // namespace lentray::test
