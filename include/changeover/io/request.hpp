// A question as a document: what can be asked, under which keys, and which keys exclude or need others.
//
// One record an option. From it come the option of the command line with its help, the key of the JSON document, the member of
// the body that the server takes, the argument in Python, and the table docs/doors.md. A request itself is plain data
// (plan/job_request.hpp, loadorder/load_request.hpp); lists in it are named by a file or stand in it.
//
//     RequestList pairs{.rows = {{{.fields = {"Pump A", "Motor"}}}}};      // or .file = "pairs.csv", or .text = "Pump A,Motor"
//     pairs.is_given();                                                  // true
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace changeover {

/// Through which door a question came: it says how messages spell its keys, "--at-once" or "at_once".
enum class Door { command_line, document };

/// What a key holds.
enum class ValueKind {
  number,   ///< a whole number from 0
  amount,   ///< an exact decimal, as it is written
  seconds,  ///< a number of seconds
  flag,     ///< true or false
  text,     ///< any text
  word,     ///< one of some words
  names,    ///< names of parts; on the command line with commas between them
  list      ///< a list: in a file, as text, or here
};

/// What the rows of a list are, as JSON has them.
enum class RowShape {
  none,     ///< this is no list
  parts,    ///< "name" or {"name", "cost", "slot"}
  pairs,    ///< [a, b]
  weights,  ///< [a, b, weight]
  slots,    ///< {"name", "least", "most"}
  setups,   ///< [a, b, …]
  tests,    ///< [a, b, …] or {"parts": [a, b, …], "result"}
  table     ///< [field, …], with a head for each row and column
};

/// One row of a list.
struct ListRow {
  std::vector<std::string> fields;
  /// Of a test: what is written there, perhaps nothing. Without one the test was done.
  std::optional<std::string> result = {};

  bool operator==(const ListRow&) const = default;
};

/// A list of a request: in a file, as the text of one, or row by row. At most one of them is given.
struct RequestList {
  std::string file = {};                          ///< its path; "-": standard input
  std::optional<std::string> text = {};           ///< what a file would hold
  std::optional<std::vector<ListRow>> rows = {};  ///< each as its shape says

  [[nodiscard]] bool is_given() const { return !file.empty() || text || rows; }
  bool operator==(const RequestList&) const = default;
};

/// One option: what every door knows of it.
struct OptionRecord {
  std::string_view key;  ///< in documents and in Python
  std::string_view
      flags;  ///< on the command line: "-k,--at-once"; without hyphens a positional argument
  ValueKind kind = ValueKind::flag;
  std::string_view value = {};  ///< what the help calls its value: "K", "FILE"
  std::string_view help = {};
  RowShape shape = RowShape::none;
  std::vector<std::string_view> words = {};  ///< of a word
  std::string_view python = {};              ///< the argument there, if it has another name
  std::string_view not_in_server = {};       ///< why that door does not have it; empty: it does
  std::string_view not_in_python = {};
  bool of_every_search = false;  ///< every verb that searches has it on the command line
};

/// Which keys exclude or need others.
struct OptionRule {
  enum class Says {
    exclude,    ///< at most one of `keys` is given
    only_with,  ///< each of `keys` means something only with one of `others`
    never_with  ///< none of `keys` means anything with one of `others`
  };
  Says says = Says::exclude;
  std::vector<std::string_view> keys;
  std::vector<std::string_view> others = {};
};

/// Where a request keeps the value of a key.
template <typename Request>
using RequestField =
    std::variant<std::optional<std::uint64_t> Request::*, std::optional<double> Request::*,
                 bool Request::*, std::string Request::*, std::vector<std::string> Request::*,
                 RequestList Request::*>;

template <typename Request>
struct RequestOption {
  OptionRecord record;
  RequestField<Request> field;
};

/// All that one kind of question can say.
template <typename Request>
struct RequestTable {
  std::string_view format;  ///< "changeover-job/1"
  std::vector<RequestOption<Request>> options;
  std::vector<OptionRule> rules;
};

/// How a door spells a key: "--at-once", "at_once"; a positional argument by its name in the help.
[[nodiscard]] std::string spelled(const OptionRecord& record, Door door);
/// The same with its value, where the door has that: "--at-once K".
[[nodiscard]] std::string spelled_with_value(const OptionRecord& record, Door door);

}  // namespace changeover
