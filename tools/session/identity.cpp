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
#include "tools/common/json_text.h"
#include "tools/common/version.h"
#include "tools/session/seen_json.h"

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

}  // namespace

static void json_members(auto& io, Of<Identity> auto& identity) {
  io("program", identity.program);
  io("options", identity.options);
  json_members(io, identity.seen);
}

std::string Identity::text() const { return json_text(*this); }

std::string Identity::sum() const { return hexadecimal(parser::checksum(text())); }

Identity Identity::of_text(const std::string& text) try {
  return parse_json(text).get<Identity>();
} catch (const nlohmann::json::exception& error) {
  throw std::invalid_argument(error.what());
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
  return change_of(then.seen, now.seen);
}

}  // namespace lentray::tool
