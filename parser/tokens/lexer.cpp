#include "parser/tokens/lexer.h"

#include <array>
#include <charconv>
#include <cstdlib>
#include <string>

#include "parser/base/text.h"
#include "parser/tokens/keywords.h"

namespace lentray::parser {
namespace {

/// What each byte can be part of, and the punctuation that it is by itself.
struct Bytes {
  static constexpr std::uint8_t kDigit = 1, kLetter = 2, kSpace = 4;
  static constexpr std::uint8_t kPlain = 8;  ///< printable ASCII that means itself in a string
  std::array<std::uint8_t, 256> kinds{};
  std::array<Punct, 256> puncts{};

  Bytes() {
    const auto set = [&](std::string_view bytes, std::uint8_t kind) {
      for (const char c : bytes) kinds[static_cast<unsigned char>(c)] |= kind;
    };
    set("0123456789", kDigit);
    set("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", kLetter);
    using namespace std::string_view_literals;
    set(" \t\n\r\f\v\0\x1a"sv, kSpace);  // the last one ends DOS files
    for (std::size_t c = ' '; c < 0x80; ++c) kinds[c] |= c == '"' || c == '\\' ? 0 : kPlain;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(Punct::kBackquote); ++i) {
      const std::string_view written = spelling(static_cast<Punct>(i));
      if (written.size() == 1)
        puncts[static_cast<unsigned char>(written[0])] = static_cast<Punct>(i);
    }
  }
};

const Bytes kBytes;

bool is(char c, std::uint8_t kind) { return kBytes.kinds[static_cast<unsigned char>(c)] & kind; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_word_start(char c) { return is(c, Bytes::kLetter); }
bool is_word(char c) { return is(c, Bytes::kLetter | Bytes::kDigit); }
bool is_space(char c) { return is(c, Bytes::kSpace); }

// The character a one-letter escape stands for; 0 if there is no such escape.
char simple_escape(char c) {
  switch (c) {
    case 'a': return '\a';
    case 'b': return '\b';
    case 'f': return '\f';
    case 'n': return '\n';
    case 'r': return '\r';
    case 't': return '\t';
    case 'v': return '\v';
    case '\\':
    case '"':
    case '\'': return c;
    default: return 0;
  }
}

/// The oldest dialects have directives without the #.
bool is_unmarked_directive(Keyword k) {
  return k == Keyword::kDeclare || k == Keyword::kInclude || k == Keyword::kDefault;
}

/// What #end closes.
bool opens_block(Keyword k) {
  switch (k) {
    case Keyword::kIf:
    case Keyword::kIfdef:
    case Keyword::kIfndef:
    case Keyword::kWhile:
    case Keyword::kFor:
    case Keyword::kSwitch:
    case Keyword::kMacro: return true;
    default: return false;
  }
}

using Tokens = decltype(TokenList::tokens);

}  // namespace

class Lexer {
 public:
  Lexer(std::uint32_t file, std::string_view text, NameTable& names)
      : m_file(file), m_text(text), m_names(names) {}

  /// The rest of the text.
  void run(TokenList& list) {
    begin(list);
    while (skip_space()) one();
    end();
  }

  /// The next piece, of at least so many tokens. False if nothing was left.
  bool run_on(TokenList& list, std::size_t least) {
    begin(list);
    Opened opened;
    while (skip_space()) {
      const std::size_t before = m_tokens->size();
      one();
      if (m_tokens->size() == before + 1 && opened.can_end_behind(m_tokens->back()) &&
          m_tokens->size() >= least) {
        break;
      }
    }
    const bool any = !m_tokens->empty();
    end();
    return any;
  }

  /// The next value, if it and the comma behind it stand in the text as most do, without comments
  /// or escapes; nothing is read otherwise.
  PlainValue plain(double& number, std::string_view& string) {
    const std::size_t pos = m_pos;
    PlainValue found = PlainValue::kNone;
    if (is_space(here())) skip_blanks();
    const char first = here();
    if (first == '"') {
      const std::size_t start = m_pos + 1, end = plain_string_end(start);
      if (end != m_text.npos) {
        string = m_text.substr(start, end - start);
        m_pos = end + 1;
        found = PlainValue::kString;
      }
    } else {
      if (first == '-') ++m_pos;
      if (starts_number()) {
        number = read_number();
        if (first == '-') number = -number;
        found = PlainValue::kNumber;
      }
    }
    if (found != PlainValue::kNone) {
      if (is_space(here())) skip_blanks();
      if (here() == ',') {
        ++m_pos;
        return found;
      }
    }
    m_pos = pos;
    return PlainValue::kNone;
  }

 private:
  /// What is open where a text is being cut.
  struct Opened {
    bool vector = false;
    int brackets = 0, blocks = 0;

