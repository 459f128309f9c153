// The program's own files with their checksums mended, as whoever forges one would. Pure functions.
#pragma once

#include <string>

namespace lentray::test {

enum class OwnFile { journal, passes, light, samples };

/// By the first bytes.
OwnFile own_file(const std::string& bytes);

/// What is not whole stays as it is.
std::string sealed(std::string bytes);

/// The text of what the file depends on; empty: it has none.
std::string identity_text(const std::string& bytes);

}  // namespace lentray::test
