#include "parser/options/options.h"

#include <fcntl.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "core/base/formed.h"
#include "core/base/ignored_error.h"
#include "core/base/memory_limit.h"
#include "core/image/run_files.h"
#include "parser/base/shown.h"
#include "parser/files/opened_file.h"
#include "parser/options/lens_sheets.h"
#include "parser/options/options_table.h"
#include "parser/options/said_options.h"
#include "parser/options/sheet_size.h"
#include "parser/options/view_options_reader.h"

namespace lentray::parser {
namespace {

namespace fs = std::filesystem;

constexpr int kNesting = 10;  // levels of INI files inside INI files

bool ends_with(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && same_word(text.substr(text.size() - end.size()), end);
}

bool is_file(const fs::path& path) { return fs::is_regular_file(path, core::ignored_error()); }

/// The option's name that is nearest, if it is near at all.
std::string_view near_option(std::string_view name) {
  std::vector<std::string_view> names;
  for (const OptionRow& row : option_table()) names.push_back(row.name);
  return near_name(name, names);
}

class OptionsReader {
 public:
  /// `users`: what the user's own words say; null: these are read, and INI files of scenes are not.
  OptionsReader(RenderOptions& options, const RenderOptions* users, bool trusts_scene_folder)
      : m_options(options), m_users(users), m_trusts_scene_folder(trusts_scene_folder) {}

  void scene_file(const std::string& path) {
    if (m_users == nullptr) return;
    GivenOption given;
    given.from_scene = true;
    m_options.scene_ini_folder = fs::path(path).parent_path().string();
    file({path, "", false}, path, given, 1);
  }

  void named(const std::string& name, GivenOption given, int depth) {
    if (same_word(name, "Include_Ini")) return bare(given.value, given, depth + 1);
    for (const OptionRow& row : option_table()) {
      if (!row.name.empty() && same_word(row.name, name)) return apply(row, given);
    }
    const std::string_view near = near_option(name);
    const std::string message = given.where + "unknown option '" + name + "'" +
                                (near.empty() ? "" : "; did you mean " + std::string(near) + "?");
    if (!given.from_defaults) throw OptionError(message);
    m_options.warnings.push_back(message);
  }

  void switched(const std::string& text, GivenOption given) {
    given.sign = text.front();
    const std::string_view body = std::string_view(text).substr(1);
    const OptionRow* best = nullptr;
    for (const OptionRow& row : option_table()) {
      const std::size_t size = row.switch_name.size();
      if (size == 0 || size > body.size() || !same_word(row.switch_name, body.substr(0, size))) {
        continue;
      }
      if (!best || size > best->switch_name.size()) best = &row;
    }
    if (!best) {
      throw OptionError(given.where + "unknown switch '" + text +
                        "'; a scene file is named as +Ifile or by its name alone");
    }
    given.value = unquoted(body.substr(best->switch_name.size()));
    apply(*best, given);
  }

  void file(const IniName& name, const std::string& path, GivenOption given, int depth) {
    if (depth > kNesting) {
      throw OptionError(given.where + "INI files are nested more than " + std::to_string(kNesting) +
                        " deep");
    }
    const bool is_judged = given.from_scene && m_users->restrict_io;
    const std::string text = is_judged ? judged_text(path, given) : ini_file_text(path);
    for (const IniLine& line : read_ini(text, path, name, m_options.warnings).lines) {
      GivenOption next;
      next.from_defaults = given.from_defaults;
      next.from_scene = given.from_scene;
      next.where = path + ":" + std::to_string(line.line) + ": ";
      switch (line.kind) {
        case IniLine::Kind::kOption:
          next.shown = line.text + "=" + line.value;
          next.value = line.value;
          named(line.text, next, depth);
          break;
        case IniLine::Kind::kSwitch:
          next.shown = line.text;
          switched(line.text, next);
          break;
        case IniLine::Kind::kNested:
          next.shown = line.text;
          bare(line.text, next, depth + 1);
          break;
      }
    }
  }

