#include "tests/compat/language_random.h"

#include <random>
#include <vector>

namespace lentray::test {
namespace {

// What is cut to whole numbers is moved off them: the last bit of a rotation may differ.
class Maker {
 public:
  Maker(std::uint32_t seed, const std::string& prefix) : m_random(seed), m_prefix(prefix) {}

  std::string program() {
    for (int i = 0; i < 3; ++i) {
      line("#declare " + name("f", i) + " = " + literal() + ";");
      line("#declare " + name("v", i) + " = " + vector_literal() + ";");
      line("#declare " + name("s", i) + " = " + string_literal());
    }
    line("#declare " + name("c", 0) + " = rgbft <" + literal() + "," + literal() + ",.25,.5," +
         literal() + ">;");
    line("#declare " + name("a", 0) + " = array[4] {" + literal() + "," + literal() + "," +
         literal() + ", " + literal() + "}");
    line("#declare " + name("b", 0) + " = array[2][3] {{1," + literal() + ",3},{" + literal() +
         ",5,-6}}");
    line("#declare " + name("g", 0) + " = function(p_, q_) { p_*" + literal() +
         " - q_*q_/3 + max(p_, q_) }");
    macros();
    m_ready = true;
    for (std::uint32_t i = 0, n = 3 + pick(5); i < n; ++i) statement(2);
    for (int i = 0; i < 3; ++i) {
      write_float(name("f", i));
      write_vector(name("v", i));
    }
    line("W(concat(" + name("s", 0) + ",\"|\"," + name("s", 1) + ",\"|\"," + name("s", 2) + "))");
    write_float(name("a", 0) + "[0]-" + name("a", 0) + "[3]*" + name("b", 0) + "[1][2]");
    return m_text;
  }

 private:
  std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(m_random() % n); }
  std::string name(const char* kind, int i) const { return m_prefix + kind + std::to_string(i); }
  std::string any(const char* kind) { return name(kind, static_cast<int>(pick(3))); }
  void line(const std::string& text) { m_text += text + "\n"; }

  std::string literal() {
    static constexpr const char* kLiterals[] = {"0",      "1",      "2",     "3",    "-1",
                                                "0.5",    ".25",    "-2.75", "7",    "1e1",
                                                "1.5E-1", "12.125", "1/3",   "-(4)", "pi"};
    return kLiterals[pick(std::size(kLiterals))];
  }
  std::string string_literal() {
    static constexpr const char* kStrings[] = {"\"\"",     "\"a\"",       "\"Hello\"",  "\"x y\"",
                                               "\"12.5\"", "\"tab\\t.\"", "\"q\\\"q\"", "\"\\\\\""};
    return kStrings[pick(std::size(kStrings))];
  }
  std::string vector_literal() {
    return "<" + literal() + ", " + literal() + "," + literal() + ">";
  }

  std::string index(std::uint32_t size) {
    if (!m_loops.empty() && pick(2))
      return "mod(" + m_loops.back() + "," + std::to_string(size) + ")";
    return std::to_string(pick(size));
  }

  std::string number(int depth) {
    if (depth <= 0) return leaf();
    const auto sub = [&] { return number(depth - 1); };
    switch (pick(26)) {
      case 0:
      case 1: return sub() + "+" + sub();
      case 2:
      case 3: return sub() + " - " + sub();
      case 4: return "(" + sub() + ")*(" + sub() + ")";
      case 5: return sub() + "*" + leaf();
      case 6: return "(" + sub() + ")/(abs(" + sub() + ")+.5)";
      case 7: return "(" + sub() + relation() + sub() + ")";
      case 8: return "((" + sub() + ")>0 " + (pick(2) ? "&" : "|") + " (" + sub() + ")<1)";
      case 9: return "(" + sub() + relation() + leaf() + " ? " + sub() + " : " + sub() + ")";
      case 10: return "-(" + sub() + ")";
      case 11: return "!(" + sub() + ")";
      case 12: return one_argument() + "(" + sub() + "+.0001)";
      case 13: return "sqrt(abs(" + sub() + "))";
      case 14: return "ln(abs(" + sub() + ")+1)";
      case 15: return "pow(abs(mod(" + sub() + ",10))+.1, " + (pick(2) ? "2" : ".5") + ")";
      case 16:
        return std::string(pick(2) ? "max" : "min") + "(" + sub() + "," + sub() + "," + leaf() +
               ")";
      case 17:
        return "select(" + sub() + "," + sub() + "," + leaf() +
               (pick(2) ? "," + leaf() + ")" : ")");
      case 18: return "mod(" + sub() + "," + (pick(2) ? "7" : "-2.5") + ")";
      case 19: return "div(" + sub() + "+.0001," + (pick(2) ? "3" : "-2") + ")";
      case 20: return bitwise() + "(mod(" + sub() + ",100)+.0001, mod(" + sub() + ",100)+.0001)";
      case 21: return "(" + vector(depth - 1) + ")." + std::string(1, "xyz"[pick(3)]);
      case 22: return "vlength(" + vector(depth - 1) + ")";
      case 23: return "vdot(" + vector(depth - 1) + "," + vector(depth - 1) + ")";
      case 24: return text_number(depth);
      default: return called(depth);
    }
  }

