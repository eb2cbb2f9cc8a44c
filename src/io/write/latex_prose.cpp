#include "io/write/latex_prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

#include "changeover/io/tables.hpp"
#include "core/words.hpp"
#include "io/table/table.hpp"

namespace changeover {
namespace {

// Signs in the program's sentences, as mathematics; the empty one is left out.
constexpr std::array<std::pair<std::string_view, std::string_view>, 43> signs{{
    {">=", "\\geq"},     {"<=", "\\leq"},     {"≥", "\\geq"},    {"≤", "\\leq"},
    {"≠", "\\neq"},      {"≡", "\\equiv"},    {"−", "-"},        {"±", "\\pm"},
    {"·", "\\cdot"},     {"×", "\\times"},    {"∘", "\\circ"},   {"∪", "\\cup"},
    {"∩", "\\cap"},      {"∖", "\\setminus"}, {"∈", "\\in"},     {"⊂", "\\subset"},
    {"∅", "\\emptyset"}, {"∞", "\\infty"},    {"→", "\\to"},     {"↔", "\\leftrightarrow"},
    {"↦", "\\mapsto"},   {"Σ", "\\sum"},      {"ℓ", "\\ell"},    {"ω", "\\omega"},
    {"τ", "\\tau"},      {"π", "\\pi"},       {"ρ", "\\rho"},    {"⌈", "\\lceil"},
    {"⌉", "\\rceil"},    {"⌊", "\\lfloor"},   {"⌋", "\\rfloor"}, {"′", "'"},
    {"₀", "_{0}"},       {"₁", "_{1}"},       {"₂", "_{2}"},     {"₃", "_{3}"},
    {"₄", "_{4}"},       {"²", "^{2}"},       {"³", "^{3}"},     {"⁴", "^{4}"},
    {"ᵢ", "_{i}"},       {"ⱼ", "_{j}"},       {"\u0304", ""},
}};

enum class ProseOf : std::uint8_t { latex, html, markdown };

// A formula of LaTeX that math() is given, as HTML. `italics` are for its letters.
std::string html_formula(std::string_view latex, bool italics) {
  std::string html;
  while (!latex.empty()) {
    std::size_t length = 1;
    if (latex.front() == '\\') {
      length = std::min(latex.find_first_not_of("abcdefghijklmnopqrstuvwxyz", 1), latex.size());
      const std::string_view command = latex.substr(0, length);
      // The last of those that mean the same is the sign.
      const auto sign = std::find_if(signs.rbegin(), signs.rend(),
                                     [&](const auto& each) { return each.second == command; });
      html += sign == signs.rend() ? html_text(command.substr(1)) : std::string(sign->first);
      const bool opens = command == "\\lceil" || command == "\\lfloor";
      if (opens && latex.substr(length).starts_with(' ')) {
        ++length;
      }
    } else if ((latex.front() == '_' || latex.front() == '^') && latex.substr(1).starts_with('{')) {
      const std::string_view name = latex.front() == '_' ? "sub" : "sup";
      const std::size_t end = std::min(latex.find('}'), latex.size());
      html += fmt::format("<{0}>{1}</{0}>", name, html_formula(latex.substr(2, end - 2), italics));
      length = std::min(end + 1, latex.size());
    } else if (italics && is_letter(latex.front())) {
      html += fmt::format("<i>{}</i>", latex.front());
    } else {
      html += latex.front() == '-' ? "−" : html_text(latex.substr(0, 1));
    }
    latex.remove_prefix(length);
  }
  return html;
}

class Prose {
 public:
  Prose(std::string_view text, const std::vector<std::string>& keys, ProseOf of = ProseOf::latex)
      : rest_(text), keys_(&keys), of_(of) {}

  std::string take() {
    while (!rest_.empty()) {
      if (!citation() && !formula() && !ceiling() && !subscript() && !lone() && !sign()) {
        letter();
      }
    }
    flush();
    return std::move(result_);
  }

 private:
  // Text outside mathematics is escaped in one piece: an ellipsis or a letter may have several
  // bytes.
  void letter() {
    if (rest_.front() == ')' && !ceilings_.empty() && depth_ == ceilings_.back()) {
      ceilings_.pop_back();
      math("\\rceil", 1);
      return;
    }
    depth_ += rest_.front() == '(' ? 1 : rest_.front() == ')' ? -1 : 0;
    before_ = rest_.front();
    plain_ += rest_.front();
    rest_.remove_prefix(1);
    in_set_ = before_ == '{' || (in_set_ && before_ != '}');
    // Sets are written without blanks; a line may end within them.
    if (in_set_ && before_ == ',' && !rest_.starts_with(' ')) {
      flush();
      result_ += of_ == ProseOf::latex ? "\\allowbreak " : "<wbr>";
    }
  }

