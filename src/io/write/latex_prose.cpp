#include "io/write/latex_prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "changeover/io/tables.hpp"
#include "core/words.hpp"
#include "io/write/latex_formula.hpp"

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

class Prose {
 public:
  Prose(std::string_view text, const std::vector<std::string>& keys) : rest_(text), keys_(&keys) {}

  std::string take() {
    while (!rest_.empty()) {
      if (!citation() && !formula() && !ceiling() && !subscript() && !sign()) {
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
  }

  void flush() {
    after_math_ = after_math_ && plain_.empty();
    result_ += latex_escaped(plain_);
    plain_.clear();
  }

  void math(std::string_view what, std::size_t length) {
    flush();
    if (!what.empty()) {
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
      result_ += "\\cite" + where + "{" + key + "}";
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
  std::string result_;
  std::string plain_;
  bool after_math_ = false;  // the result ends in a formula
  char before_ = ' ';
  int depth_ = 0;
  std::vector<int> ceilings_;
};

}  // namespace

std::string latex_prose(std::string_view text, const std::vector<std::string>& keys) {
  return Prose(text, keys).take();
}

}  // namespace changeover