    bool can_end_behind(const Token& last) {
      if (last.kind == TokenKind::kDirective) {
        if (opens_block(last.keyword)) ++blocks;
        if (last.keyword == Keyword::kEnd && blocks > 0) --blocks;
        return false;
      }
      if (last.kind != TokenKind::kPunct) return false;
      switch (last.punct) {
        case Punct::kLess: vector = last.name == 0; break;  // it is no whole one
        case Punct::kGreater: vector = false; break;
        case Punct::kLeftParen:
        case Punct::kLeftSquare: ++brackets; break;
        case Punct::kRightParen:
        case Punct::kRightSquare: --brackets; break;
        case Punct::kComma:
        case Punct::kRightCurly: return !vector && brackets <= 0 && blocks <= 0;
        default: break;
      }
      return false;
    }
  };

  void begin(TokenList& list) {
    list.file = m_file;
    m_list = &list;
    m_tokens = &list.tokens;
  }
  void end() {
    link_directives();
    add(TokenKind::kEnd);
  }

  void skip_blanks() {
    while (is_space(here()) && m_pos < m_text.size()) ++m_pos;
  }

  char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
  char here() const { return at(m_pos); }

  Location location() const { return {m_file, static_cast<std::uint32_t>(m_pos)}; }

  // The next token, made where it stays: one that is copied at once has to wait for its own bytes.
  Token& add(TokenKind kind) {
    Token& t = m_tokens->emplace_back();
    t.kind = kind;
    t.where.file = m_file;
    t.where.offset = static_cast<std::uint32_t>(m_pos);
    t.passive =
        kind == TokenKind::kNumber || kind == TokenKind::kString || kind == TokenKind::kPunct;
    return t;
  }

  void bad(const Location& where, std::string message) {
    Token t;
    t.kind = TokenKind::kBad;
    t.where = where;
    t.name = m_names.add_string({}, std::move(message));
    m_tokens->push_back(t);
  }

  // Past spaces and comments; false at the end of the text.
  bool skip_space() {
    for (;;) {
      if (m_pos >= m_text.size()) return false;
      const char c = m_text[m_pos];
      if (is_space(c)) {
        ++m_pos;
      } else if (c == '/' && at(m_pos + 1) == '/') {
        const std::size_t end = m_text.find('\n', m_pos);
        m_pos = end == std::string_view::npos ? m_text.size() : end;
      } else if (c == '/' && at(m_pos + 1) == '*') {
        skip_comment();
      } else {
        return true;
      }
    }
  }

  void skip_comment() {
    const Location start = location();
    int depth = 1;
    m_pos += 2;
    while (depth > 0) {
      if (m_pos >= m_text.size()) {
        bad(start, "comment without its end: expected */");
        return;
      }
      const char c = m_text[m_pos];
      if (c == '/' && at(m_pos + 1) == '*') {
        ++depth;
        m_pos += 2;
      } else if (c == '*' && at(m_pos + 1) == '/') {
        --depth;
        m_pos += 2;
      } else {
        ++m_pos;
      }
    }
  }

  void one() {
    const char c = here();
    if (is_word_start(c)) return word();
    if (starts_number()) return number();
    if (c == '"') return string();
    if (c == '#') return directive();
    punct();
  }

  bool starts_number() const {
    return is_digit(here()) || (here() == '.' && is_digit(at(m_pos + 1)));
  }

  std::string_view read_word() {
    const std::size_t start = m_pos;
    while (is_word(here())) ++m_pos;
    return m_text.substr(start, m_pos - start);
  }

  void word() {
    Token& t = add(TokenKind::kIdentifier);
    t.name = m_names.intern(read_word());
    t.keyword = m_names.keyword(t.name);
    if (t.keyword != Keyword::kNone) {
      t.kind = TokenKind::kKeyword;
      t.passive = !is_unmarked_directive(t.keyword);
    }
  }

  void number() {
    Token& t = add(TokenKind::kNumber);
    t.number = read_number();
  }

  // Most numbers are short: a whole number below 2^53 over a power of ten, both exact, is rounded
  // once, and so correctly.
  double read_number() {
    static constexpr double kPowers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                         1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    constexpr std::size_t kMostDigits = 15;
    const char* const start = m_text.data() + m_pos;
    const char* const end_of_text = m_text.data() + m_text.size();
    const char* p = start;
    std::uint64_t whole = 0;
    const auto digits = [&] {
      for (; p < end_of_text && is_digit(*p); ++p) {
        whole = whole * 10 + static_cast<std::uint64_t>(*p - '0');
      }
    };
    digits();
    std::size_t length = static_cast<std::size_t>(p - start), decimals = 0;
    if (p < end_of_text && *p == '.') {
      const char* const point = p++;
      digits();
      decimals = static_cast<std::size_t>(p - point - 1);
      length += decimals;
    }
    m_pos += static_cast<std::size_t>(p - start);
    bool exponent = false;
    if (here() == 'e' || here() == 'E') {
      std::size_t end = m_pos + 1;
      if (at(end) == '+' || at(end) == '-') ++end;
      exponent = is_digit(at(end));
      if (exponent) {
        while (is_digit(at(end))) ++end;
        m_pos = end;
      }
    }
    if (exponent || length > kMostDigits) {
      const auto size = static_cast<std::size_t>(m_text.data() + m_pos - start);
      return long_number({start, size});
    }
    return decimals ? static_cast<double>(whole) / kPowers[decimals] : static_cast<double>(whole);
  }