  void flush() {
    after_math_ = after_math_ && plain_.empty();
    result_ += of_ == ProseOf::latex  ? latex_escaped(plain_)
               : of_ == ProseOf::html ? html_text(plain_)
                                      : markdown_text(plain_);
    plain_.clear();
  }

  void math(std::string_view what, std::size_t length) {
    flush();
    if (!what.empty() && of_ != ProseOf::latex) {
      result_ += html_formula(what, of_ == ProseOf::html);
      after_math_ = true;
    } else if (!what.empty()) {
      // Primes and stars belong to the formula before them.
      const bool mark = what.front() == '_' || what.front() == '^' || what == "'";
      if (mark && after_math_) {
        result_.pop_back();
        result_ += std::string(what) + "$";
      } else {
        result_ += "$" + std::string(mark ? "{}" : "") + std::string(what) + "$";
      }
      after_math_ = true;
    }
    before_ = rest_[length - 1];
    rest_.remove_prefix(length);
  }

  bool citation() {
    if (!rest_.starts_with('[')) {
      return false;
    }
    for (const std::string& key : *keys_) {
      const std::string_view inside = rest_.substr(1);
      if (!inside.starts_with(key) || inside.size() == key.size()) {
        continue;
      }
      const std::size_t end = rest_.find(']');
      const char next = inside[key.size()];
      if (end == std::string_view::npos || (next != ',' && next != ']')) {
        continue;
      }
      flush();
      std::string where;
      if (next == ',') {
        std::string_view words = rest_.substr(key.size() + 2, end - key.size() - 2);
        words.remove_prefix(std::min(words.find_first_not_of(' '), words.size()));
        where = "[{" + latex_prose(words) + "}]";
      }
      after_math_ = false;
      result_.append("\\cite").append(where).append("{").append(key).append("}");
      rest_.remove_prefix(end + 1);
      before_ = ']';
      return true;
    }
    return false;
  }

  // A whole formula, where a word or a number could begin.
  bool formula() {
    if (is_letter(before_) || is_digit(before_) || before_ == '_' || before_ == '-' ||
        before_ == '.' || before_ == '/' || before_ == '=') {
      return false;
    }
    const auto formula = latex_formula(rest_);
    if (!formula) {
      return false;
    }
    math(formula->latex, formula->length);
    return true;
  }

  // "ceil(" to the bracket that closes it.
  bool ceiling() {
    if (!rest_.starts_with("ceil(") || is_letter(before_)) {
      return false;
    }
    ceilings_.push_back(depth_);
    math("\\lceil", 5);
    return true;
  }

  // One letter or sign with an index: i_x, K_22, B_{i,j}, Z_v, ∞_s.
  bool subscript() {
    const bool after_sign = rest_.front() == '_' && plain_.empty() && after_math_;
    const bool after_letter = is_letter(rest_.front()) && !is_letter(before_) &&
                              !is_digit(before_) && before_ != '_' && rest_.size() > 2 &&
                              rest_[1] == '_';
    if (!after_sign && !after_letter) {
      return false;
    }
    const std::size_t mark = after_letter ? 1 : 0;
    std::string_view index = rest_.substr(mark + 1);
    const std::size_t length = latex_index_length(index);
    if (length == 0) {
      return false;
    }
    index = index.front() == '{' ? index.substr(1, length - 2) : index.substr(0, length);
    math(fmt::format("{}_{{{}}}", rest_.substr(0, mark), index), mark + 1 + length);
    return true;
  }

  // On pages a small letter that stands alone is a variable; "a" is a word, "2 s" is a time, and
  // the endings of "block(s)" and "i.e." are no letters that stand alone.
  bool lone() {
    const char c = rest_.front();
    const bool opened = before_ == '(' && (plain_.size() < 2 || plain_[plain_.size() - 2] == ' ');
    const bool measured = plain_.size() > 1 && is_digit(plain_[plain_.size() - 2]);
    if (of_ != ProseOf::html || c < 'b' || c > 'z' || (before_ != ' ' && !opened) || measured) {
      return false;
    }
    constexpr std::string_view ends = " ,.;:)";
    const bool more = rest_.size() > 1;
    if ((more && ends.find(rest_[1]) == std::string_view::npos) ||
        (rest_.size() > 2 && rest_[1] == '.' && rest_[2] != ' ')) {
      return false;
    }
    math(rest_.substr(0, 1), 1);
    return true;
  }

