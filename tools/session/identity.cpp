#include "tools/session/identity.h"

#include <elf.h>
#include <link.h>

#include <cinttypes>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "core/base/formed.h"
#include "parser/files/watched_files.h"
#include "parser/options/create_ini.h"
#include "tools/common/version.h"

namespace lentray::tool {
namespace {

std::string hexadecimal(std::uint64_t value) { return core::formed("%016" PRIx64, value); }

/// The build id that linkers put into a program's notes.
int read_build_id(dl_phdr_info* info, std::size_t, void* out) {
  for (int i = 0; i < info->dlpi_phnum; ++i) {
    const ElfW(Phdr)& part = info->dlpi_phdr[i];
    if (part.p_type != PT_NOTE) continue;
    const char* at = reinterpret_cast<const char*>(info->dlpi_addr + part.p_vaddr);
    const char* const end = at + part.p_memsz;
    while (at + sizeof(ElfW(Nhdr)) <= end) {
      ElfW(Nhdr) note;
      std::memcpy(&note, at, sizeof note);
      const char* const name = at + sizeof note;
      const char* const bytes = name + (note.n_namesz + 3) / 4 * 4;
      at = bytes + (note.n_descsz + 3) / 4 * 4;
      if (note.n_type != NT_GNU_BUILD_ID || note.n_namesz != 4 || std::memcmp(name, "GNU", 4) != 0)
        continue;
      *static_cast<std::string*>(out) = hexadecimal(parser::checksum({bytes, note.n_descsz}));
      return 1;
    }
  }
  return 1;  // the program itself comes first; libraries are not asked
}

std::string program() {
  std::string build;
  dl_iterate_phdr(&read_build_id, &build);
  return std::string(kVersion) + " " + build;
}

/// The first line that one text has and the other has not.
std::string other_line(const std::string& text, const std::string& other) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (("\n" + other).find("\n" + line + "\n") == std::string::npos) return line;
  }
  return "nothing";
}

const char* shown(const std::string& path) { return path.empty() ? "the scene" : path.c_str(); }

}  // namespace

std::string Identity::text() const {
  std::string out = "program " + program + "\n";
  std::istringstream lines(options);
  for (std::string line; std::getline(lines, line);) out += "option " + line + "\n";
  for (const auto& [path, sum] : files) out += "file " + hexadecimal(sum) + " " + path + "\n";
  return out;
}

std::string Identity::sum() const { return hexadecimal(parser::checksum(text())); }

Identity Identity::of_text(const std::string& text) {
  Identity out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto rest = [&line](const char* word) {
      return line.substr(std::min(line.size(), std::strlen(word)));
    };
    if (line.starts_with("program ")) {
      out.program = rest("program ");
    } else if (line.starts_with("option ")) {
      out.options += rest("option ") + "\n";
    } else if (line.starts_with("file ") && line.size() >= 22) {
      out.files[line.substr(22)] = std::stoull(line.substr(5, 16), nullptr, 16);
    } else {
      throw std::invalid_argument(line);
    }
  }
  return out;
}

std::string clock_line(const parser::FrameClock& f) {
  return core::formed("clock %.17g of %.17g to %.17g, delta %.17g, on %d\n", f.clock,
                      f.initial_clock, f.final_clock, f.clock_delta, int{f.clock_on});
}

std::string frame_number_line(const parser::FrameClock& f) {
  return core::formed("frame %d of %d to %d\n", f.frame_number, f.initial_frame, f.final_frame);
}

Identity identity_of(const parser::RenderOptions& options, const parser::FrameClock& clock) {
  return {
      program(), parser::picture_lines(options) + clock_line(clock) + frame_number_line(clock), {}};
}

std::string difference(const Identity& then, const Identity& now) {
  if (then.program != now.program) return "another version of the program began it";
  if (then.options != now.options) {
    return "it was begun with " + other_line(then.options, now.options) + ", and now there is " +
           other_line(now.options, then.options);
  }
  for (const auto& [path, sum] : now.files) {
    const auto at = then.files.find(path);
    if (at == then.files.end() || at->second != sum)
      return std::string(shown(path)) + " has changed";
  }
  for (const auto& [path, sum] : then.files) {
    if (!now.files.contains(path)) return std::string(shown(path)) + " is not read any more";
  }
  return "";
}

std::string difference_of_files(const Identity& then, const std::string& scene) {
  for (const auto& [path, sum] : then.files) {
    if (parser::file_checksum(path.empty() ? scene : path) != sum)
      return std::string(shown(path)) + " has changed";
  }
  return "";
}

}  // namespace lentray::tool
