#include "parser/interpreter/parser.h"

#include <algorithm>
#include <filesystem>

#include "core/image/writer.h"
#include "parser/base/shown.h"
#include "parser/interpreter/interpreter.h"

namespace lentray::parser {

struct Parser::Impl {
  Impl(SourceManager& sources, Diagnostics& diagnostics, const ParserOptions& options,
       Productions& productions, Parser& parser)
      : in(sources, diagnostics, options, productions, parser) {}
  /// What is wrong with it has no place in the scene, but perhaps one in an INI file.
  void include_header() {
    try {
      in.directives.include(in.options.include_header, {});
    } catch (const ParseError& error) {
      const Diagnostic& said = error.diagnostic();
      if (said.where.file != 0 || in.options.header_place.empty()) throw;
      in.diagnostics.fail({},
                          said.message + " (Include_Header in " + in.options.header_place + ")");
    }
  }

  Interpreter in;
};

Parser::Parser(SourceManager& sources, Diagnostics& diagnostics, const ParserOptions& options,
               Productions& productions)
    : m_impl(std::make_unique<Impl>(sources, diagnostics, options, productions, *this)) {}

Parser::~Parser() = default;

void Parser::open(const std::string& path) {
  Interpreter& in = m_impl->in;
  if (!in.push_scene(path)) in.diagnostics.fail({}, "cannot read the scene '" + path + "'");
  in.scene_folder = std::filesystem::path(path).parent_path().string();
  in.declare_constants();
  Symbol& name = in.symbols.declare_global(in.names.intern("input_file_name"));
  name.reset(path);
  name.edit_extras().was_read = &in.reads.name;
  if (!in.options.include_header.empty()) m_impl->include_header();
}

const Token& Parser::peek() { return m_impl->in.tokens.peek(); }
Token Parser::next() { return m_impl->in.tokens.next(); }
void Parser::stop_if_asked() const { m_impl->in.stop_if_asked(); }
const PictureReads& Parser::reads() const { return m_impl->in.reads; }
bool Parser::at_end() { return peek().kind == TokenKind::kEnd; }
bool Parser::at(Keyword keyword) { return m_impl->in.tokens.at(keyword); }
bool Parser::at(Punct punct) { return m_impl->in.tokens.at(punct); }
bool Parser::accept(Keyword keyword) { return m_impl->in.tokens.accept(keyword); }
bool Parser::accept(Punct punct) { return m_impl->in.tokens.accept(punct); }
void Parser::expect(Keyword keyword) { m_impl->in.tokens.expect(keyword); }

void Parser::expect(Punct punct) {
  m_impl->in.guard_stack();  // a brace opens whatever can hold its like
  m_impl->in.tokens.expect(punct);
}

std::size_t Parser::most_levels() const { return m_impl->in.most_levels; }
std::size_t Parser::deepest() const { return m_impl->in.deepest; }
void Parser::note_levels(std::size_t levels) {
  m_impl->in.deepest = std::max(m_impl->in.deepest, levels);
}

bool Parser::at_word(std::string_view word) {
  const Token& t = peek();
  return t.kind == TokenKind::kIdentifier && m_impl->in.names.text(t.name) == word;
}

bool Parser::accept_word(std::string_view word) {
  if (!at_word(word)) return false;
  m_impl->in.tokens.skip();
  return true;
}

std::string_view Parser::spelling(const Token& token) {
  const bool named = token.kind == TokenKind::kIdentifier || token.kind == TokenKind::kKeyword;
  return named ? m_impl->in.names.text(token.name) : std::string_view();
}

const Value* Parser::peek_value() {
  m_impl->in.guard_stack();
  return peek().kind == TokenKind::kIdentifier ? m_impl->in.tokens.value() : nullptr;
}

template <typename T>
std::optional<T> Parser::accept_value() {
  m_impl->in.guard_stack();  // some statements hold their like without a brace between
  if (peek().kind != TokenKind::kIdentifier) return std::nullopt;
  const Value* value = m_impl->in.tokens.value();
  const T* held = value ? std::get_if<T>(value) : nullptr;
  if (!held) return std::nullopt;
  std::optional<T> copy(*held);
  m_impl->in.tokens.skip();
  return copy;
}

template std::optional<Number> Parser::accept_value();
template std::optional<std::string> Parser::accept_value();
template std::optional<std::shared_ptr<ArrayValue>> Parser::accept_value();
template std::optional<Ref<FunctionDesc>> Parser::accept_value();
template std::optional<Ref<SplineDesc>> Parser::accept_value();
template std::optional<Ref<PigmentDesc>> Parser::accept_value();
template std::optional<Ref<NormalDesc>> Parser::accept_value();
template std::optional<Ref<FinishDesc>> Parser::accept_value();
template std::optional<Ref<TextureDesc>> Parser::accept_value();
template std::optional<Ref<InteriorDesc>> Parser::accept_value();
template std::optional<Ref<MaterialDesc>> Parser::accept_value();
template std::optional<Ref<MediaDesc>> Parser::accept_value();
template std::optional<Ref<DensityDesc>> Parser::accept_value();
template std::optional<Ref<ObjectDesc>> Parser::accept_value();
template std::optional<Ref<CameraDesc>> Parser::accept_value();
template std::optional<Ref<FogDesc>> Parser::accept_value();
template std::optional<Ref<RainbowDesc>> Parser::accept_value();
template std::optional<Ref<SkySphereDesc>> Parser::accept_value();
template std::optional<Ref<ColourMapDesc>> Parser::accept_value();
template std::optional<Ref<PigmentMapDesc>> Parser::accept_value();
template std::optional<Ref<NormalMapDesc>> Parser::accept_value();
template std::optional<Ref<SlopeMapDesc>> Parser::accept_value();
template std::optional<Ref<TextureMapDesc>> Parser::accept_value();
template std::optional<Ref<DensityMapDesc>> Parser::accept_value();

double Parser::parse_float() { return m_impl->in.expressions.parse_float(); }

bool Parser::parse_bool() {
  return !m_impl->in.expressions.at_expression() || parse_float() != 0.0;
}

int Parser::parse_int() {
  const Location where = peek().where;
  const double x = parse_float();
  if (!(x >= -2147483648.0 && x <= 2147483647.0)) fail_at(where, "expected an integer");
  return static_cast<int>(x);
}

core::Vec3 Parser::parse_vector() { return m_impl->in.expressions.parse_vector(); }

Number Parser::parse_number(int min_size, int max_size) {
  return m_impl->in.expressions.parse_number(min_size, max_size);
}

Number Parser::parse_colour() { return m_impl->in.expressions.parse_colour(); }
bool Parser::at_colour() { return m_impl->in.expressions.at_colour(); }
bool Parser::at_expression() { return m_impl->in.expressions.at_expression(); }
std::string Parser::parse_string() { return m_impl->in.expressions.parse_string(); }
std::string Parser::parse_path() { return m_impl->in.expressions.parse_path(); }
void Parser::parse_comma() { m_impl->in.tokens.comma(); }

std::optional<core::Transform> Parser::accept_transform() {
  return m_impl->in.expressions.accept_transform();
}

std::optional<core::Transform> Parser::accept_transforms() {
  std::optional<core::Transform> all;
  while (const auto one = accept_transform()) all = all ? all->then(*one) : *one;
  return all;
}

Ref<FunctionDesc> Parser::parse_function_body() { return m_impl->in.functions.parse_body(); }

void Parser::fail(const std::string& message) { fail_at(location(), message); }
void Parser::fail_expected(std::string_view what) { m_impl->in.tokens.fail_expected(what); }
void Parser::fail_at(const Location& where, const std::string& message) {
  m_impl->in.fail(where, message);
}
void Parser::warn(const std::string& message) { warn_at(location(), message); }
void Parser::warn_at(const Location& where, const std::string& message) {
  m_impl->in.warn(where, message);
}

Location Parser::location() {
  const Token& t = peek();
  return t.kind == TokenKind::kEnd ? m_impl->in.tokens.location() : t.where;
}

int Parser::language_version() const { return m_impl->in.version; }
bool Parser::language_version_set() const { return m_impl->in.version_set; }
bool Parser::has_own_version() const { return m_impl->in.has_own_version; }
bool Parser::is_version_late() const { return m_impl->in.is_version_late; }
const ParserOptions& Parser::options() const { return m_impl->in.options; }
Diagnostics& Parser::diagnostics() { return m_impl->in.diagnostics; }
SourceManager& Parser::sources() { return m_impl->in.sources; }

void Parser::set_working_gamma(double gamma) { m_impl->in.working_gamma = gamma; }
std::optional<double> Parser::working_gamma() const { return m_impl->in.working_gamma; }

void Parser::set_utf8(bool utf8) { m_impl->in.utf8 = utf8; }
bool Parser::utf8() const { return m_impl->in.utf8; }

int Parser::noise_generator() const { return *m_impl->in.noise_generator; }

void Parser::set_noise_generator(int generator) {
  *m_impl->in.noise_generator = generator;
  m_impl->in.noise_generator_set = true;
}

std::optional<std::string> Parser::find_file(const std::string& name, const Location& where) {
  return m_impl->in.find_file(name, where);
}

std::optional<FoundFile> Parser::find_to_open(const std::string& name, const Location& where) {
  const auto path = find_file(name, where);
  if (!path) return std::nullopt;
  return FoundFile{*path,
                   m_impl->in.ask_files(where, [&](Files& files) { return files.hold(*path); })};
}

void Parser::check_writable(const std::string& name, const Location& where) {
  m_impl->in.check_file_name(name, where);
  const bool may =
      m_impl->in.ask_files(where, [&](const Files& files) { return files.may_write(name); });
  if (may) return;
  const std::string why = core::why_not_writable(name);
  fail_at(where, !why.empty() ? why : "cannot open '" + shown_name(name) + "' for writing");
}

void Parser::finish() { m_impl->in.files.finish(); }

}  // namespace lentray::parser
