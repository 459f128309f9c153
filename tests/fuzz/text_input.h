// One input of the fuzzers of files that say what is to be done: INI files and the rows of a batch. A message is what users get;
// everything else that goes wrong is a fault.
// Errors: std::logic_error where what is written is not what is read again.
#pragma once

#include <cstdint>
#include <string>

namespace lentray::test {

/// An INI file, as one that is named on the command line, as one that came with a scene, and as profiles of lens sheets. What
/// Create_Ini would write of it is read again.
std::string use_ini(const std::uint8_t* data, std::size_t size);

/// The rows of a manifest, or of a worker, as the page shows them and as they are written again.
std::string use_manifest(const std::uint8_t* data, std::size_t size);

}  // namespace lentray::test
