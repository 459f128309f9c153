// Where the radiosity of pictures is kept (+RF, +RFI, +RFO), so that it is paid once for all pictures that
// share it.
//
// A name that ends in .rca is a file of POV-Ray's: samples without all that belongs to them. A pass begins
// with them, and what it adds is written when the picture is there. Any other name is a file with a whole
// pass, which takes the place of the pass of a picture that depends on the same: the file is written as soon
// as the pass is over. A name that ends in '/', or that of a folder, stands for a file in it, named by what
// the pass depends on: pictures of all kinds share a folder, and equal passes have equal bits, so that any
// number of runs may keep the same one at once.
//
// Files are written beside their place and renamed. Errors: parser::OptionError for what cannot be used or
// kept; a folder's file is made anew instead, with a warning. One thread.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/irradiance/rca_samples.h"
#include "parser/options/options.h"
#include "tools/session/identity.h"
#include "tools/session/radiosity_file.h"

namespace lentray::tool {

class RadiosityStore {
 public:
  /// `identity`: what the pass depends on.
  RadiosityStore(const parser::RenderOptions& options, const Identity& identity);
  /// The file that the run writes at the end of a pass or picture; empty: none that is known beforehand.
  static std::string output(const parser::RenderOptions& options);
  /// The file of samples that pictures depend on; empty: none, or one that pictures add to.
  static std::string input(const parser::RenderOptions& options);

  /// Reads what there is.
  void read();
  /// A pass that was kept. Without a cache there is none.
  SavedRadiosity pass(const core::RadiositySettings& settings, const core::Vec3& eye);
  /// Samples that a pass begins with.
  const std::vector<core::DepthSample>& samples() const { return m_samples; }

  /// After the pass.
  void keep(const core::IrradianceCache& cache, const core::RadiosityReport& report);
  /// The picture is there.
  void finish();
  const std::vector<std::string>& warnings() const { return m_warnings; }
  /// The file that is used; empty: none is.
  const std::string& used() const { return m_used; }

 private:
  void refuse(const std::string& why);
  void read_samples(const std::string& text);
  void write(const std::string& bytes);

  const bool m_reads, m_writes, m_is_folder, m_is_stock;
  const Identity m_identity;
  const std::string m_path;
  std::string m_bytes;                       ///< of the file that was read
  std::string_view m_pass;                   ///< of m_bytes
  std::optional<std::string> m_lines;        ///< stock's, to be written
  std::vector<core::DepthSample> m_samples;  ///< that were read
  std::vector<std::string> m_warnings;
  std::string m_used, m_trouble;
};

}  // namespace lentray::tool
