// Reads scene texts in tests: the text goes through a file, as scenes do.
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "parser/grammar/productions.h"
#include "parser/read_scene.h"

namespace lentray::parser::test {

/// One text read; keeps what the result refers to.
class SceneText {
 public:
  /// `#version 3.7;` and assumed_gamma 1 stand before the text unless it has its own #version.
  explicit SceneText(const std::string& text, ParserOptions options = {})
      : m_diagnostics(m_sources) {
    for (const Stream s :
         {Stream::kDebug, Stream::kRender, Stream::kStatistics, Stream::kWarning, Stream::kFatal}) {
      m_diagnostics.connect(s, [](std::string_view) {});
    }
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string test = std::string(info->test_suite_name()) + "_" + info->name();
    for (char& c : test) c = c == '/' ? '_' : c;  // parameterised tests have slashes in their names
    m_path = ::testing::TempDir() + "lentray_" + test + ".pov";
    std::string head;
    if (text.find("#version") == std::string::npos) {
      head = "#version 3.7; global_settings { assumed_gamma 1 } ";
    }
    std::ofstream(m_path) << head << text;
    scene = read_descriptions(m_path, m_sources, m_diagnostics, options);
  }
  ~SceneText() { std::remove(m_path.c_str()); }
  SceneText(const SceneText&) = delete;
  SceneText& operator=(const SceneText&) = delete;

  core::SceneParts build() {
    SceneDesc used_up = scene;
    core::SceneParts parts = build_scene(used_up, m_diagnostics, {}, &report);
    for (const auto& object : parts.objects) complete(*object);
    return parts;
  }
  const ObjectDesc& object(std::size_t i = 0) const { return *scene.objects.at(i).object; }
  template <typename Shape>
  const Shape& shape(std::size_t i = 0) const {
    return std::get<Shape>(object(i).shape);
  }
  bool warned(const std::string& part) const {
    for (const Diagnostic& d : m_diagnostics.warnings()) {
      if (d.message.find(part) != std::string::npos) return true;
    }
    return false;
  }
  Diagnostics& diagnostics() { return m_diagnostics; }
  const SourceManager& sources() const { return m_sources; }

  SceneDesc scene;
  BuildReport report;  ///< of build()

 private:
  SourceManager m_sources;
  Diagnostics m_diagnostics;
  std::string m_path;
};

/// The message with which a text fails; "" if it does not.
inline std::string failure(const std::string& text) {
  try {
    SceneText read(text);
  } catch (const ParseError& error) {
    return error.message();
  }
  return "";
}

inline void expect_near(const core::Vec3& a, const core::Vec3& b, double tolerance = 1e-12) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

}  // namespace lentray::parser::test