  static double long_number(std::string_view digits) {
    double number = 0.0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    // Zero or infinity, as strtod has it.
    if (result.ec == std::errc::result_out_of_range) {
      return std::strtod(std::string(digits).c_str(), nullptr);
    }
    return number;
  }

  void string() {
    const Location where = location();
    if (plain_string()) return;
    const std::size_t start = ++m_pos;
    std::string cooked;
    std::string ascii;  // from the first byte on that is not
    std::string wrong;  // first illegal escape
    for (;;) {
      if (m_pos >= m_text.size()) return bad(where, "string without its end: expected \"");
      const char c = m_text[m_pos];
      if (c == '"') break;
      const std::size_t before = cooked.size();
      const bool foreign = static_cast<unsigned char>(c) > 0x7F;
      if (foreign && ascii.empty()) ascii = cooked;
      if (c != '\\' || !(m_pos + 1 < m_text.size() && escape(cooked, wrong))) {
        cooked += c;
        ++m_pos;
      }
      if (foreign)
        ascii += ' ';
      else if (!ascii.empty())
        ascii.append(cooked, before);
    }
    std::string raw(m_text.substr(start, m_pos - start));
    ++m_pos;
    Token& t = add(TokenKind::kString);
    t.where = where;
    // A wrong escape is no error in a file name, where backslashes are left as they are.
    t.keyword = wrong.empty() ? Keyword::kNone : Keyword::kError;
    t.name = m_names.add_string(std::move(raw), std::move(cooked), std::move(ascii));
  }

  // Most strings are printable ASCII without a backslash: where its quote is, else npos.
  std::size_t plain_string_end(std::size_t end) const {
    while (end < m_text.size() && is(m_text[end], Bytes::kPlain)) ++end;
    return end < m_text.size() && m_text[end] == '"' ? end : m_text.npos;
  }

  bool plain_string() {
    const std::size_t start = m_pos + 1, end = plain_string_end(start);
    if (end == m_text.npos) return false;
    const std::string_view text = m_text.substr(start, end - start);
    add(TokenKind::kString).name = m_names.add_string(std::string(text), std::string(text));
    m_pos = end + 1;
    return true;
  }

  // At a backslash: appends what it stands for and moves past it. False if it stands for nothing.
  bool escape(std::string& cooked, std::string& wrong) {
    const char c = at(m_pos + 1);
    if (const char plain = simple_escape(c)) {
      cooked += plain;
      m_pos += 2;
      return true;
    }
    unsigned code = 0;
    const std::size_t digits = m_pos + 2;
    if (c == 'u' && digits + 4 <= m_text.size() &&
        std::from_chars(m_text.data() + digits, m_text.data() + digits + 4, code, 16).ptr ==
            m_text.data() + digits + 4) {
      cooked += encode_character(code);
      m_pos += 6;
      return true;
    }
    if (wrong.empty()) wrong = std::string("\\") + c;
    return false;
  }

  void directive() {
    const Location where = location();
    ++m_pos;
    const bool word = skip_space() && is_word_start(here());
    Token& t = add(word ? TokenKind::kDirective : TokenKind::kPunct);
    t.where = where;
    t.jump = 0;
    if (word) {
      t.name = m_names.intern(read_word());
      t.keyword = m_names.keyword(t.name);
    } else {
      t.passive = false;  // ignored with a warning when it is read
      t.punct = Punct::kHash;
    }
  }

  void punct() {
    const char c = m_text[m_pos];
    const bool equal_follows = at(m_pos + 1) == '=';
    if (equal_follows && (c == '<' || c == '>' || c == '!')) {
      add(TokenKind::kPunct).punct = c == '<'   ? Punct::kLessEqual
                                     : c == '>' ? Punct::kGreaterEqual
                                                : Punct::kNotEqual;
      m_pos += 2;
      return;
    }
    const Punct punct = kBytes.puncts[static_cast<unsigned char>(c)];
    if (punct != Punct::kNone) {
      if (punct == Punct::kLess && vector()) return;
      add(TokenKind::kPunct).punct = punct;
      ++m_pos;
      return;
    }
    static constexpr char kHex[] = "0123456789ABCDEF";
    const unsigned byte = static_cast<unsigned char>(c);
    bad(location(), std::string("unknown character 0x") + kHex[byte >> 4] + kHex[byte & 15] +
                        " outside a string or comment");
    ++m_pos;
  }

