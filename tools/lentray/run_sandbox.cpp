#include "tools/lentray/run_sandbox.h"

#include <fcntl.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/ignored_error.h"
#include "parser/restrictions/povray_conf.h"
#include "parser/restrictions/run_rules.h"
#include "tools/common/sandbox.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;
using parser::RenderOptions;

/// Libraries that are loaded when they are needed, and what they and the program ask of the machine.
constexpr const char* kSystemPlaces[] = {"/usr",
                                         "/lib",
                                         "/lib64",
                                         "/opt",
                                         "/etc/ld.so.cache",
                                         "/etc/localtime",
                                         "/sys/devices/system",
                                         "/sys/fs/cgroup",
                                         "/sys/kernel/mm",
                                         "/proc/cpuinfo",
                                         "/proc/meminfo",
                                         "/proc/stat",
                                         "/proc/sys/vm",
                                         "/dev/urandom"};
constexpr const char* kEndlessFiles[] = {"/dev/null", "/dev/zero", "/dev/full"};

/// A file is written beside its place and renamed; what is no plain file goes through a temporary one.
void add_output(const std::string& name, SandboxPlaces& places) {
  if (name.empty()) return;
  const fs::path place = fs::absolute(name, core::ignored_error());
  const fs::file_status status = fs::status(place, core::ignored_error());
  if (name == "-" || (fs::exists(status) && !fs::is_regular_file(status)))
    places.writes.push_back(fs::temp_directory_path(core::ignored_error()));
  if (name == "-") return;
  const fs::path real = fs::weakly_canonical(place, core::ignored_error());
  places.writes.push_back(real);
  fs::path folder = real.parent_path();
  while (!fs::exists(folder, core::ignored_error()) && folder.has_relative_path())
    folder = folder.parent_path();
  if (folder.has_relative_path()) places.writes.push_back(folder);
}

SandboxPlaces places_of(const RenderOptions& o) {
  std::vector<std::string> said_elsewhere;
  const parser::FileRules rules = parser::run_rules(o, o.input, said_elsewhere);
  SandboxPlaces places{rules.readable(), rules.writable()};
  for (const char* place : kSystemPlaces) places.reads.emplace_back(place);
  for (const std::string& conf : parser::conf_places()) places.reads.emplace_back(conf);
  places.reads.push_back(fs::read_symlink("/proc/self/exe", core::ignored_error()).parent_path());
  places.reads.emplace_back("/proc/self");
  places.writes.insert(places.writes.end(), std::begin(kEndlessFiles), std::end(kEndlessFiles));
  for (const std::string& name : parser::outputs_of(o)) add_output(name, places);
  add_output(o.radiosity_file, places);  // which may be read alone
  if (o.input == "-") add_output("-", places);
  return places;
}

bool runs_commands(const RenderOptions& o) {
  return std::ranges::any_of(o.commands,
                             [](const auto& command) { return !command.text.empty(); }) &&
         parser::shellout_allowed(parser::installed_confs());
}

}  // namespace

std::string enter_sandbox(const RenderOptions& o) {
  if (!o.restrict_io) return {};
  constexpr const char* kNone = "Restrict_IO=On: without a sandbox beneath the rules: ";
  if (runs_commands(o)) return std::string(kNone) + "commands of INI files are run";
  // Its entry lives as long as the process: a rule is of that very entry.
  [[maybe_unused]] static const int own_entry = ::open("/proc/self", O_PATH | O_CLOEXEC);
  if (const std::string lack = bound_files(places_of(o)); !lack.empty()) return kNone + lack;
  const std::string lack = bound_calls();
  return lack.empty() ? "" : kNone + lack;
}

}  // namespace lentray::tool