  /// A name without a switch: a scene, or an INI file with or without a section.
  void bare(const std::string& text, const GivenOption& given, int depth) {
    const IniName name = ini_name(text);
    if (!name.has_label && ends_with(name.file, ".pov")) {
      return name_scene(name.file, given);
    }
    const std::string path = find(name.file, given);
    if (!path.empty()) return file(name, path, given, depth);
    if (!name.has_label) {
      for (const char* end : {".pov", ".POV"}) {
        if (!is_file(name.file + end)) continue;
        return name_scene(name.file + end, given);
      }
    }
    throw OptionError(given.where + "there is no INI file '" + name.file + "'" +
                      (name.has_label ? "" : " and no scene of that name"));
  }

 private:
  void apply(const OptionRow& row, const GivenOption& given) {
    if (given.from_scene && row.use == OptionUse::kRun) return leave_out(row.name, given);
    row.access.apply(m_options, given);
    say(row.name, given);
  }

  void say(std::string_view option, const GivenOption& given) {
    if (option.empty()) return;
    std::string where = given.where;
    if (where.ends_with(": ")) where.resize(where.size() - 2);
    m_options.said[std::string(option)] = {given.shown, where};
  }

  void name_scene(const std::string& name, const GivenOption& given) {
    if (given.from_scene) return leave_out("Input_File_Name", given);
    m_options.input = name;
    say("Input_File_Name", given);
  }

  /// What the user says himself nobody misses.
  void leave_out(std::string_view option, const GivenOption& given) {
    if (m_users->said.contains(option)) return;
    m_options.warnings.push_back(given.where + "option " + given.shown +
                                 ": left out: an INI file that came with a scene says what the "
                                 "picture is like, not what is read, written and run");
  }

  /// What an INI file that came with a scene says, and what it includes, gets into messages. The file that is judged is
  /// the one that is read, whatever its name means a moment later.
  std::string judged_text(const std::string& path, const GivenOption& given) const {
    const Descriptor held = look_at(path);
    const fs::path place = real_path(held);
    std::vector<std::string> folders = m_users->permitted_paths;
    if (m_trusts_scene_folder)
      folders.push_back(m_options.scene_ini_folder.empty() ? "." : m_options.scene_ini_folder);
    const auto holds = [&](const std::string& name) {
      std::error_code no_folder;
      const fs::path folder = fs::canonical(name, no_folder);
      return !no_folder && std::ranges::mismatch(folder, place).in1 == folder.end();
    };
    if (!special_kind(status_of(held)).empty() || !std::ranges::any_of(folders, holds)) {
      throw OptionError(
          given.where + "Restrict_IO: the INI file '" + shown_name(path) +
          "' is refused: an INI file that came with a scene, and what it includes, lie "
          "in its folder");
    }
    core::note_input(status_of(held), path);
    const auto text = read_all(reopen(held, O_RDONLY | O_CLOEXEC));
    if (!text)
      throw OptionError(given.where + "cannot read the INI file '" + shown_name(path) + "'");
    return *text;
  }

  /// An INI file is looked for as it is named, with .ini added, and then along the library paths.
  std::string find(const std::string& name, const GivenOption& given) const {
    std::vector<std::string> folders{""};
    if (fs::path(name).is_relative()) {
      // The current folder may be another than that of a scene's own file.
      if (given.from_scene) folders.push_back(m_options.scene_ini_folder);
      folders.insert(folders.end(), m_options.library_paths.begin(), m_options.library_paths.end());
    }
    for (const std::string& folder : folders) {
      for (const char* end : {"", ".ini", ".INI"}) {
        const fs::path path =
            folder.empty() ? fs::path(name + end) : fs::path(folder) / (name + end);
        if (is_file(path)) return path.string();
      }
    }
    return {};
  }

