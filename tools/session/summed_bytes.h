// What the program's own files are made of: a mark that says what kind of file it is, and pieces with their
// lengths and checksums. Bytes are of this machine's kind. Errors: none; what is not whole is not taken.
// Threads: any.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace lentray::tool {

/// Work that is kept is written so often, or once so many bytes wait.
constexpr std::chrono::milliseconds kBetweenWrites{500};
constexpr std::size_t kMostPending = 4 << 20;

/// How a file begins.
struct FileMark {
  char kind[16];
  std::uint64_t version;
};
/// From the front of `bytes`, which loses it. False if they do not begin so.
bool take_mark(std::string_view& bytes, const FileMark& mark);

void append_summed(std::string_view piece, std::string& out);
/// The same of a piece.
bool take_summed(std::string_view& bytes, std::string_view& piece);

/// Takes an open file for work that is kept, and empties it. Why that cannot be done; empty: it is done.
std::string take_file(int file, const std::string& path);
/// Removes such a file, whatever somebody has made of its bytes since, if the path still leads to it.
void remove_taken(int file, const std::string& path);

}  // namespace lentray::tool
