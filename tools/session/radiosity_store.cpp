#include "tools/session/radiosity_store.h"

#include <filesystem>

#include "core/base/ignored_error.h"
#include "core/image/writer.h"
#include "parser/options/ini.h"
#include "tools/common/process.h"

namespace lentray::tool {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& name) {
  return name.ends_with('/') || fs::is_directory(name, core::ignored_error());
}

bool is_stock(const std::string& name) {
  return parser::same_word(fs::path(name).extension().string(), ".rca");
}

bool is_there(const std::string& path) { return fs::is_regular_file(path, core::ignored_error()); }

}  // namespace

RadiosityStore::RadiosityStore(const parser::RenderOptions& o, const Identity& identity)
    : m_reads(o.radiosity_from_file), m_writes(o.radiosity_to_file),
      m_is_folder(is_folder(o.radiosity_file)),
      m_is_stock(!m_is_folder && is_stock(o.radiosity_file)), m_identity(identity),
      m_path(m_is_folder
                 ? (fs::path(o.radiosity_file) / (identity.sum() + ".lentray-light")).string()
                 : o.radiosity_file) {}

std::string RadiosityStore::output(const parser::RenderOptions& o) {
  return o.radiosity_to_file && !is_folder(o.radiosity_file) ? o.radiosity_file : "";
}

std::string RadiosityStore::input(const parser::RenderOptions& o) {
  return o.radiosity_from_file && !o.radiosity_to_file && !is_folder(o.radiosity_file) &&
                 is_stock(o.radiosity_file) && is_there(o.radiosity_file)
             ? o.radiosity_file
             : "";
}

void RadiosityStore::read() {
  if (!m_reads) return;
  if (!is_there(m_path)) {
    if (!m_writes && !m_is_folder)
      m_warnings.push_back("there is no '" + m_path + "': radiosity is made anew");
    return;
  }
  m_bytes = file_bytes(m_path);
  if (m_is_stock && !is_radiosity_file(m_bytes)) return read_samples(m_bytes);
  if (m_is_stock || !is_radiosity_file(m_bytes)) {
    return refuse(m_is_stock ? "it is not POV-Ray's, which the end of its name says"
                             : "it is no radiosity of this program; POV-Ray's ends in .rca");
  }
  if (const std::string fault = fault_of_radiosity(m_bytes, m_identity, m_pass); !fault.empty())
    refuse(fault);
}

void RadiosityStore::refuse(const std::string& why) {
  m_pass = {};
  const std::string text = "the radiosity in '" + m_path + "' cannot be used: " + why;
  if (!m_is_folder) {
    throw parser::OptionError(text +
                              " (without +RFI it is made anew; in a folder, named with '/' at "
                              "its end, each has a file of its own)");
  }
  m_warnings.push_back(text + "; it is made anew");
}

void RadiosityStore::read_samples(const std::string& text) {
  core::RcaSamples read = core::read_rca_samples(text);
  m_samples = std::move(read.samples);
  if (read.passed_over > 0) {
    m_warnings.push_back(m_path + ":" + std::to_string(read.first_passed_over) +
                         ": no sample of radiosity; " + std::to_string(read.passed_over) +
                         " such lines are passed over");
  }
  if (m_samples.empty()) m_warnings.push_back("'" + m_path + "' holds no samples of radiosity");
  m_used = m_path;
}

SavedRadiosity RadiosityStore::pass(const core::RadiositySettings& settings,
                                    const core::Vec3& eye) {
  if (m_pass.empty()) return {};
  SavedRadiosity out = radiosity_of(m_pass, settings, eye);
  if (out.cache) {
    m_used = m_path;
  } else {
    refuse("it is damaged");
  }
  return out;
}

void RadiosityStore::keep(const core::IrradianceCache& cache, const core::RadiosityReport& report) {
  if (!m_writes) return;
  if (!m_is_stock) return write(radiosity_file(m_identity, cache, report));
  std::vector<std::size_t> known(static_cast<std::size_t>(cache.depths()));
  for (const core::DepthSample& one : m_samples) {
    if (one.depth < cache.depths()) ++known[static_cast<std::size_t>(one.depth)];
  }
  m_lines = m_bytes;
  if (!m_lines->empty() && !m_lines->ends_with('\n')) *m_lines += '\n';
  *m_lines += core::rca_samples_text(cache, known) + "\n";
}

void RadiosityStore::finish() {
  if (m_lines) write(*m_lines);
  if (m_trouble.empty()) return;
  if (!m_is_folder) throw parser::OptionError(m_trouble);
  m_warnings.push_back(m_trouble);
}

/// A picture is not lost because of it.
void RadiosityStore::write(const std::string& bytes) {
  try {
    if (m_is_folder) {
      fs::create_directories(fs::path(m_path).parent_path(), core::ignored_error());
    }
    write_whole(m_path, bytes);
  } catch (const core::ImageError& error) {
    m_trouble = std::string("the radiosity could not be kept: ") + error.what();
  }
}

}  // namespace lentray::tool
