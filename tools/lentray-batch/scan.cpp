#include "tools/lentray-batch/scan.h"

#include <unistd.h>
#include <algorithm>

#include <cctype>
#include <fstream>
#include <set>
#include <sstream>

#include "parser/options/ini.h"

namespace lentray::batch {

namespace fs = std::filesystem;

namespace {

bool has_extension(const fs::path& path, std::string_view extension) {
  return parser::same_word(path.extension().string(), extension);
}

bool is_within(const fs::path& path, const fs::path& folder) {
  const auto [end, at] = std::ranges::mismatch(folder, path);
  return end == folder.end();
}

/// A long mesh or array is not looked through: cameras and includes stand before it, or behind in a file of its own.
std::string beginning(const fs::path& path) {
  constexpr std::size_t kMost = std::size_t{4} << 20;
  std::ifstream file(path, std::ios::binary);
  std::string text(kMost, '\0');
  file.read(text.data(), static_cast<std::streamsize>(kMost));
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

/// Steps through a text, comments and strings apart.
class Words {
 public:
  explicit Words(std::string_view text) : m_text(text) {}

  /// The next word ("#" belongs to it) or string (with its first quote); empty at the end.
  std::string_view next() {
    for (; m_at < m_text.size(); ++m_at) {
      if (skip_comment()) continue;
      const char c = m_text[m_at];
      if (c == '"') return string();
      if (is_letter(c) || c == '#') return word();
    }
    return {};
  }

 private:
  static bool is_letter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
  }
  bool starts(std::string_view what) const { return m_text.substr(m_at).starts_with(what); }

  /// At its last character if there was one.
  bool skip_comment() {
    if (starts("//")) {
      m_at = std::min(m_text.find('\n', m_at), m_text.size());
      return true;
    }
    if (!starts("/*")) return false;
    int depth = 0;
    for (; m_at < m_text.size(); ++m_at) {
      depth += starts("/*") ? 1 : starts("*/") ? -1 : 0;
      if (starts("/*") || starts("*/")) ++m_at;
      if (depth == 0) break;
    }
    return true;
  }
  std::string_view string() {
    const std::size_t begin = m_at;
    for (++m_at; m_at < m_text.size() && m_text[m_at] != '"'; ++m_at) {
      if (m_text[m_at] == '\\') ++m_at;
    }
    const std::size_t end = std::min(m_at, m_text.size());
    m_at = end + 1;
    return m_text.substr(begin, end - begin);
  }
  std::string_view word() {
    const std::size_t begin = m_at++;
    while (m_text[begin] == '#' && m_at < m_text.size() &&
           (m_text[m_at] == ' ' || m_text[m_at] == '\t'))
      ++m_at;
    while (m_at < m_text.size() && is_letter(m_text[m_at])) ++m_at;
    return m_text.substr(begin, m_at - begin);
  }

  std::string_view m_text;
  std::size_t m_at = 0;
};

class Scanner {
 public:
  Scanner(const fs::path& out, const std::map<std::string, std::string>& known)
      : m_out(out), m_known(known) {}

  void add(const fs::path& input) {
    std::error_code error;
    const fs::path place = fs::absolute(input).lexically_normal();
    if (fs::is_directory(place, error)) {
      if (is_within(place, m_out)) {
        throw parser::OptionError("--out '" + m_out.string() + "' holds the scenes of '" +
                                  input.string() +
                                  "': pictures would lie among theirs; name another folder");
      }
      add_folder(place.has_filename() ? place : place.parent_path());
    } else if (fs::is_regular_file(place, error)) {
      add_scene(place, place.stem().string(), "");
    } else {
      throw parser::OptionError("'" + input.string() + "' is no scene and no folder");
    }
  }

  Scan take() {
    name_all();
    std::ranges::sort(m_scan.scenes, {}, &Scene::name);
    return std::move(m_scan);
  }

 private:
  void add_folder(const fs::path& root) {
    std::vector<fs::path> scenes;
    std::map<fs::path, fs::path> included;  // by whom
    std::error_code error;
    fs::recursive_directory_iterator at(root, error), end;
    if (error)
      throw parser::OptionError("cannot read the folder '" + root.string() +
                                "': " + error.message());
    for (; at != end; at.increment(error)) {
      if (error) {
        m_scan.warnings.push_back("some of '" + root.string() +
                                  "' cannot be read: " + error.message());
        break;
      }
      const fs::path& path = at->path();
      std::error_code ignored;
      if (at->is_directory(ignored)) {
        if (path == m_out || path.filename().string().starts_with("."))
          at.disable_recursion_pending();
        if (::access(path.c_str(), R_OK | X_OK) != 0) {
          m_scan.warnings.push_back("the folder '" + path.string() + "' cannot be read");
          at.disable_recursion_pending();
        }
      } else if (at->is_regular_file(ignored) &&
                 (has_extension(path, ".pov") || has_extension(path, ".inc"))) {
        if (has_extension(path, ".pov")) scenes.push_back(path);
        for (const std::string& name : look_at(beginning(path)).includes) {
          if (has_extension(name, ".pov"))
            included.emplace((path.parent_path() / name).lexically_normal(), path);
        }
      }
    }
    for (const fs::path& scene : scenes) {
      const auto by = included.find(scene);
      const bool is_part = by != included.end() && !look_at(beginning(scene)).has_camera;
      add_scene(scene, scene.lexically_relative(root).replace_extension().string(),
                is_part ? by->second.lexically_relative(root).string() : "");
    }
  }

  void add_scene(const fs::path& source, const std::string& name, const std::string& part_of) {
    if (!m_sources.insert(source).second) return;
    Scene scene{source, name, part_of, {}};
    for (const char* extension : {".ini", ".INI"}) {
      fs::path ini = source;
      ini.replace_extension(extension);
      std::error_code error;
      if (scene.ini.empty() && fs::is_regular_file(ini, error)) scene.ini = ini;
    }
    m_scan.scenes.push_back(std::move(scene));
  }

  /// Names are unique, and stay what they were in earlier runs.
  void name_all() {
    std::set<std::string> taken;
    for (const auto& [source, name] : m_known) taken.insert(name);
    std::ranges::sort(m_scan.scenes, {}, &Scene::source);
    for (Scene& scene : m_scan.scenes) {
      if (const auto at = m_known.find(scene.source.string()); at != m_known.end()) {
        scene.name = at->second;
        continue;
      }
      const std::string plain = scene.name;
      const std::string folder = scene.source.parent_path().filename().string();
      int number = 1;
      for (const std::string& other : {plain, folder + "/" + plain}) {
        if (taken.insert(scene.name = other).second) number = 0;
        if (number == 0) break;
      }
      while (number > 0 &&
             !taken.insert(scene.name = plain + "-" + std::to_string(++number)).second) {
      }
    }
  }

  const fs::path m_out;
  const std::map<std::string, std::string>& m_known;
  std::set<fs::path> m_sources;
  Scan m_scan;
};

}  // namespace

SceneText look_at(std::string_view text) {
  SceneText out;
  Words words(text);
  bool after_include = false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (after_include && word[0] == '"') out.includes.emplace_back(word.substr(1));
    // #include, # include, and without the # in old scenes.
    after_include = word.ends_with("include");
    out.has_camera = out.has_camera || word == "camera";
  }
  return out;
}

Scan find_scenes(const std::vector<fs::path>& inputs, const fs::path& out,
                 const std::map<std::string, std::string>& known) {
  Scanner scanner(out, known);
  for (const fs::path& input : inputs) scanner.add(input);
  return scanner.take();
}

}  // namespace lentray::batch
