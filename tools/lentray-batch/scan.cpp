#include "tools/lentray-batch/scan.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "core/base/ignored_error.h"
#include "parser/files/opened_file.h"
#include "parser/options/ini.h"
#include "tools/common/scene_scanner.h"

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

/// Absolute, without dots and a slash at its end.
fs::path whole(const fs::path& input) {
  const fs::path place = fs::absolute(input).lexically_normal();
  return place.has_filename() ? place : place.parent_path();
}

class Scanner {
 public:
  Scanner(const ScanOptions& options, const std::map<std::string, std::string>& known)
      : m_out(options.out), m_follows_links(options.follows_links), m_known(known) {}

  void add(const fs::path& input) {
    const fs::path place = whole(input);
    if (fs::is_directory(place, core::ignored_error())) {
      if (is_within(place, m_out)) {
        throw parser::OptionError("--out '" + m_out.string() + "' holds the scenes of '" +
                                  input.string() +
                                  "': pictures would lie among theirs; name another folder");
      }
      add_folder(place);
    } else if (fs::is_regular_file(place, core::ignored_error())) {
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
  struct Found {
    std::vector<fs::path> scenes;
    std::map<fs::path, fs::path> included;  // by whom
  };

  void add_folder(const fs::path& root) {
    std::error_code error;
    fs::directory_iterator(root, error);
    if (error)
      throw parser::OptionError("cannot read the folder '" + root.string() +
                                "': " + error.message());
    Found found;
    walk(root, root, found);
    for (const fs::path& scene : found.scenes) {
      const auto by = found.included.find(scene);
      const bool is_part =
          by != found.included.end() && !look_at(beginning(scene, root)).has_camera;
      add_scene(scene, scene.lexically_relative(root).replace_extension().string(),
                is_part ? by->second.lexically_relative(root).string() : "");
    }
  }

  /// One that cannot be read, or is gone meanwhile, leaves the others as they are.
  void walk(const fs::path& folder, const fs::path& root, Found& found) {
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
      const fs::path& path = at->path();
      std::error_code ignored;
      if (at->is_directory(ignored)) {
        const bool is_asked = path != m_out && !path.filename().string().starts_with(".");
        if (is_asked && !at->is_symlink(ignored)) walk(path, root, found);
      } else if (at->is_regular_file(ignored) &&
                 (has_extension(path, ".pov") || has_extension(path, ".inc")) &&
                 may_follow(*at, root)) {
        if (has_extension(path, ".pov")) found.scenes.push_back(path);
        for (const std::string& name : look_at(beginning(path, root)).includes) {
          if (has_extension(name, ".pov"))
            found.included.emplace((path.parent_path() / name).lexically_normal(), path);
        }
      }
    }
    if (error)
      m_scan.warnings.push_back("the folder '" + folder.string() +
                                "' cannot be read: " + error.message());
  }

  /// A long mesh or array is not looked through: cameras and includes stand before it, or behind in a file of its own.
  /// The file that is judged is the one that is read, whatever its name means a moment later.
  std::string beginning(const fs::path& path, const fs::path& root) const {
    constexpr std::size_t kMost = std::size_t{4} << 20;
    const parser::Descriptor held = parser::look_at(path.string());
    if (!held || !parser::special_kind(parser::status_of(held)).empty()) return {};
    if (!m_follows_links && !is_within(parser::real_path(held), fs::canonical(root))) return {};
    std::ifstream file(parser::handle_of(held), std::ios::binary);
    std::string text(kMost, '\0');
    file.read(text.data(), static_cast<std::streamsize>(kMost));
    text.resize(static_cast<std::size_t>(file.gcount()));
    return text;
  }

  /// A link may have come with the scenes, and lead to any file of the user's.
  bool may_follow(const fs::directory_entry& entry, const fs::path& root) {
    std::error_code error;
    if (m_follows_links || !entry.is_symlink(error)) return true;
    const fs::path place = fs::canonical(entry.path(), error);
    if (!error && is_within(place, fs::canonical(root, error))) return true;
    m_scan.warnings.push_back("'" + entry.path().string() + "' is a link that leads out of '" +
                              root.string() + "': left out");
    return false;
  }

  void add_scene(const fs::path& source, const std::string& name, const std::string& part_of) {
    if (!m_sources.insert(source).second) return;
    Scene scene{source, name, part_of, {}};
    for (const char* extension : {".ini", ".INI"}) {
      fs::path ini = source;
      ini.replace_extension(extension);
      if (scene.ini.empty() && fs::is_regular_file(ini, core::ignored_error())) scene.ini = ini;
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
  const bool m_follows_links;
  const std::map<std::string, std::string>& m_known;
  std::set<fs::path> m_sources;
  Scan m_scan;
};

}  // namespace

SceneText look_at(std::string_view text) {
  SceneText out;
  tool::SceneScanner scanner(text);
  for (auto word = scanner.next(); !word.empty(); word = scanner.next()) {
    out.has_camera = out.has_camera || word == "camera";
    if (word != "include") continue;  // old scenes have it without the #
    if (const auto name = scanner.next_string(); !name.empty()) out.includes.emplace_back(name);
  }
  return out;
}

Scan find_scenes(const std::vector<fs::path>& inputs, const ScanOptions& options,
                 const std::map<std::string, std::string>& known) {
  Scanner scanner(options, known);
  for (const fs::path& input : inputs) scanner.add(input);
  return scanner.take();
}

bool lies_in(const std::vector<fs::path>& inputs, const fs::path& place) {
  return std::ranges::any_of(inputs, [&](const fs::path& input) {
    const fs::path named = whole(input);
    std::vector<fs::path> places{named};
    if (fs::is_regular_file(named, core::ignored_error())) places.push_back(named.parent_path());
    return std::ranges::any_of(places, [&](const fs::path& of) {
      std::error_code error;
      const fs::path real = fs::canonical(of, error);
      return !error && is_within(place, real);
    });
  });
}

std::vector<fs::path> folders_of(const std::vector<fs::path>& inputs, const fs::path& source) {
  std::vector<fs::path> out;
  for (const fs::path& input : inputs) {
    const fs::path place = whole(input);
    if (place == source) out.push_back(source.parent_path());
    if (is_within(source, place) && place != source) out.push_back(place);
  }
  return out;
}

}  // namespace lentray::batch