  // Whether what stands at `i` is an operand for sure: `<` is no comparison there.
  bool expects_operand(std::size_t i) const {
    if (i == 0) return false;
    const Token& before = (*m_tokens)[i - 1];
    if (before.kind == TokenKind::kKeyword) {
      return !starts_operand(before.keyword) && i > 1 && !(*m_tokens)[i - 2].is(Punct::kDot);
    }
    if (before.kind != TokenKind::kPunct) return false;
    switch (before.punct) {
      case Punct::kComma:
      case Punct::kLeftCurly:
      case Punct::kLeftParen:
      case Punct::kEqual:
      case Punct::kPlus:
      case Punct::kMinus:
      case Punct::kStar:
      case Punct::kSlash: return true;
      default: return false;
    }
  }

  // At a `<`: numbers as most stand in a text, without comments, up to a `>` are one token where it can only
  // begin a vector. Nothing is read otherwise.
  bool vector() {
    const std::size_t at_token = m_tokens->size();
    if (!expects_operand(at_token)) return false;
    const bool is_matrix = at_token > 0 && (*m_tokens)[at_token - 1].is(Keyword::kMatrix);
    const std::size_t most = is_matrix ? Token::kOfMatrix : Token::kMostOfVector;
    std::vector<double>& components = m_list->components;
    const std::size_t start = m_pos, first = components.size();
    bool ends_in_number;
    do {
      ++m_pos;
      skip_blanks();
      const bool minus = here() == '-';
      if (minus) {
        ++m_pos;
        skip_blanks();
      }
      ends_in_number = starts_number();
      if (!ends_in_number) break;
      const double number = read_number();
      components.push_back(minus ? -number : number);
      skip_blanks();
    } while (here() == ',' && components.size() < first + most);
    const std::size_t end = m_pos, count = components.size() - first;
    m_pos = start;
    if (!ends_in_number || at(end) != '>' || at(end + 1) == '=' || count < (is_matrix ? most : 2)) {
      components.resize(first);
      return false;
    }
    Token& t = add(TokenKind::kPunct);
    t.punct = Punct::kLess;
    t.name = static_cast<NameId>(count);
    t.jump = first;
    m_pos = end + 1;
    return true;
  }

  // Gives every part of a conditional, loop or macro the place of the next part or of its #end,
  // and every #end the place of its opening. What stays open ends with the text.
  void link_directives() {
    struct Open {
      std::size_t first, last;
    };
    Tokens& tokens = *m_tokens;
    std::vector<Open> open;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      Token& t = tokens[i];
      if (t.kind != TokenKind::kDirective) continue;
      if (opens_block(t.keyword)) {
        open.push_back({i, i});
        t.jump = tokens.size();
        continue;
      }
      switch (t.keyword) {
        case Keyword::kElse:
        case Keyword::kElseif:
        case Keyword::kCase:
        case Keyword::kRange:
          t.jump = tokens.size();
          if (!open.empty()) {
            tokens[open.back().last].jump = i;
            open.back().last = i;
          }
          break;
        case Keyword::kEnd:
          if (!open.empty()) {
            tokens[open.back().last].jump = i;
            t.jump = open.back().first;
            open.pop_back();
          } else {
            t.jump = i;
          }
          break;
        default: break;
      }
    }
  }

  const std::uint32_t m_file;
  const std::string_view m_text;
  NameTable& m_names;
  TokenList* m_list = nullptr;
  Tokens* m_tokens = nullptr;
  std::size_t m_pos = 0;
};

std::shared_ptr<const TokenList> tokenise(std::uint32_t file, std::string_view text,
                                          NameTable& names) {
  auto list = std::make_shared<TokenList>();
  list->tokens.reserve(text.size() / 4 + 1);
  Lexer(file, text, names).run(*list);
  list->tokens.shrink_to_fit();
  return list;
}

TokenPieces::TokenPieces(std::uint32_t file, std::string_view text, NameTable& names)
    : m_list(std::make_shared<TokenList>()), m_lexer(std::make_unique<Lexer>(file, text, names)) {}

TokenPieces::~TokenPieces() = default;

bool TokenPieces::next(std::size_t least) {
  if (m_list.use_count() > 1) m_list = std::make_shared<TokenList>();
  m_list->tokens.clear();
  m_list->components.clear();
  return m_lexer->run_on(*m_list, least);
}

PlainValue TokenPieces::plain(double& number, std::string_view& string) {
  return m_lexer->plain(number, string);
}

}  // namespace lentray::parser
