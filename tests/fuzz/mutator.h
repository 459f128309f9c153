// Changes a scene's text token by token: what comes out is still SDL for the most part, and so
// gets further into the parser than changed bytes would. The words come from the keyword table.
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace lentray::test {

/// The words, numbers, strings and punctuation of a text, without the space between them.
std::vector<std::string_view> pieces_of(std::string_view text);

class Mutator {
 public:
  explicit Mutator(std::uint32_t seed) : m_random(seed) {}

  /// A changed copy, of at most `most` bytes.
  std::string mutate(std::string_view text, std::size_t most);
  /// Parts of both.
  std::string cross(std::string_view a, std::string_view b, std::size_t most);

 private:
  using Pieces = std::vector<std::string>;
  struct Range {
    std::size_t begin, end;
  };

  std::size_t pick(std::size_t n) { return n == 0 ? 0 : m_random() % n; }
  Range some(const Pieces& pieces, std::size_t most);
  Range block(const Pieces& pieces);
  std::string word();
  std::string number();
  std::string new_piece(const Pieces& pieces);
  void change(Pieces& pieces);
  void insert(Pieces& pieces, std::size_t at, const Pieces& what);

  std::mt19937 m_random;
};

}  // namespace lentray::test
