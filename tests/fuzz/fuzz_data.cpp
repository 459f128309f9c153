// libFuzzer's entry: inputs are fonts and density files; see tests/fuzz/fuzz.sh.
#include "tests/fuzz/file_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lentray::test::use_font_or_densities(data, size);
  return 0;
}