  bool sign() {
    for (const auto& [written, meant] : signs) {
      if (rest_.starts_with(written)) {
        math(meant, written.size());
        return true;
      }
    }
    return false;
  }

  std::string_view rest_;
  const std::vector<std::string>* keys_;
  ProseOf of_;
  std::string result_;
  std::string plain_;
  bool after_math_ = false;  // the result ends in a formula
  char before_ = ' ';
  int depth_ = 0;
  bool in_set_ = false;
  std::vector<int> ceilings_;
};

}  // namespace

std::string latex_prose(std::string_view text, const std::vector<std::string>& keys) {
  return Prose(text, keys).take();
}

namespace {

const std::vector<std::string> no_keys;

}  // namespace

std::string html_prose(std::string_view text) { return Prose(text, no_keys, ProseOf::html).take(); }

std::string markdown_prose(std::string_view text) {
  return Prose(text, no_keys, ProseOf::markdown).take();
}

namespace {

using Signs = std::pair<std::string_view, std::string_view>;

constexpr std::array<Signs, 11> relations{{{">=", "\\geq"},
                                           {"<=", "\\leq"},
                                           {"≥", "\\geq"},
                                           {"≤", "\\leq"},
                                           {"≠", "\\neq"},
                                           {"≡", "\\equiv"},
                                           {"=", "="},
                                           {"<", "<"},
                                           {">", ">"},
                                           {"∈", "\\in"},
                                           {"⊂", "\\subset"}}};
constexpr std::array<Signs, 10> operators{{{"+", "+"},
                                           {"-", "-"},
                                           {"−", "-"},
                                           {"±", "\\pm"},
                                           {"/", "/"},
                                           {"*", "\\cdot"},
                                           {"·", "\\cdot"},
                                           {"×", "\\times"},
                                           {"∪", "\\cup"},
                                           {"∩", "\\cap"}}};
constexpr std::array<Signs, 3> powers{{{"²", "^{2}"}, {"³", "^{3}"}, {"⁴", "^{4}"}}};
constexpr std::array<std::array<std::string_view, 4>, 3> ceilings{{
    {"⌈", "⌉", "\\lceil ", "\\rceil"},
    {"⌊", "⌋", "\\lfloor ", "\\rfloor"},
    {"ceil(", ")", "\\lceil ", "\\rceil"},
}};

// A recursive descent that takes as much of the text as is a formula. Each function either takes
// all that it names, or puts everything back and says false.
class Formula {
 public:
  explicit Formula(std::string_view text) : rest_(text), whole_(text) {}

  std::optional<LatexFormula> take() {
    constexpr int no_brackets = 0;
    if (!sum(no_brackets) || !(seen_.relation || (seen_.joint && seen_.letter))) {
      return std::nullopt;
    }
    return LatexFormula{latex_, whole_.size() - rest_.size()};
  }

 private:
  struct Seen {
    bool relation = false;
    bool joint = false;  // a sign, a power, a call or a ceiling
    bool letter = false;
  };
  struct Place {
    std::string_view rest;
    std::size_t length;
    Seen seen;
  };
  [[nodiscard]] Place here() const { return {rest_, latex_.size(), seen_}; }
  bool back(const Place& place) {
    rest_ = place.rest;
    latex_.resize(place.length);
    seen_ = place.seen;
    return false;
  }

  bool literal(std::string_view written, std::string_view meant) {
    if (!rest_.starts_with(written)) {
      return false;
    }
    rest_.remove_prefix(written.size());
    latex_ += meant;
    return true;
  }

  bool one_of(std::span<const Signs> any) {
    return std::ranges::any_of(any,
                               [&](const Signs& sign) { return literal(sign.first, sign.second); });
  }

  void spaces() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

  // Operands with signs between them.
  bool sum(int depth) {
    if (depth > deepest || !operand(depth)) {
      return false;
    }
    while (joined(depth)) {
    }
    return true;
  }

  // A sign and what it joins; spaces stand on both sides of it, or on none.
  bool joined(int depth) {
    const Place before = here();
    const bool spaced = rest_.starts_with(' ');
    spaces();
    latex_ += ' ';
    const bool relation = one_of(relations);
    if (!relation && !one_of(operators)) {
      return back(before);
    }
    latex_ += ' ';
    if (rest_.starts_with(' ') != spaced) {
      return back(before);
    }
    spaces();
    if (!operand(depth)) {
      return back(before);
    }
    seen_.relation = seen_.relation || relation;
    seen_.joint = true;
    return true;
  }

