// Models of parameters: each test has one value of every parameter, and every two values of
// different parameters meet in some test, unless rules forbid it.
//
//     auto input = input_from_text(
//         "OS:      Debian, Fedora, Windows\n"
//         "Browser: Firefox, Chrome, Edge\n"
//         "Locale:  de, en, ja\n"
//         "IF [Browser] = \"Edge\" THEN [OS] = \"Windows\";\n");
//     const Model model = read_model(*input);
//     follows(model, {2, 5, 7});                    // true: Windows, Edge, en
//     follows(model, {0, 5, 7});                    // false: Edge runs on Windows only
//     const Job job = job_of(model, parse_amount("1"), parse_amount("5"));
//     job.parts();               // 9: the values are the parts, the parameters the slots
//
// Two languages are read; the content tells which one it is.
//
// *PICT*, Microsoft's tool for pairwise tests [Czerwonka2006]: lines `Name: value, value, …`, then
// rules. `~value` is out of range; `A | B` are two names of one value; `value (10)` has a weight;
// `<Other>` stands for all values of an earlier parameter. A rule is IF … THEN …; IF … THEN … ELSE
// …; or a condition that always holds, and ends with a semicolon. Conditions: [P] = "x", <>, <, <=,
// >, >=, [P] LIKE "a*?", [P] IN {"x", "y"}, NOT LIKE, NOT IN, [P] = [Q], IsNegative(P),
// IsPositive(P). They are combined by NOT, AND and OR, in this order of precedence, and by
// parentheses. A parameter whose values are all numbers is compared as numbers, others as texts,
// ignoring the case of A to Z. In quotes and brackets, \", \\ and \] are escapes.
//
// *ACTS*, the tool of NIST [Yu2013], in its text form: [System], [Parameter] with `Name (type):
// value, …`, [Relation], [Constraint] with one rule per line, made of =, !=, <, <=, >, >=, + - * /
// %, !, &&, ||, => and parentheses.
//
// Values out of range. A test has at most one, since a program that stops at the first error hides
// later ones. For the same reason such a test only tests the pairs of this value: two values in
// range have to meet in a test without one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "changeover/core/block.hpp"
#include "changeover/io/input.hpp"
#include "changeover/plan/job.hpp"

namespace changeover {

struct ModelValue {
  std::string label = {};  ///< unique within its parameter; begins with ~ if it is out of range
  std::vector<std::string> names;     ///< as written, without ~; rules compare the first
  bool negative = false;              ///< out of range
  std::optional<double> number = {};  ///< the first name, if it is a number
};

struct ModelParameter {
  std::string name;
  std::vector<ModelValue> values;
  bool numeric = false;  ///< rules compare it as a number
  Element first = 0;     ///< its values are the parts first, first + 1, …
};

/// An operand of a condition: a text, a number, the value of a parameter, or an arithmetic
/// expression.
struct ModelTerm {
  enum class Kind { text, number, parameter, sum, difference, product, quotient, remainder };

  Kind kind = Kind::text;
  std::string text = {};
  double number = 0;
  std::size_t parameter = 0;
  std::vector<ModelTerm> of = {};  ///< the two operands of an arithmetic expression
};

/// A condition on a test.
struct ModelRule {
  enum class Kind {
    all,      ///< all of `of` hold; true if `of` is empty
    any,      ///< one of `of` holds; false if `of` is empty
    no,       ///< the only one of `of` does not hold
    compare,  ///< terms[0] has the relation to terms[1]; both are texts or both are numbers
    like,     ///< terms[0], a parameter, matches the pattern terms[1]
    in,       ///< terms[0], a parameter, equals one of the other terms
    negative  ///< the value of terms[0], a parameter, is out of range; without terms, any value is
  };
  enum class Relation { equal, unequal, less, at_most, greater, at_least };

  Kind kind = Kind::all;
  Relation relation = Relation::equal;
  std::vector<ModelRule> of = {};
  std::vector<ModelTerm> terms = {};
};

/// A rule that every test follows.
struct ModelConstraint {
  ModelRule rule;
  std::uint64_t line = 1;  ///< its first line
  std::string text = {};   ///< as written, on one line
};

/// A strength for some of the parameters.
struct ModelRelation {
  std::string place;  ///< "model.txt:7:1"
  std::vector<std::size_t> parameters;
  std::optional<std::uint64_t> strength = {};  ///< nullopt: the default strength
};

/// The limit for the number of conditions in the rules of a model.
inline constexpr std::size_t max_model_conditions = 100'000;

struct Model {
  std::string name;  ///< its file, named in messages
  std::vector<ModelParameter> parameters;
  std::vector<ModelConstraint> constraints;
  std::vector<ModelRelation> relations;
  std::vector<std::string> notes;  ///< what was read but has no effect, one per line

  /// The number of values of all parameters.
  [[nodiscard]] std::size_t values() const;
  /// The parameter of a value.
  [[nodiscard]] std::size_t parameter_of(Element value) const;
  [[nodiscard]] const ModelValue& value(Element value) const;
};

/// Reads the whole text of a model. @throws MissingResource if reading fails, and for more than 16
/// MiB.
[[nodiscard]] std::string text_of_model(Input& input);

/// Parses a model in either language. @throws BadInput with one line and a place for what is
/// malformed or not supported; MissingResource if reading fails.
[[nodiscard]] Model read_model(Input& input);

/// Why a test does not follow the model: it lacks a value of a parameter, has two, has two that are
/// out of range, or breaks a rule, which is named. nullopt if it follows it. Evaluates the rules
/// directly and shares no code with what makes tests. O(size of the rules).
[[nodiscard]] std::optional<std::string> broken_rule(const Model& model, const Block& test);

/// Whether a test follows the model.
[[nodiscard]] inline bool follows(const Model& model, const Block& test) {
  return !broken_rule(model, test);
}

/// Converts a model to a job: the values are parts, the parameters slots of one part each, and all
/// values of different parameters must meet, except two that are out of range. cannot_meet() says
/// which pairs the rules exclude. Parts have the names of their values, or "Parameter: value" where
/// two values have the same name. @throws BadInput for fewer than two parameters and for more than
/// max_parts values. O(values²).
[[nodiscard]] Job job_of(Model model, Amount test_cost, Amount change_cost);

/// @throws BadInput for a relation other than: all parameters, with this strength.
void check_relations(const Model& model, std::uint64_t strength);

/// Reads the costs of setting values, one row each: `parameter,value,cost`; `parameter,cost` for
/// all of its values; `parameter,from,to,cost` for a value that replaces another. Or a square table
/// for a parameter: its name and its values in a row, then a row for each value that is replaced,
/// as in read_change_costs(). A row `parameter,value,quantity,1` says on how many benches a value
/// can be at a time. Later rows override earlier ones; a first row of such words is a
/// header. Returns which values have their own cost. @throws BadInput for unknown parameters and
/// values and for invalid costs; MissingResource if reading fails.
std::vector<bool> read_value_costs(Input& input, Job& job);

}  // namespace changeover