  std::string leaf() {
    switch (pick(9)) {
      case 0:
      case 1:
      case 2: return literal();
      case 3:
      case 4: return any("f");
      case 5: return any("v") + "." + std::string(1, "xyz"[pick(3)]);
      case 6: return name("a", 0) + "[" + index(4) + "]";
      case 7: return name("b", 0) + "[" + index(2) + "][" + index(3) + "]";
      default:
        return m_loops.empty() ? name("c", 0) + (pick(2) ? ".green" : ".transmit") : m_loops.back();
    }
  }

  const char* relation() {
    static constexpr const char* kAll[] = {"<", "<=", "=", "!=", ">=", ">"};
    return kAll[pick(std::size(kAll))];
  }
  std::string one_argument() {
    static constexpr const char* kAll[] = {"sin",  "cos",     "abs",     "int",  "floor", "ceil",
                                           "atan", "degrees", "radians", "tanh", "asinh"};
    return kAll[pick(std::size(kAll))];
  }
  std::string bitwise() {
    static constexpr const char* kAll[] = {"bitwise_and", "bitwise_or", "bitwise_xor"};
    return kAll[pick(std::size(kAll))];
  }
  std::string text_number(int depth) {
    switch (pick(5)) {
      case 0: return "strlen(" + string(depth - 1) + ")";
      case 1: return "asc(concat(" + string(depth - 1) + ",\"z\"))";
      case 2: return "val(str(" + number(depth - 1) + ",0,4))";
      case 3: return "(" + string(depth - 1) + relation() + string(depth - 1) + ")";
      default: return "(strcmp(" + string(depth - 1) + "," + string(depth - 1) + ")>0)";
    }
  }
  std::string called(int depth) {
    if (!m_ready) return leaf();
    if (pick(2)) return name("g", 0) + "(" + number(depth - 1) + "," + leaf() + ")";
    return m_prefix + "Mix(" + leaf() + "," + leaf() + ")";
  }

  std::string vector(int depth) {
    if (depth <= 0) return pick(3) ? any("v") : std::string(1, "xyz"[pick(3)]);
    const auto sub = [&] { return vector(depth - 1); };
    switch (pick(11)) {
      case 0:
        return "<" + number(depth - 1) + "," + number(depth - 1) + "," + number(depth - 1) + ">";
      case 1: return "(" + sub() + "+" + sub() + ")";
      case 2: return "(" + sub() + "-" + leaf() + ")";
      case 3: return sub() + "*(" + number(depth - 1) + ")";
      case 4: return "(" + sub() + "*" + sub() + ")/2";
      case 5: return "vcross(" + sub() + "," + sub() + ")";
      case 6: return "vrotate(" + sub() + ",<10,20,30>*" + leaf() + ")";
      case 7: return "vaxis_rotate(" + sub() + ",<1,2,3>," + leaf() + "*10)";
      case 8: return "vnormalize(<" + leaf() + "," + leaf() + ",9.75>)";
      case 9: return "(" + sub() + relation() + sub() + ")";
      default: return "-" + sub();
    }
  }

  std::string string(int depth) {
    if (depth <= 0) return pick(2) ? string_literal() : any("s");
    switch (pick(7)) {
      case 0: return "concat(" + string(depth - 1) + "," + string(depth - 1) + ")";
      case 1:
        return "str(" + number(depth - 1) + "," + std::to_string(pick(12)) + "," +
               std::to_string(pick(6)) + ")";
      case 2: return "vstr(3," + vector(depth - 1) + ",\";\",0," + std::to_string(pick(5)) + ")";
      case 3: return "chr(65+" + index(20) + ")";
      case 4: return std::string(pick(2) ? "strupr" : "strlwr") + "(" + string(depth - 1) + ")";
      case 5:
        return "substr(concat(" + string(depth - 1) + ",\"abcdef\"),2," +
               std::to_string(1 + pick(4)) + ")";
      default: return string(0);
    }
  }

