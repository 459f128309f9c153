// Reads looks in tests: what may stand in an object, without the object.
#pragma once

#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <fstream>
#include <string>

#include <unistd.h>

#include "parser/compile/texture_compiler.h"
#include "parser/grammar/productions.h"

namespace lentray::parser::test {

class LooksText {
 public:
  /// `before` holds directives that come first. `#version 3.7;` stands before all unless given.
  explicit LooksText(const std::string& looks, const std::string& before = "")
      : m_diagnostics(m_sources) {
    for (const Stream s :
         {Stream::kDebug, Stream::kRender, Stream::kStatistics, Stream::kWarning, Stream::kFatal}) {
      m_diagnostics.connect(s, [](std::string_view) {});
    }
    static std::atomic<int> count = 0;
    const std::string path = ::testing::TempDir() + "lentray_looks_" + std::to_string(getpid()) +
                             "_" + std::to_string(count++) + ".inc";
    const bool versioned = before.find("#version") != std::string::npos;
    // The 0 ends what is declared: a texture after a declared one would be its next layer.
    std::ofstream(path) << (versioned ? "" : "#version 3.7;\n") << before << " 0 " << looks << '\n';
    try {
      read(path);
    } catch (...) {
      std::remove(path.c_str());
      throw;
    }
    std::remove(path.c_str());
  }
  LooksText(const LooksText&) = delete;
  LooksText& operator=(const LooksText&) = delete;

  const Looks& object() const { return m_looks; }
  const TextureDesc& texture() const { return *m_looks.texture; }
  const TextureLayerDesc& layer() const { return texture().layers.back(); }
  const PigmentDesc& pigment() const { return *layer().pigment; }
  const FinishDesc& finish() const { return *layer().finish; }
  const NormalDesc& normal() const { return *layer().normal; }
  const PatternDesc& pattern() const { return pigment().pattern; }
  bool warned(const std::string& part) const {
    for (const Diagnostic& d : m_diagnostics.warnings()) {
      if (d.message.find(part) != std::string::npos) return true;
    }
    return false;
  }

 private:
  void read(const std::string& path) {
    Grammar grammar;
    Parser parser(m_sources, m_diagnostics, ParserOptions{}, grammar);
    parser.open(path);
    parser.parse_float();
    while (accept_looks(parser, grammar.context().materials, m_looks)) {
    }
    if (!parser.at_end()) parser.fail_expected("a part of an object's looks");
    if (!m_looks.texture) m_looks.texture = grammar.context().materials.default_texture;
  }

  SourceManager m_sources;
  Diagnostics m_diagnostics;
  Looks m_looks;
};

/// The message with which looks fail; "" if they do not.
inline std::string looks_failure(const std::string& looks, const std::string& before = "") {
  try {
    LooksText read(looks, before);
  } catch (const ParseError& error) {
    return error.message();
  }
  return "";
}

inline std::shared_ptr<const core::Pigment> compiled(const PigmentDesc& pigment, int quality = 9) {
  TextureSettings settings;
  settings.quality = quality;
  return TextureCompiler(settings).pigment(std::make_shared<PigmentDesc>(pigment));
}

/// The colour a pigment gives at a point.
inline core::Colour colour_at(const std::string& pigment, const core::Vec3& point) {
  const LooksText text("pigment { " + pigment + " }");
  return compiled(text.pigment())->colour(point);
}

inline void expect_rgb(const core::Rgb& colour, double r, double g, double b,
                       double tolerance = 1e-6) {
  EXPECT_NEAR(colour.r, r, tolerance);
  EXPECT_NEAR(colour.g, g, tolerance);
  EXPECT_NEAR(colour.b, b, tolerance);
}

}  // namespace lentray::parser::test
