// What names mean. Scopes nest as files and macros do, and a name is looked up through all of them
// (dynamic scoping, as POV-Ray has it): #local makes a symbol in the innermost scope, #declare sets
// the visible one or makes a global one. A look-up is one index: names are interned.
// Source: reference manual 3.7, "Identifiers" under #declare and #local; order measured on stock.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include "parser/base/recycled.h"
#include "parser/tokens/lexer.h"
#include "parser/values/value.h"

namespace lentray::parser {

struct MacroParameter {
  NameId name = 0;
  bool optional = false;
};

/// A macro: a range of tokens of the text it stands in.
struct Macro {
  NameId name = 0;
  Location where;
  std::vector<MacroParameter> parameters;
  std::shared_ptr<const TokenList> list;
  std::size_t begin = 0, end = 0;
};

struct ScriptFile;  // of #fopen

/// What is said when a deprecated identifier is read.
struct Deprecation {
  std::string text;
  bool once = false;
};

/// What few symbols are besides a value.
struct SymbolExtras {
  std::shared_ptr<const Macro> macro;
  std::shared_ptr<ScriptFile> file;
  std::shared_ptr<ArrayValue>
      alias_array;  ///< a parameter: the array one of whose elements was passed
  std::size_t alias_index = 0;
  std::unique_ptr<Deprecation> deprecated;
  bool* was_read = nullptr;  ///< set whenever the name is read; null: nobody wants to know
};

struct Symbol;
inline void intrusive_ptr_add_ref(Symbol* symbol);
inline void intrusive_ptr_release(Symbol* symbol);
/// Counted in the symbol itself, without locks: an interpreter has one thread.
using SymbolPtr = boost::intrusive_ptr<Symbol>;

/// Made and gone with each call of a macro: small.
struct Symbol {
  Value value;
  SymbolPtr alias;                       ///< a parameter: the symbol passed by reference
  std::unique_ptr<SymbolExtras> extras;  ///< null for nearly all
  std::uint32_t level = 0;               ///< scope it lives in; 0: global
  std::uint32_t references = 0;

  SymbolExtras& edit_extras() {
    if (!extras) extras = std::make_unique<SymbolExtras>();
    return *extras;
  }
  /// Null unless it is one.
  const Macro* macro() const { return extras ? extras->macro.get() : nullptr; }
  ScriptFile* file() const { return extras ? extras->file.get() : nullptr; }
  ArrayValue* alias_array() const { return extras ? extras->alias_array.get() : nullptr; }
  void note_read() const {
    if (extras && extras->was_read) *extras->was_read = true;
  }
  const Deprecation* deprecated() const { return extras ? extras->deprecated.get() : nullptr; }

  /// Makes it hold this value and nothing else; it stays in its scope.
  void reset(Value new_value) {
    value = std::move(new_value);
    alias.reset();
    extras.reset();
  }

  /// Makes what it stands for hold this value.
  void assign(Value new_value) {
    if (alias || alias_array())
      resolve() = std::move(new_value);
    else if (!extras)
      value = std::move(new_value);
    else
      reset(std::move(new_value));
  }

  /// Its value is its own, and nothing happens when its name is read.
  bool is_plain() const {
    return !alias && (!extras || !(extras->macro || extras->alias_array || extras->deprecated ||
                                   extras->was_read));
  }

  /// The symbol itself behind references.
  Symbol& target() {
    Symbol* s = this;
    while (s->alias) s = s->alias.get();
    return *s;
  }
  Value& resolve() {
    Symbol& s = target();
    return s.alias_array() ? s.alias_array()->elements[s.extras->alias_index] : s.value;
  }
  bool is_set() {
    Symbol& s = target();
    return s.macro() || s.file() || !std::holds_alternative<std::monostate>(s.resolve());
  }
};

inline void intrusive_ptr_add_ref(Symbol* symbol) { ++symbol->references; }
inline void intrusive_ptr_release(Symbol* symbol) {
  if (--symbol->references > 0) return;
  std::destroy_at(symbol);
  Recycled<Symbol>().deallocate(symbol, 1);
}

inline SymbolPtr make_symbol() {
  return SymbolPtr(std::construct_at(Recycled<Symbol>().allocate(1)));
}

class SymbolTable {
 public:
  /// The visible symbol of a name, or null.
  Symbol* find(NameId name) const {
    return name < m_visible.size() ? m_visible[name].get() : nullptr;
  }
  std::uint32_t level() const { return static_cast<std::uint32_t>(m_scopes.size()); }

  void push_scope() { m_scopes.push_back(m_hidden.size()); }
  void pop_scope();

  Symbol& declare_global(NameId name);  ///< the visible symbol, or a new global one
  Symbol& declare_local(NameId name);   ///< the innermost scope's own symbol, made if need be
  /// The symbol of the scope at `level`, made there if need be even if scopes within hide it.
  Symbol& declare_at(NameId name, std::uint32_t level);
  void bind_local(NameId name, SymbolPtr symbol);
  void remove(NameId name);  ///< forgets the visible symbol; an outer one shows again

  /// Every visible name, for messages.
  std::vector<NameId> visible_names() const;

 private:
  struct Hidden {
    NameId name;
    SymbolPtr outer;  // what the scope's own symbol hides; may be null
  };
  SymbolPtr& slot(NameId name) {
    if (name >= m_visible.size()) m_visible.resize(name + 64);
    return m_visible[name];
  }
  std::vector<SymbolPtr> m_visible;   // by name
  std::vector<Hidden> m_hidden;       // of all scopes, innermost last
  std::vector<std::size_t> m_scopes;  // where a scope's part of m_hidden starts
};

}  // namespace lentray::parser
