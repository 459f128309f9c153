#include "parser/interpreter/script_files.h"

#include <algorithm>
#include <cmath>

#include "parser/base/shown.h"
#include "parser/base/text.h"
#include "parser/interpreter/interpreter.h"
#include "parser/values/number_text.h"

namespace lentray::parser {

struct BinaryFormat {
  Keyword keyword;
  double lowest, highest;
  int bytes;
  bool big_endian;
};

namespace {

constexpr std::size_t kPiece = 500;  // tokens of a data file that are made at a time

constexpr BinaryFormat kFormats[] = {
    {Keyword::kSint8, -128, 127, 1, false},
    {Keyword::kUint8, 0, 255, 1, false},
    {Keyword::kSint16be, -32768, 32767, 2, true},
    {Keyword::kSint16le, -32768, 32767, 2, false},
    {Keyword::kUint16be, 0, 65535, 2, true},
    {Keyword::kUint16le, 0, 65535, 2, false},
    {Keyword::kSint32be, -2147483648.0, 2147483647.0, 4, true},
    {Keyword::kSint32le, -2147483648.0, 2147483647.0, 4, false},
};

const BinaryFormat* binary_format(const Token& t) {
  if (t.kind != TokenKind::kKeyword) return nullptr;
  const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                   [&](const BinaryFormat& f) { return f.keyword == t.keyword; });
  return found == std::end(kFormats) ? nullptr : found;
}

// What stock writes of the text from `start` on.
void only_ascii(std::string& text, std::size_t start) {
  if (is_ascii(std::string_view(text).substr(start))) return;
  text.replace(start, text.npos, to_ascii(text.substr(start)));
}

void append_value(std::string& text, const Number& n) {
  if (n.size > 1) text += '<';
  for (int i = 0; i < n.size; ++i) {
    if (i) text += ',';
    append_general(text, n.v[static_cast<std::size_t>(i)]);
  }
  if (n.size > 1) text += "> ";
}

}  // namespace

ScriptFile::~ScriptFile() {
  if (std::string message = close(); !message.empty()) lost->push_back({where, std::move(message)});
}

std::string ScriptFile::close() {
  const std::string wrong = out ? out->close() : "";
  out.reset();
  return wrong.empty() ? "" : "'" + shown_name(path) + "' was not written whole: " + wrong;
}

void ScriptFiles::finish() {
  for (const auto& written : m_written) {
    const auto file = written.lock();
    if (!file) continue;
    if (const std::string message = file->close(); !message.empty())
      m_in.fail(file->where, message);
  }
  if (!m_lost->empty()) m_in.fail(m_lost->front().where, m_lost->front().message);
}

void ScriptFiles::open() {
  TokenReader& tokens = m_in.tokens;
  const Token name = tokens.read_name("an identifier for the file");
  tokens.skip();
  const Location where = tokens.peek_operand().where;
  auto file = std::make_shared<ScriptFile>();
  file->path = m_in.expressions.parse_path();
  file->where = where;
  if (tokens.accept(Keyword::kRead)) {
    const auto found = m_in.find_file(file->path, where);
    // Always read anew: this scene may have written it.
    const auto number =
        found ? m_in.ask_files(where, [&](Files&) { return m_in.sources.load(*found); })
              : std::nullopt;
    if (!number) m_in.fail(where, "cannot open '" + shown_name(file->path) + "' for reading");
    file->in = std::make_unique<TokenPieces>(*number, m_in.sources.text(*number), m_in.names);
    file->in->next(kPiece);
  } else {
    const bool append = tokens.accept(Keyword::kAppend);
    if (!append) tokens.expect(Keyword::kWrite);
    m_in.check_file_name(file->path, where);
    file->out = m_in.ask_files(where, [&](Files& files) { return files.open(file->path, append); });
    if (!file->out) m_in.fail(where, "cannot open '" + shown_name(file->path) + "' for writing");
    file->lost = m_lost;
    m_written.push_back(file);
    m_in.texts.erase(file->path);
  }
  Symbol& symbol = m_in.symbols.declare_global(name.name);
  symbol.reset({});
  symbol.edit_extras().file = std::move(file);
}