  RenderOptions& m_options;
  const RenderOptions* const m_users;
  const bool m_trusts_scene_folder;
};

/// The file that `--name FILE` or `--name=FILE` gives.
std::string file_of(std::span<const std::string> arguments, std::size_t& at,
                    const std::string& name) {
  const std::size_t equals = arguments[at].find('=');
  std::string file;
  if (equals != std::string::npos) {
    file = arguments[at].substr(equals + 1);
  } else if (at + 1 < arguments.size()) {
    file = arguments[++at];
  }
  if (file.empty()) throw OptionError(name + " needs the name of a file");
  return file;
}

/// `--name`, `--name VALUE` and `--name=VALUE`; true if it was one.
bool long_option(std::span<const std::string> arguments, std::size_t& at, RenderOptions& options) {
  const std::string& text = arguments[at];
  if (text == "-?" || text == "--help" || same_word(text, "-help")) return options.help = true;
  if (same_word(text, "--help=all")) return options.help = options.help_all = true;
  if (text == "--version" || same_word(text, "-version")) return options.version = true;
  if (text.rfind("--", 0) != 0) return false;
  const std::size_t equals = text.find('=');
  const std::string name = text.substr(0, equals);
  if (name == "--explain") return options.explain = true;
  if (name == "--lens-sheets") return options.list_lens_sheets = true;
  if (name == "--parse-only") return options.parse_only = true;
  if (name == "--dump") return options.dump = true;
  if (name == "--depth") return options.depth = true;
  if (name == "--depth-view") {
    options.depth_view = file_of(arguments, at, name);
    return options.depth = true;
  }
  if (name == "--dump-rays") {
    options.dump_rays = file_of(arguments, at, name);
    return true;
  }
  throw OptionError("unknown option '" + text +
                    "'; there are --help, --help=all, --version, --parse-only, --dump, --explain, "
                    "--depth, --depth-view FILE, --dump-rays FILE, --lens-sheets and "
                    "--scene-ini FILE");
}

bool looks_like_option(const std::string& text, std::size_t& equals) {
  equals = text.find('=');
  if (equals == std::string::npos || equals == 0) return false;
  for (std::size_t i = 0; i < equals; ++i) {
    if (!std::isalnum(static_cast<unsigned char>(text[i])) && text[i] != '_') return false;
  }
  return true;
}

/// A scene with a = in its name: no option is called so.
bool is_scene_name(const std::string& text, std::size_t equals) {
  const std::string_view name = std::string_view(text).substr(0, equals);
  const bool is_option = std::ranges::any_of(
      option_table(), [&](const OptionRow& row) { return same_word(row.name, name); });
  return !is_option && (ends_with(text, ".pov") || fs::exists(text, core::ignored_error()));
}

/// Of types whose names choose them: TIFF, which stock has not, and OpenEXR. Empty: none.
std::string_view choosing_extension(std::string_view name, core::FileType& type) {
  for (const std::string_view end : {".tif", ".tiff", ".exr"}) {
    if (!ends_with(name, end)) continue;
    type = end == ".exr" ? core::FileType::exr : core::FileType::tiff;
    return end;
  }
  return {};
}

}  // namespace

bool is_scene_word(const std::string& word) {
  std::size_t equals = 0;
  return !is_switch(word) && !is_ini(word) &&
         (!looks_like_option(word, equals) || is_scene_name(word, equals));
}

OptionSources installed_sources() {
  OptionSources sources;
  if (const char* file = std::getenv("POVINI")) sources.default_ini_files.emplace_back(file);
  sources.default_ini_files.emplace_back(kFolderIni);
  if (const char* home = std::getenv("HOME")) {
    sources.default_ini_files.push_back(std::string(home) + "/.povray/3.7/povray.ini");
  }
  sources.default_ini_files.emplace_back("/usr/local/etc/povray/3.7/povray.ini");
  sources.default_ini_files.emplace_back("/etc/povray/3.7/povray.ini");
  sources.standard_libraries = {"/usr/local/share/povray-3.7/include",
                                "/usr/share/povray-3.7/include"};
  return sources;
}

namespace {

/// Options that contradict each other: the message names the places where they were given.
void settle(RenderOptions& options) {
  try {
    settle_views(options);
  } catch (const OptionError& error) {
    throw OptionError(with_said(error.what(), options,
                                {"View", "Views", "View_Size", "View_Clock", "Quilt", "Quilt_Tile",
                                 "Quilt_Aspect", "View_Cone"}));
  }
}

/// Data of a print ask for what makes a print.
void settle_depth(RenderOptions& o) {
  if (o.sheet_distance && !o.sheet_at.empty()) {
    throw OptionError(
        with_said("Sheet_Distance and Sheet_At both say where the sheet stands: give one of them",
                  o, {"Sheet_Distance", "Sheet_At"}));
  }
  const bool has_sheet = o.lenticular && (!o.views.quilt || o.views.count);
  const bool has_print_data =
      o.sheet_width || o.lens.print_dpi || o.lens.print_lpi || !o.lens_sheet.empty();
  if (!o.lens.depth && has_sheet && has_print_data) o.lens.depth = camera::DepthMode::kPrint;
}

constexpr const char* kSceneIni = "--scene-ini";

bool is_scene_ini(const std::string& text) {
  return text == kSceneIni || text.starts_with(std::string(kSceneIni) + "=");
}

/// `users`: null: the user's own words alone.
RenderOptions read_words(const std::string& default_ini, std::span<const std::string> arguments,
                         const RenderOptions* users = nullptr, bool trusts_scene_folder = true) {
  RenderOptions options;
  OptionsReader reader(options, users, trusts_scene_folder);
  if (!default_ini.empty()) {
    GivenOption given;
    given.from_defaults = true;
    reader.file({default_ini, "", false}, default_ini, given, 1);
  }
  for (std::size_t at = 0; at < arguments.size(); ++at) {
    const std::string text = arguments[at];
    GivenOption given;
    given.shown = text;
    std::size_t equals = 0;
    if (text.empty()) continue;
    if (is_scene_ini(text)) {
      reader.scene_file(file_of(arguments, at, kSceneIni));
    } else if (arguments.size() == 1 && (text == "+H" || text == "+h" || text == "-h")) {
      options.help = true;
    } else if (long_option(arguments, at, options)) {
      continue;
    } else if ((text.front() == '+' || text.front() == '-') && text.size() > 1) {
      reader.switched(text, given);
    } else if (looks_like_option(text, equals) && !is_scene_name(text, equals)) {
      given.value = unquoted(text.substr(equals + 1));
      reader.named(text.substr(0, equals), given, 0);
    } else {
      reader.bare(text, given, 1);
    }
  }
  return options;
}

/// What options mean together.
void settle_all(RenderOptions& options) {
  const bool has_grey = options.type == core::FileType::png ||
                        options.type == core::FileType::ppm || options.type == core::FileType::tiff;
  if (options.grayscale && !has_grey) {
    throw OptionError("Grayscale_Output: there is grey in PNG, PPM and TIFF files only");
  }
  settle(options);
  if (options.all_console) {
    options.debug_console = options.warning_console = options.statistic_console =
        options.render_console = options.fatal_console = *options.all_console;
  }
}

void add_folders(std::vector<std::string>& to, std::span<const std::string> folders) {
  for (const std::string& folder : folders) {
    if (!fs::is_directory(folder, core::ignored_error())) continue;
    if (std::ranges::find(to, folder) == to.end()) to.push_back(folder);
  }
}

/// The first that exists.
std::string first_ini(std::span<const std::string> names) {
  const auto found = std::ranges::find_if(names, is_file);
  return found == names.end() ? "" : *found;
}

/// Whether the command line restricts whatever INI files of defaults say. Of those, the one that may
/// be a stranger's is then not opened.
bool restricts(std::span<const std::string> arguments) {
  try {
    return read_words("", arguments).restrict_io;
  } catch (const OptionError&) {
    return false;  // told when all is read
  }
}

/// What the run may read and write follows from the user's words. Those of the scene's INI file are read when they
/// are known, and change nothing of that.
RenderOptions read_all(std::span<const std::string> arguments, const OptionSources& sources) {
  const std::vector<std::string>& inis = sources.default_ini_files;
  std::string ini = first_ini(inis);
  // The folder's may have come with the scene, and could name folders, files and commands.
  const bool is_left_out =
      ini == kFolderIni && (restricts(arguments) || read_words(ini, arguments).restrict_io);
  if (is_left_out) ini = first_ini({std::ranges::find(inis, kFolderIni) + 1, inis.end()});
  RenderOptions users = read_words(ini, arguments);
  users.restrict_io = users.restrict_io || is_left_out;
  RenderOptions options = std::ranges::any_of(arguments, is_scene_ini)
                              ? read_words(ini, arguments, &users, sources.trusts_scene_folder)
                              : users;
  options.restrict_io = users.restrict_io;
  options.users_libraries = users.library_paths;
  if (is_left_out) {
    options.warnings.emplace_back(
        "Restrict_IO=On: the current folder's povray.ini is not read; name it to have it read");
  }
  settle_all(options);
  add_folders(options.library_paths, sources.standard_libraries);
  add_folders(options.users_libraries, sources.standard_libraries);
  return options;
}

}  // namespace

RenderOptions read_options(std::span<const std::string> arguments, const OptionSources& sources) {
  RenderOptions options = read_all(arguments, sources);
  if (options.help || options.version || options.list_lens_sheets) return options;
  apply_lens_sheet(options, sources.lens_sheet_files);
  settle_depth(options);
  fit_picture_to_sheet(options);
  return options;
}

std::string output_path(const RenderOptions& options, core::FileType& type) {
  type = options.type;
  const std::string& out = options.output;
  if (out == "-") return "-";
  // A device takes the bytes as they come.
  if (!out.empty() && fs::exists(out, core::ignored_error()) &&
      !fs::is_regular_file(out, core::ignored_error()) &&
      !fs::is_directory(out, core::ignored_error())) {
    return out;
  }
  std::string_view end;
  if (!options.type_given) end = choosing_extension(out, type);
  if (type == core::FileType::tiff && ends_with(out, ".tiff")) end = ".tiff";
  const bool any_case = !end.empty();
  const std::string usual = core::extension_of(type);
  if (!any_case) end = usual;
  const std::string scene = options.input == "-" ? "stdin" : options.input;
  std::string folder = out.substr(0, out.rfind('/') + 1), name = out.substr(folder.size());
  // A stranger's folder may hold a link under that name.
  if (out.empty() && !options.restrict_io) folder = scene.substr(0, scene.rfind('/') + 1);
  if (name.empty() || name == end) {
    name = fs::path(scene).stem().string();
  } else if (name.back() == '.') {
    name.pop_back();
  } else if (any_case ? ends_with(name, end) : name.ends_with(end)) {
    end = std::string_view(out).substr(out.size() - end.size());
    name.resize(name.size() - end.size());
  }
  return folder + name + options.frame_digits + std::string(end);
}

std::optional<std::uint32_t> rendered_view(const RenderOptions& options) {
  if (options.view || options.animation.views.count == 0) return options.view;
  // Before the first one the options as a whole are asked.
  return static_cast<std::uint32_t>(std::strtoul(options.frame_digits.c_str(), nullptr, 10));
}

std::string frame_path(const RenderOptions& options, const std::string& path) {
  const fs::path whole = path;
  return (whole.parent_path() /
          (whole.stem().string() + options.frame_digits + whole.extension().string()))
      .string();
}

void check_pixels(const RenderOptions& o) {
  if (o.max_pixels == 0.0) return;
  const bool has_views = o.animation.views.count > 0 && o.views.size;
  const double width = has_views ? o.views.size->width : static_cast<double>(o.width);
  const double height = has_views ? o.views.size->height : static_cast<double>(o.height);
  const std::size_t pictures = is_animation(o.animation) ? frames_of(o.animation).size() : 1;
  const double pixels = width * height * static_cast<double>(pictures);
  if (pixels <= o.max_pixels) return;
  throw OptionError(with_said(
      core::formed("%s%.0f x %.0f pixels are more than the %.0f of Max_Pixels",
                   pictures == 1 ? "" : (std::to_string(pictures) + " pictures of ").c_str(), width,
                   height, o.max_pixels),
      o, {"Width", "Height", "View_Size", "Views", "Initial_Frame", "Final_Frame"}));
}

void check_picture_size(std::int64_t width, std::int64_t height, double bytes_a_row,
                        double memory) {
  constexpr double kMost = 1024.0 * 1024.0 * 1024.0 * 1024.0;
  const std::string picture =
      "a picture of " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  if (bytes_a_row > memory) {
    throw OptionError(picture + " needs " + core::memory_text(bytes_a_row) +
                      " of memory for a row; there are " + core::memory_text(memory));
  }
  if (static_cast<double>(width) * static_cast<double>(height) > kMost) {
    throw OptionError(picture + " is too large: the limit is 1048576 x 1048576");
  }
}

}  // namespace lentray::parser
