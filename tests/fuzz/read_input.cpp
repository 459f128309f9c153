#include "tests/fuzz/read_input.h"

#include <filesystem>

#include "parser/read_scene.h"

namespace lentray::test {
namespace {

// Small enough that an input that runs into one of them ends within a second.
parser::Limits small_limits() {
  parser::Limits limits;
  limits.turns = 2000;
  limits.array_elements = 20'000;
  limits.string_bytes = 20'000;
  limits.nesting = 1000;
  limits.array_depth = limits.nested = 200;
  limits.function_calls = 1e3;
  limits.function_terms = 100;
  limits.layers = 50;
  limits.object_parts = 1e3;
  return limits;
}

}  // namespace

std::vector<std::string> read_input(std::string_view text, const MemoryFiles::Library& library) {
  MemoryFiles files(library);
  files.add("scene.pov", std::string(text));
  parser::SourceManager sources(files);
  parser::Diagnostics diagnostics(sources);
  for (std::size_t i = 0; i < parser::kStreams; ++i) {
    diagnostics.connect(static_cast<parser::Stream>(i), {});
  }
  parser::ParserOptions options;
  options.limits = small_limits();
  std::vector<std::string> messages;
  try {
    parser::read_scene("scene.pov", sources, diagnostics, options);
  } catch (const parser::ParseError& error) {
    messages.push_back(error.message());
  }
  for (const auto& warning : diagnostics.warnings()) {
    messages.insert(messages.begin(), warning.message);
  }
  return messages;
}

MemoryFiles::Library include_files(const std::string& folder) {
  MemoryFiles::Library library;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() != ".inc") continue;
    auto text = parser::disk_files().read(entry.path().string());
    if (text) library.emplace(entry.path().filename().string(), std::move(*text));
  }
  return library;
}

}  // namespace lentray::test
