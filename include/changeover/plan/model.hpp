// Models of parameters: each test has one value of every parameter, and every two values of
// different parameters meet in some test, but for what rules forbid.
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
// Two languages are read and told apart by their content.
//
// *PICT*, Microsoft's tool for pairwise tests [Czerwonka2006]: `Name: value, value, …` a line, then
// rules. `~value` is out of range; `A | B` are names of one value, `value (10)` has a weight,
// `<Other>` stands for all values of a parameter before it. Rules are IF … THEN …; IF … THEN … ELSE
// …; or a condition that always holds, each ended by a semicolon. A condition is made of [P] = "x",
// <>, <, <=, >, >=, [P] LIKE "a*?", [P] IN {"x", "y"}, NOT LIKE, NOT IN, [P] = [Q], IsNegative(P),
// IsPositive(P), with NOT before AND before OR, and brackets. A parameter whose values are all
// numbers is compared as numbers, others as texts, upper and lower case of A to Z alike. In quotes
// and brackets \", \\ and \] stand for themselves.
//
// *ACTS*, the tool of NIST [Yu2013], in its text form: [System], [Parameter] with `Name (type):
// value, …`, [Relation], [Constraint] with one rule a line, of =, !=, <, <=, >, >=, + - * / %, !,
// &&, ||, => and brackets.
//
// Values out of range. A test has at most one, since a program that stops at the first hides what
// comes after it. For the same reason such a test tests only the pairs of that value: two values in
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
  std::string label =
      {};  ///< what it is called: unique in its parameter, with ~ if it is out of range
  std::vector<std::string> names;     ///< as they were written, without ~; rules compare the first
  bool negative = false;              ///< out of range
  std::optional<double> number = {};  ///< of the first name, if it is one
};

struct ModelParameter {
  std::string name;
  std::vector<ModelValue> values;
  bool numeric = false;  ///< rules compare numbers
  Element first = 0;     ///< its values are the parts first, first + 1, …
};

/// What a condition compares: a text, a number, the value of a parameter, or what comes of two
/// numbers.
struct ModelTerm {
  enum class Kind { text, number, parameter, sum, difference, product, quotient, remainder };

  Kind kind = Kind::text;
  std::string text = {};
  double number = 0;
  std::size_t parameter = 0;
  std::vector<ModelTerm> of = {};  ///< two, of a sum and so on
};

/// A condition on a test.
struct ModelRule {
  enum class Kind {
    all,      ///< all of `of` hold; so it does without any
    any,      ///< one of them does; without any it does not
    no,       ///< the only one of them does not
    compare,  ///< terms[0] is in the relation to terms[1]: both are texts or both are numbers
    like,     ///< terms[0], a parameter, matches the pattern terms[1]
    in,       ///< terms[0], a parameter, equals one of the others
    negative  ///< the value of terms[0], a parameter, is out of range; of any, without terms
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
  std::uint64_t line = 1;  ///< where it begins
  std::string text = {};   ///< as it was written, on one line
};

/// Parameters that ask for a strength of their own.
struct ModelRelation {
  std::string place;  ///< "model.txt:7:1"
  std::vector<std::size_t> parameters;
  std::optional<std::uint64_t> strength = {};  ///< nothing: that of all others
};

/// At most so many conditions are in the rules of a model.
inline constexpr std::size_t max_model_conditions = 100'000;

struct Model {
  std::string name;  ///< what messages call it: its file
  std::vector<ModelParameter> parameters;
  std::vector<ModelConstraint> constraints;
  std::vector<ModelRelation> relations;
  std::vector<std::string> notes;  ///< what was read and does not count, a line each

  /// The number of all values.
  [[nodiscard]] std::size_t values() const;
  /// The parameter of a part.
  [[nodiscard]] std::size_t parameter_of(Element value) const;
  [[nodiscard]] const ModelValue& value(Element value) const;
};

/// The whole text of a model. @throws MissingResource if reading fails, and for more than 16 MiB.
[[nodiscard]] std::string text_of_model(Input& input);

/// A model from its text, in either language. @throws BadInput with one line, with a place, for
/// what is none and for what is not supported; MissingResource if reading fails.
[[nodiscard]] Model read_model(Input& input);

/// Why a test is none of the model: it does not have one value of each parameter, or has two that
/// are out of range, or breaks a rule, which is named. Nothing if it is one. Reads the rules as
/// they stand: nothing that makes tests is used. O(size of the rules).
[[nodiscard]] std::optional<std::string> broken_rule(const Model& model, const Block& test);

/// Whether a test is one of the model.
[[nodiscard]] inline bool follows(const Model& model, const Block& test) {
  return !broken_rule(model, test);
}

/// The tests of a model as a job: the values are parts, the parameters slots of one part each, and
/// all values of different parameters must meet, but two that are out of range. Which of them
/// cannot for the rules, cannot_meet() says. Parts are called as values are; where two are called
/// the same, "Parameter: value". @throws BadInput for fewer than two parameters and for more than
/// max_parts values. O(values²).
[[nodiscard]] Job job_of(Model model, Amount test_cost, Amount change_cost);

/// @throws BadInput for a relation that asks for something else than that all parameters meet with
/// this strength.
void check_relations(const Model& model, std::uint64_t strength);

/// What setting values costs, by rows of fields. `parameter,value,cost`, or `parameter,cost` for
/// all of its values; `parameter,from,to,cost` for a value that replaces another. Or a square table
/// for a parameter: its name and its values in a row, then a row for each value that is replaced,
/// as read_change_costs() has it. Later rows win; a first row of such words heads the columns.
/// Returns which values were given a cost of their own. @throws BadInput for unknown parameters and
/// values and for costs that are none; MissingResource if reading fails.
std::vector<bool> read_value_costs(Input& input, Job& job);

}  // namespace changeover