  // What is kept is small again: sums in loops would grow without end.
  std::string kept(const std::string& value) { return "mod(" + value + ",1000)"; }

  void write_float(const std::string& e) { line("W(str(" + e + ",0,6))"); }
  void write_vector(const std::string& e) { line("W(vstr(3," + e + ",\",\",0,6))"); }

  void macros() {
    line("#macro " + m_prefix + "Mix(p_, q_) #local t_ = p_*2 - q_; #if (t_ > 1) t_ - " +
         literal() + " #else (t_ + q_) #end #end");
    line("#macro " + m_prefix + "Bump(r_, n_) #for (k_, 1, n_) #declare r_ = mod(r_ + k_*" +
         literal() + ", 1000); #end #end");
    line("#macro " + m_prefix + "Down(n_, t_) #if (n_ > 0) " + m_prefix +
         "Down(n_ - 1, concat(t_, str(n_,0,0))) #else W(t_) #end #end");
  }

  void statement(int depth) {
    switch (pick(depth > 0 ? 13 : 8)) {
      case 0:
      case 1: line("#declare " + any("f") + " = " + kept(number(3)) + ";"); break;
      case 2:
        line("#declare " + any("v") + " = <" + kept(number(2)) + "," + kept(number(1)) + "," +
             kept(number(1)) + ">;");
        break;
      case 3:
        line("#declare " + any("s") + " = substr(concat(" + string(2) + ",\"....\"),1,4)");
        break;
      case 4: write_float(number(4)); break;
      case 5: write_vector(vector(3)); break;
      case 6: line("W(" + string(3) + ")"); break;
      case 7:
        line("#declare " + name("a", 0) + "[" + index(4) + "] = " + kept(number(2)) + ";");
        break;
      case 8: condition(depth); break;
      case 9: loop(depth); break;
      case 10: choice(depth); break;
      case 11:
        line(m_prefix + "Bump(" + (pick(2) ? any("f") : name("a", 0) + "[" + index(4) + "]") +
             ", " + std::to_string(pick(4)) + ")");
        break;
      default: line(m_prefix + "Down(" + std::to_string(pick(5)) + "," + string(1) + ")"); break;
    }
  }

  void block(int depth) {
    for (std::uint32_t i = 0, n = 1 + pick(3); i < n; ++i) statement(depth - 1);
  }
  // Stock refuses macros with directives in the heads of directives.
  std::string in_head(int depth) {
    const bool before = m_ready;
    m_ready = false;
    const std::string text = number(depth);
    m_ready = before;
    return text;
  }
  void condition(int depth) {
    line("#if (" + in_head(2) + relation() + in_head(1) + ")");
    block(depth);
    if (pick(3) == 0) {
      line("#elseif (" + in_head(2) + ")");
      block(depth);
    }
    if (pick(2)) {
      line("#else");
      block(depth);
    }
    line("#end");
  }
  void loop(int depth) {
    const std::string counter = m_prefix + "i" + std::to_string(m_loops.size());
    const bool counted = pick(2) != 0;
    if (counted) {
      line("#for (" + counter + ", 0, " + std::to_string(1 + pick(4)) + (pick(2) ? ", 1)" : ")"));
    } else {
      line("#local " + counter + " = 0; #while (" + counter + " < " + std::to_string(1 + pick(4)) +
           ")");
    }
    m_loops.push_back(counter);
    block(depth);
    if (pick(4) == 0) line("#if (" + in_head(1) + " > 2) #break #end");
    m_loops.pop_back();
    line(counted ? "#end" : "#local " + counter + " = " + counter + "+1; #end");
  }
  void choice(int depth) {
    line("#switch (int(mod(" + in_head(2) + ",4)+.0001))");
    for (int i = 0; i < 3; ++i) {
      line(pick(3) ? "#case (" + std::to_string(i) + ")"
                   : "#range (" + std::to_string(i - 2) + "," + std::to_string(i) + ")");
      block(depth);
      if (pick(3)) line("#break");
    }
    if (pick(2)) {
      line("#else");
      block(depth);
    }
    line("#end");
  }

  std::mt19937 m_random;
  std::string m_prefix, m_text;
  std::vector<std::string> m_loops;
  bool m_ready = false;
};

}  // namespace

std::string random_program(std::uint32_t seed, const std::string& prefix) {
  return Maker(seed, prefix).program();
}

}  // namespace lentray::test