  bool operand(int depth) {
    const Place before = here();
    if (rest_.starts_with("-") && rest_.size() > 1 && is_digit(rest_[1])) {
      literal("-", "-");
    }
    bool any = number();
    if (letter()) {
      any = true;
    }
    if (!any) {
      any = ceiling(depth) || function(depth);
    }
    while (bracket(depth, any)) {
      seen_.joint = seen_.joint || any;
      any = true;
    }
    if (!any) {
      return back(before);
    }
    if (one_of(powers)) {
      seen_.joint = true;
    }
    // A word, or a number with a mark in it, is no operand.
    if (!rest_.empty() && (is_letter(rest_.front()) || is_digit(rest_.front()) ||
                           rest_.front() == '_' || rest_.front() == '^' ||
                           (rest_.front() == '.' && rest_.size() > 1 && is_digit(rest_[1])))) {
      return back(before);
    }
    return true;
  }

  bool number() {
    std::size_t length = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    if (length == 0) {
      return false;
    }
    if (length + 1 < rest_.size() && rest_[length] == '.' && is_digit(rest_[length + 1])) {
      length = std::min(rest_.find_first_not_of("0123456789", length + 1), rest_.size());
    }
    return literal(rest_.substr(0, length), rest_.substr(0, length));
  }

  // A letter, and its index: n, n_j, n1.
  bool letter() {
    if (rest_.empty() || !is_letter(rest_.front()) || (rest_.size() > 1 && is_letter(rest_[1]))) {
      return false;
    }
    std::size_t mark = rest_.size() > 1 && rest_[1] == '_' ? 2 : 1;
    const std::string_view after = rest_.substr(std::min(mark, rest_.size()));
    const std::size_t length =
        mark == 2 || (!after.empty() && is_digit(after.front())) ? latex_index_length(after) : 0;
    latex_ += rest_.front();
    if (length > 0) {
      std::string_view index = after.substr(0, length);
      if (index.front() == '{') {
        index = index.substr(1, length - 2);
      }
      latex_ += "_{" + std::string(index) + "}";
    } else {
      mark = 1;
    }
    rest_.remove_prefix(mark + length);
    seen_.letter = true;
    return true;
  }

  bool ceiling(int depth) {
    const Place before = here();
    for (const auto& [open, close, left, right] : ceilings) {
      if (literal(open, left)) {
        spaces();
        if (sum(depth + 1)) {
          spaces();
          if (literal(close, right)) {
            seen_.joint = seen_.letter = true;
            return true;
          }
        }
        return back(before);
      }
    }
    return false;
  }

  // A function whose name is a word: gcd(k-1, m).
  bool function(int depth) {
    const Place before = here();
    if (!literal("gcd", "\\gcd") || !bracket(depth, true)) {
      return back(before);
    }
    seen_.joint = seen_.letter = true;
    return true;
  }

  // "(k - 1)", or after something: what it is multiplied with, or the arguments of a call.
  bool bracket(int depth, bool called) {
    const Place before = here();
    if (!literal("(", "(")) {
      return false;
    }
    do {
      spaces();
      if (!sum(depth + 1)) {
        return back(before);
      }
    } while (called && literal(",", ", "));
    return literal(")", ")") || back(before);
  }

  static constexpr int deepest = 20;
  std::string_view rest_;
  std::string_view whole_;
  std::string latex_;
  Seen seen_;
};

}  // namespace

std::optional<LatexFormula> latex_formula(std::string_view text) { return Formula(text).take(); }

std::size_t latex_index_length(std::string_view text) {
  const auto is_simple = [](char c) {
    return is_letter(c) || is_digit(c) || c == ',' || c == '+' || c == '-';
  };
  if (text.empty()) {
    return 0;
  }
  if (text.front() == '{') {
    const std::size_t end = text.find('}');
    return end == std::string_view::npos || !std::ranges::all_of(text.substr(1, end - 1), is_simple)
               ? 0
               : end + 1;
  }
  if (is_digit(text.front())) {
    return std::min(text.find_first_not_of("0123456789"), text.size());
  }
  return is_letter(text.front()) && (text.size() == 1 || !is_letter(text[1])) ? 1 : 0;
}

}  // namespace changeover
