// Random programs of SDL, without errors by construction: expressions of floats, vectors and strings,
// loops, conditions, macros with references, arrays, functions. The same seed makes the same program
// everywhere. Values stay small, so that neither infinities nor nan come up (their signs differ).
#pragma once

#include <cstdint>
#include <string>

namespace lentray::test {

/// A program that writes what it computes by W(string); names begin with `prefix`.
std::string random_program(std::uint32_t seed, const std::string& prefix);

}  // namespace lentray::test
