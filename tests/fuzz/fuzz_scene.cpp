// The fuzzer of scenes: what entry.cpp gives inputs to, and libFuzzer's mutators, which change tokens.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "tests/fuzz/mutator.h"
#include "tests/fuzz/read_input.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace lentray::test;

std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

std::size_t put(const std::string& text, std::uint8_t* out) {
  std::memcpy(out, text.data(), text.size());
  return text.size();
}

}  // namespace

namespace lentray::test {

/// The messages that end it are of no use here.
std::string use_scene(const std::uint8_t* data, std::size_t size) {
  static const MemoryFiles::Library library = [] {
    const char* folder = std::getenv("LENTRAY_FUZZ_INCLUDES");
    return include_files(folder ? folder : "/usr/share/povray-3.7/include");
  }();
  read_input(text_of(data, size), library);
  return {};
}

}  // namespace lentray::test

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  constexpr unsigned kBytesEvery = 8;  // now and then bytes change, not tokens
  if (seed % kBytesEvery == 0) return LLVMFuzzerMutate(data, size, most);
  return put(Mutator(seed).mutate(text_of(data, size), most), data);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* a, std::size_t a_size,
                                                 const std::uint8_t* b, std::size_t b_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  return put(Mutator(seed).cross(text_of(a, a_size), text_of(b, b_size), most), out);
}
