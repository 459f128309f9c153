// One input of the fuzzer: read as a scene, described, built, then forgotten. Nothing touches the
// disk. What is wrong with the input ends in a message; everything else that goes wrong is a fault.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/memory_files.h"

namespace lentray::test {

/// Reads a scene that may include the files of `library`, within small limits. Returns its warnings,
/// and at the end the error that stopped it, if one did.
std::vector<std::string> read_input(std::string_view text,
                                    const MemoryFiles::Library& library = {});

/// The include files of a folder (".inc"), by the name that scenes give them.
MemoryFiles::Library include_files(const std::string& folder);

}  // namespace lentray::test