std::shared_ptr<ScriptFile> ScriptFiles::file(bool closing) {
  const Token name = m_in.tokens.read_name("the identifier of an open file");
  Symbol* symbol = m_in.tokens.symbol();
  if (!symbol || !symbol->file()) {
    m_in.fail(name.where, "'" + std::string(m_in.names.text(name.name)) + "' is not an open file");
  }
  auto file = symbol->extras->file;
  m_in.tokens.skip();
  if (closing) {
    m_in.texts.erase(file->path);
    symbol->extras->file.reset();
    m_in.symbols.remove(name.name);
    if (const std::string message = file->close(); !message.empty()) m_in.fail(name.where, message);
  }
  return file;
}

void ScriptFiles::close() {
  // A file read to its end is closed and its identifier gone: closing it once more is no mistake.
  m_in.tokens.read_name("the identifier of an open file");
  if (m_in.tokens.symbol())
    file(true);
  else
    m_in.tokens.skip();
}

void ScriptFiles::write() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Location where = tokens.peek_operand().where;
  const auto out = file(false);
  if (!out->out) m_in.fail(where, "'" + out->path + "' is open for reading, not for writing");
  constexpr std::size_t kUsual = 120;
  std::string text;
  text.reserve(kUsual);
  for (;;) {
    const std::size_t start = text.size();
    Number n;
    const Token* item = tokens.raw();
    if (item && item->is(Punct::kComma)) ++item;
    switch (m_in.expressions.read_plain_item(item, n, text)) {
      case Expressions::Item::kNumber: append_value(text, n); continue;
      case Expressions::Item::kString: only_ascii(text, start); continue;
      default: break;
    }
    if (tokens.accept(Punct::kComma)) continue;
    if (tokens.accept(Punct::kRightParen)) break;
    if (const BinaryFormat* format = binary_format(tokens.peek())) {
      tokens.skip();
      write_binary(text, *format);
    } else if (m_in.expressions.at_string()) {
      m_in.expressions.append_string(text);
      only_ascii(text, start);
    } else if (m_in.expressions.at_expression()) {
      append_value(text, m_in.expressions.parse_additive());
    } else {
      tokens.fail_expected("a string, float or vector to write");
    }
  }
  // A directive or macro among what is written may have closed it.
  if (!out->out)
    m_in.fail(where, "'" + shown_name(out->path) + "' was closed while #write was read");
  const std::string wrong = out->out->write(text);
  if (!wrong.empty()) m_in.fail(where, "cannot write '" + shown_name(out->path) + "': " + wrong);
}

void ScriptFiles::write_binary(std::string& text, const BinaryFormat& format) {
  m_in.tokens.comma();
  while (m_in.expressions.at_expression()) {
    const Number n = m_in.expressions.parse_additive();
    for (int i = 0; i < n.size; ++i) {
      const double rounded = std::floor(n.v[static_cast<std::size_t>(i)] + 0.5);
      const double value =
          std::isnan(rounded) ? format.lowest : std::clamp(rounded, format.lowest, format.highest);
      const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(value));
      for (int b = 0; b < format.bytes; ++b) {
        const int shift = 8 * (format.big_endian ? format.bytes - 1 - b : b);
        text += static_cast<char>((bits >> shift) & 0xFF);
      }
    }
    m_in.tokens.comma();
  }
}

double ScriptFiles::read_number(ScriptFile& file) {
  double sign = 1.0;
  const auto& all = file.in->list()->tokens;
  const std::size_t size = file.in->list()->size();
  for (; file.position < size; ++file.position) {
    const Token& t = all[file.position];
    if (t.is(Punct::kMinus))
      sign = -sign;
    else if (!t.is(Punct::kPlus))
      break;
  }
  if (file.position >= size || all[file.position].kind != TokenKind::kNumber) {
    m_in.fail(m_in.tokens.location(), "expected a number in '" + file.path + "'");
  }
  return sign * all[file.position++].number;
}

