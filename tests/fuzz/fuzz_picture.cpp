// libFuzzer's entry: inputs are pictures; see tests/fuzz/fuzz.sh.
#include "tests/fuzz/file_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  lentray::test::use_picture(data, size);
  return 0;
}
