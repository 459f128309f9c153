// A radiosity pass in a file of its own: all that pictures read of it, bit for bit, and what it did. The file
// begins with what the pass depends on; checksums reveal a damaged one. Pure functions.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/irradiance/irradiance_cache.h"
#include "core/pass/radiosity_pass.h"
#include "tools/session/identity.h"

namespace lentray::tool {

struct SavedRadiosity {
  std::shared_ptr<const core::IrradianceCache> cache{};  ///< null: there is none
  core::RadiosityReport report{};
};

/// The file's bytes.
std::string radiosity_file(const Identity& identity, const core::IrradianceCache& cache,
                           const core::RadiosityReport& report);

/// Whether bytes are such a file, whole or not.
bool is_radiosity_file(std::string_view bytes);
/// Why they are not what is wanted, to follow "cannot be used: "; empty: they are. `pass`: the pass's bytes.
std::string fault_of_radiosity(std::string_view bytes, const Identity& wanted,
                               std::string_view& pass);
/// Without a cache if the bytes are no pass of those settings.
SavedRadiosity radiosity_of(std::string_view pass, const core::RadiositySettings& settings,
                            const core::Vec3& eye);

}  // namespace lentray::tool
