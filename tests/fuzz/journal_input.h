// One input of the fuzzer of what a run is continued with (+C, +RFI): the journal of a picture, what passes kept, a kept pass of
// radiosity, POV-Ray's samples. Its first bytes say which. What such a file depends on counts as unchanged, and its checksums
// are mended, so that a small picture is made with what it says. What is wrong with it ends in a message; everything else that
// goes wrong is a fault.
#pragma once

#include <cstdint>
#include <string>

namespace lentray::test {

std::string use_journal(const std::uint8_t* data, std::size_t size);

}  // namespace lentray::test
