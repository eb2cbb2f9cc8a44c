#include "answer/dossier/dossier_math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/words.hpp"

namespace changeover::cli {
namespace {

constexpr std::string_view binomial = "<i>C</i>(";
constexpr std::string_view sum = "Σ<sub>";

/// Longer than this it is no formula in a sentence.
constexpr std::size_t most_in_formula = 400;

// What stands for itself.
constexpr std::array<std::string_view, 14> operators{"(", ")", ",",    "−",    "+", "·", "=",
                                                     "≥", "≤", "&gt;", "&lt;", "/", "…", "′"};
constexpr std::array<std::string_view, 3> blanks{" ", "\u00a0", "<wbr>"};

std::size_t blank_length(std::string_view html) {
  const auto blank =
      std::ranges::find_if(blanks, [&](std::string_view each) { return html.starts_with(each); });
  return blank == blanks.end() ? 0 : blank->size();
}

/// Up to the bracket that closes the one before `html`; npos if none does.
std::size_t closing(std::string_view html, std::string_view open, std::string_view close) {
  std::size_t depth = 1;
  for (std::size_t i = 0; i < std::min(html.size(), most_in_formula); ++i) {
    if (html.substr(i).starts_with(open)) {
      ++depth;
    } else if (html.substr(i).starts_with(close) && --depth == 0) {
      return i;
    }
  }
  return std::string_view::npos;
}

/// Where `sign` stands outside brackets, if it does so once.
std::optional<std::size_t> outside(std::string_view html, char sign) {
  std::optional<std::size_t> found;
  int depth = 0;
  for (std::size_t i = 0; i < html.size(); ++i) {
    if (html[i] == '<') {  // the / of a tag is none
      i = std::min(html.find('>', i), html.size() - 1);
      continue;
    }
    depth += html[i] == '(' ? 1 : html[i] == ')' ? -1 : 0;
    if (html[i] == sign && depth == 0) {
      if (found) {
        return std::nullopt;
      }
      found = i;
    }
  }
  return found;
}

/// A formula from its beginning on; each function takes off what it has read.
class Formula {
 public:
  explicit Formula(std::string_view html) : rest_(html) {}

  /// All of it as one row; nullopt if words are in it.
  std::optional<std::string> row() {
    std::string out;
    while (!rest_.empty()) {
      if (const std::size_t blank = blank_length(rest_)) {
        rest_.remove_prefix(blank);
        continue;
      }
      auto one = scripted();
      if (!one) {
        return std::nullopt;
      }
      out += *one;
    }
    return "<mrow>" + out + "</mrow>";
  }

  std::optional<std::string> one() {
    for (const auto& read :
         {&Formula::choice, &Formula::letter, &Formula::number, &Formula::sign}) {
      if (auto found = (this->*read)()) {
        return found;
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> choice() {
    const std::size_t end = rest_.starts_with(binomial)
                                ? closing(rest_.substr(binomial.size()), "(", ")")
                                : std::string_view::npos;
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    const std::string_view inside = rest_.substr(binomial.size(), end);
    const auto comma = outside(inside, ',');
    const auto above = comma ? Formula(inside.substr(0, *comma)).row() : std::nullopt;
    const auto below = comma ? Formula(inside.substr(*comma + 1)).row() : std::nullopt;
    if (!above || !below) {
      return std::nullopt;
    }
    rest_.remove_prefix(binomial.size() + end + 1);
    return fmt::format(
        "<mrow><mo maxsize=\"1.8em\">(</mo><mfrac linethickness=\"0\">{}{}</mfrac>"
        "<mo maxsize=\"1.8em\">)</mo></mrow>",
        *above, *below);
  }

  /// "Σ<sub>x</sub>": the index stands below.
  std::optional<std::string> summing() {
    const std::size_t end = rest_.starts_with(sum) ? rest_.find("</sub>") : std::string_view::npos;
    const auto index = end == std::string_view::npos
                           ? std::nullopt
                           : Formula(rest_.substr(sum.size(), end - sum.size())).row();
    if (!index) {
      return std::nullopt;
    }
    rest_.remove_prefix(end + std::string_view("</sub>").size());
    return fmt::format(
        "<mstyle displaystyle=\"true\"><munder><mo movablelimits=\"false\">∑</mo>{}</munder>"
        "</mstyle>",
        *index);
  }

  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  /// With the index or exponent that follows.
  std::optional<std::string> scripted() {
    auto base = one();
    for (const auto& [tag, element] : {std::pair("sub", "msub"), std::pair("sup", "msup")}) {
      const std::string open = fmt::format("<{}>", tag);
      const std::string close = fmt::format("</{}>", tag);
      const std::size_t end = rest_.starts_with(open) ? rest_.find(close) : std::string_view::npos;
      if (!base || end == std::string_view::npos) {
        continue;
      }
      const auto script = Formula(rest_.substr(open.size(), end - open.size())).row();
      if (!script) {
        return std::nullopt;
      }
      base = fmt::format("<{0}>{1}{2}</{0}>", element, *base, *script);
      rest_.remove_prefix(end + close.size());
    }
    return base;
  }

  std::optional<std::string> letter() {
    constexpr std::size_t length = std::string_view("<i>x</i>").size();
    if (!rest_.starts_with("<i>") || rest_.size() < length || !is_letter(rest_[3]) ||
        rest_.substr(4, 4) != "</i>") {
      return std::nullopt;
    }
    const char name = rest_[3];
    rest_.remove_prefix(length);
    return fmt::format("<mi>{}</mi>", name);
  }

  std::optional<std::string> number() {
    const std::size_t length = std::min(rest_.find_first_not_of("0123456789"), rest_.size());
    if (length == 0) {
      return std::nullopt;
    }
    const std::string_view digits = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return fmt::format("<mn>{}</mn>", digits);
  }

  std::optional<std::string> sign() {
    const auto found = std::ranges::find_if(
        operators, [&](std::string_view each) { return rest_.starts_with(each); });
    if (found == operators.end()) {
      return std::nullopt;
    }
    rest_.remove_prefix(found->size());
    return fmt::format("<mo>{}</mo>", *found);
  }

  std::string_view rest_;
};

}  // namespace

std::string with_mathml(std::string_view html) {
  std::string out;
  for (std::size_t at = 0; at < html.size();) {
    Formula formula(html.substr(at));
    auto found = formula.choice();
    found = found ? found : formula.summing();
    if (found) {
      out += "<math>" + *found + "</math>";
      at = html.size() - formula.rest().size();
    } else {
      out += html[at++];
    }
  }
  return out;
}

}  // namespace changeover::cli