// The next value, if it can be had without tokens.
bool ScriptFiles::read_plain(ScriptFile& file, Value& value) {
  double number = 0.0;
  std::string_view string;
  switch (file.in->plain(number, string)) {
    case PlainValue::kNumber: value = Number::scalar(number); return true;
    case PlainValue::kString:
      if (auto* held = std::get_if<std::string>(&value))
        *held = string;
      else
        value = std::string(string);
      return true;
    default: return false;
  }
}

// False at the end of the file.
bool ScriptFiles::read_value(ScriptFile& file, Value& value) {
  if (file.position >= file.in->list()->size()) {
    if (read_plain(file, value)) return true;
    file.position = 0;
    file.ended = !file.in->next(kPiece);
    if (file.ended) return false;
  }
  const auto& all = file.in->list()->tokens;
  const std::size_t size = file.in->list()->size();
  const Token& t = all[file.position];
  const auto at = [&](Punct p) { return file.position < size && all[file.position].is(p); };
  if (t.kind == TokenKind::kString) {
    value = m_in.names.string(t.name);
    ++file.position;
  } else if (t.is_literal_vector()) {
    Number n;
    n.size = static_cast<int>(t.name);
    std::copy_n(file.in->list()->components.data() + t.jump, t.name, n.v.data());
    n.is_colour = n.size == 5;
    value = n;
    ++file.position;
  } else if (t.is(Punct::kLess)) {
    ++file.position;
    Number n;
    n.size = 0;
    while (!at(Punct::kGreater)) {
      if (n.size == 5) m_in.fail(t.where, "a vector has at most 5 components");
      n.v[static_cast<std::size_t>(n.size++)] = read_number(file);
      if (at(Punct::kComma)) ++file.position;
    }
    ++file.position;
    if (n.size < 2) m_in.fail(t.where, "a vector has at least 2 components");
    n.is_colour = n.size == 5;
    value = n;
  } else if (t.kind == TokenKind::kNumber || t.is(Punct::kMinus) || t.is(Punct::kPlus)) {
    value = Number::scalar(read_number(file));
  } else {
    m_in.fail(t.where, "expected a float, vector or string in a file read by #read");
  }
  // What follows is taken for the comma, whatever it is: so it is in stock.
  if (file.position < size && !at(Punct::kComma)) {
    m_in.warn(all[file.position].where,
              "expected ',' in a file read by #read; what stands there is left out");
  }
  file.ended = file.position >= size;
  if (!file.ended) ++file.position;
  return true;
}

// Most are read into names that hold values already, and nothing else: that symbol, its name and
// the comma before it read.
Symbol* ScriptFiles::plain_target() {
  const Token* name = m_in.tokens.raw();
  if (name && name->is(Punct::kComma)) ++name;
  if (!name || name->kind != TokenKind::kIdentifier ||
      (!name[1].is(Punct::kComma) && !name[1].is(Punct::kRightParen))) {
    return nullptr;
  }
  Symbol* symbol = m_in.symbols.find(name->name);
  if (!symbol || symbol->alias || symbol->extras) return nullptr;
  m_in.tokens.go_on_at(name + 1);
  return symbol;
}

void ScriptFiles::read() {
  TokenReader& tokens = m_in.tokens;
  tokens.expect(Punct::kLeftParen);
  const Token name = tokens.peek_operand();
  const auto in = file(false);
  if (!in->in) m_in.fail(name.where, "'" + in->path + "' is open for writing, not for reading");
  bool more = true;
  for (;;) {
    if (Symbol* plain = plain_target()) {
      if (more) more = read_value(*in, plain->value);
      continue;
    }
    if (tokens.accept(Punct::kRightParen)) break;
    if (tokens.accept(Punct::kComma)) continue;
    const Token target = tokens.read_name("an identifier to read into");
    const auto array = tokens.element_array();
    const std::size_t index = tokens.element_index();
    tokens.skip();
    Value value;
    if (more) more = read_value(*in, value);
    if (!more) continue;
    if (array) {
      array->elements[index] = std::move(value);
      continue;
    }
    m_in.symbols.declare_global(target.name).assign(std::move(value));
  }
  // At the end of the file its identifier is gone, so that `#while (defined(File))` ends.
  if (in->ended) m_in.symbols.remove(name.name);
}

}  // namespace lentray::parser
