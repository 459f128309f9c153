#include "tools/lentray-diff/workshop.h"

#include <algorithm>
#include <csignal>
#include <sstream>
#include <stdexcept>

#include "tools/common/shell_words.h"

namespace lentray::diff {

namespace fs = std::filesystem;
using core::StoredImage;

namespace {

/// Pictures of stock's in a folder.
std::vector<fs::path> made(const fs::path& folder) {
  std::vector<fs::path> out;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (entry.path().filename().string().starts_with("stock") &&
        (extension == ".png" || extension == ".exr"))
      out.push_back(entry.path());
  }
  return out;
}

/// Stock does not find files whose names are no UTF-8; others would end the string of an INI file or a scene.
bool is_plain(const std::string& path) {
  return std::ranges::all_of(path,
                             [](char c) { return c >= ' ' && c <= '~' && c != '"' && c != '\\'; });
}

}  // namespace

Workshop::Workshop(const fs::path& scene, const StockOptions& options) : m_options(options) {
  if (!fs::is_regular_file(scene)) {
    throw std::runtime_error("there is no scene '" + scene.string() + "'");
  }
  m_scene = fs::absolute(scene);
  m_root = options.keep.empty() ? m_temporary.path() : fs::absolute(options.keep);
  fs::create_directories(m_root);
  m_named = m_scene;
  m_folder = m_scene.parent_path();
  if (is_plain(m_scene.string())) return;
  m_named = m_root / "its-scene.pov";
  m_folder = m_root / "its-folder";
  for (const fs::path& link : {m_named, m_folder}) fs::remove(link);
  fs::create_symlink(m_scene, m_named);
  fs::create_directory_symlink(m_scene.parent_path(), m_folder);
}

Included Workshop::included() {
  const std::string text = tool::read_text(m_scene);
  copy_includes(text, 0);
  bool changed = false;
  const std::string readable = without_lenticular(text, changed);
  if (!changed) return {version_directive(text), m_named.string()};
  const fs::path copy = m_root / ("plain-" + m_named.filename().string());
  tool::write_whole(copy, readable);
  return {version_directive(text), copy.string()};
}

StoredImage Workshop::render_text(const std::string& name, const std::string& text,
                                  const Shot& shot) const {
  const fs::path folder = m_root / name;
  fs::create_directories(folder);
  tool::write_whole(folder / (name + ".pov"), text);
  return render(folder, folder / (name + ".pov"), shot);
}

StoredImage Workshop::render_scene(const Shot& shot) const {
  const fs::path folder = m_root / "picture";
  fs::create_directories(folder);
  return render(folder, m_named, shot);
}

void Workshop::copy_includes(const std::string& text, int depth) {
  constexpr int deepest = 20;  // files may include themselves under a condition
  for (const std::string& name : included_files(text)) {
    std::vector<fs::path> places{m_scene.parent_path() / name};
    for (const fs::path& p : m_options.library_paths) places.push_back(p / name);
    const auto file = std::find_if(places.begin(), places.end(),
                                   [](const fs::path& p) { return fs::is_regular_file(p); });
    if (file == places.end() || depth > deepest || fs::path(name).is_absolute()) continue;
    const std::string inner = tool::read_text(*file);
    copy_includes(inner, depth + 1);
    bool changed = false;
    const std::string readable = without_lenticular(inner, changed);
    if (!changed) continue;
    fs::create_directories((m_root / name).parent_path());
    tool::write_whole(m_root / name, readable);
  }
}

StoredImage Workshop::render(const fs::path& folder, const fs::path& scene,
                             const Shot& shot) const {
  const fs::path picture = folder / (shot.as_light ? "stock.exr" : "stock.png");
  // An option file in the folder, for paths with spaces in them.
  std::ostringstream ini;
  ini << "Input_File_Name=\"" << scene.string() << "\"\nOutput_File_Name=\"" << picture.string()
      << "\"\nLibrary_Path=\"" << m_root.string() << "\"\nLibrary_Path=\"" << m_folder.string()
      << "\"\n";
  for (const fs::path& p : m_options.library_paths)
    ini << "Library_Path=\"" << p.string() << "\"\n";
  tool::write_whole(folder / "stock.ini", ini.str());
  std::vector<std::string> command{m_options.povray, "stock.ini", "+W" + std::to_string(shot.width),
                                   "+H" + std::to_string(shot.height)};
  command.emplace_back(shot.as_light ? "+FE" : m_options.bits == 16 ? "+FN16" : "+FN8");
  tool::append(command, m_options.arguments);
  tool::append(command, words(shot.antialiased ? m_options.antialiasing : Antialiasing()));
  if (m_options.block > 0) {
    command.push_back("+BS" + std::to_string(m_options.block));
  } else if (shot.antialiased) {  // method 1 begins anew in each block
    command.push_back("+BS" + std::to_string(std::max({shot.width, shot.height, 32u})));
  }
  tool::append(command, {"+WT" + std::to_string(m_options.threads), "-D", "-P", "-V"});
  for (const fs::path& earlier : made(folder)) fs::remove(earlier);
  tool::RunResult result = tool::run_program(command, folder, m_options.seconds);
  // Stock crashes now and then while it reads a scene that it can render.
  constexpr int crashed = 128 + SIGSEGV;
  if (result.status == crashed) result = tool::run_program(command, folder, m_options.seconds);
  if (result.timed_out) throw std::runtime_error("stock POV-Ray took too long");
  const std::vector<fs::path> pictures = made(folder);  // of a frame: its number stands in the name
  if (result.status != 0 || pictures.size() != 1) {
    throw std::runtime_error("stock POV-Ray cannot render '" + m_scene.string() + "' (status " +
                             std::to_string(result.status) + "):\n" + last_words(result.output));
  }
  return core::read_image(pictures.front());
}

std::string last_words(const std::string& output) {
  std::vector<std::string> lines;
  std::istringstream in(output);
  for (std::string line; std::getline(in, line);) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) lines.push_back(line);
  }
  // The message itself stands some lines above the end, behind the banner.
  std::size_t first = lines.size() > 12 ? lines.size() - 12 : 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].find("rror:") != std::string::npos) {
      first = i > 2 ? i - 2 : 0;
      break;
    }
  }
  std::string text;
  for (std::size_t i = first; i < lines.size() && i < first + 14; ++i) text += lines[i] + "\n";
  return text;
}

}  // namespace lentray::diff
