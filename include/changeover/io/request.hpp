// A request as a document: its keys, their kinds, and which keys exclude or need others.
//
// There is one record per option. It makes the option of the command line with its help, the key of
// the JSON document and of the server's requests, the argument in Python, and a row of
// docs/doors.md. A request itself is plain data (plan/job_request.hpp, loadorder/load_request.hpp);
// its lists are in files or in the request.
//
//     RequestList pairs{.rows = {{{.fields = {"Pump A", "Motor"}}}}};  // or .file, or .text
//     pairs.is_given();                                                  // true
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace changeover {

/// Where a request came from, which decides how messages spell its keys: "--time", "seconds" or
/// "time".
enum class Door { command_line, document, python };

/// The kind of a key's value.
enum class ValueKind {
  number,   ///< a whole number from 0
  amount,   ///< an exact decimal, as written
  seconds,  ///< a number of seconds
  flag,     ///< true or false
  text,     ///< any text
  word,     ///< one of some words
  names,    ///< names of parts; on the command line with commas between them
  list      ///< a list: in a file, as text, or here
};

/// The shape of a list's rows in JSON.
enum class RowShape {
  none,     ///< not a list
  parts,    ///< "name" or {"name", "cost", "slot", "quantity"}
  pairs,    ///< [a, b]
  sizes,    ///< [item, bytes], or the bytes of items in turn
  costs,    ///< [a, b] or [a, b, cost]
  groups,   ///< [a, b, …]
  reasons,  ///< [a, b] or [a, b, why]
  weights,  ///< [a, b, weight]
  slots,    ///< {"name", "least", "most"}
  setups,   ///< [a, b, …] or {"parts": [a, b, …], "bench"}
  tests,    ///< [a, b, …] or {"parts": [a, b, …], "result", "bench"}
  benches,  ///< "name" or {"name", "at_once", "test_cost", …}, or how many
  table,    ///< [field, …], with a head for each row and column
  document  ///< not a list but a text in another language: "text"
};

/// One row of a list.
struct ListRow {
  std::vector<std::string> fields;
  /// The result of a test as written, which may be empty. Without one the test was done.
  std::optional<std::string> result = {};
  std::string bench =
      {};  ///< of a set-up: on which bench, by name or number; empty: that is not said

  bool operator==(const ListRow&) const = default;
};

/// A list of a request: in a file, as the text or the bytes of one, or row by row. At most one of
/// them is given.
struct RequestList {
  std::string file = {};                          ///< its path; "-": standard input
  std::optional<std::string> text = {};           ///< the text of such a file
  std::string name = {};                          ///< of the file that had it; empty: none had
  std::optional<std::string> workbook = {};       ///< the bytes of a workbook (.xlsx)
  std::string sheet = {};                         ///< of that workbook; empty: the first one
  std::optional<std::vector<ListRow>> rows = {};  ///< each of the list's shape
  std::optional<std::uint64_t> number = {};       ///< of benches: how many that are alike

  [[nodiscard]] bool is_given() const {
    return !file.empty() || text || workbook || rows || number;
  }
  bool operator==(const RequestList&) const = default;
};

/// Where the document of a request has its values, for messages. Requests are equal wherever they
/// stand.
struct RequestPlaces {
  std::string name = {};                         ///< of the document; empty: there is none
  std::shared_ptr<const std::string> text = {};  ///< of the document
  /// By key where its value begins in the text, then where each row of a list does.
  std::map<std::string, std::vector<std::size_t>, std::less<>> offsets = {};

  /// What a message begins with that is about a value of the document, "job.json:3:12: ". `what` is
  /// a key, or a row of a list as "pairs[3]". Empty if the document has no such key.
  [[nodiscard]] std::string before(std::string_view what) const;
  /// What a message begins with that is about the document as a whole, where something is missing.
  [[nodiscard]] std::string before_all() const;

  bool operator==(const RequestPlaces& /*other*/) const { return true; }
};

/// How long searches take where a request does not say, in seconds, and the longest that the server
/// takes.
struct SearchTimes {
  double command_line = 0;  ///< 0: no search
  double server = 0;
  double most_of_server = 0;
  double followed = 0;  ///< where the server does not wait for the answer; 0: it always does
  double most_followed = 0;
};

/// One option, for the command line, documents, the server and Python.
struct OptionRecord {
  std::string_view key = {};  ///< in documents and in Python
  /// On the command line: "-k,--at-once"; without hyphens a positional argument.
  std::string flags = {};
  ValueKind kind = ValueKind::flag;
  std::string_view value = {};  ///< the name of its value in the help: "K", "FILE"
  std::string_view help = {};
  std::string_view unit = {};   ///< what its number counts: "parts", "bytes"; empty: no unit
  std::string by_default = {};  ///< the default, in words; empty: none is stated
  RowShape shape = RowShape::none;
  std::vector<std::string_view> words = {};  ///< of a word
  std::string_view python = {};              ///< the argument there, if it has another name
  std::string_view not_in_server = {};       ///< why it is not there; empty: it is
  std::string_view not_in_python = {};
  std::string_view in_python = {};  ///< how it is there, if it is not all that documents have
  /// What C calls it (changeover/loadorder/changeover_loadorder.h); empty: C does not take it.
  std::string_view c = {};
  bool of_every_search = false;  ///< on the command line every verb that searches has it
};

/// Which keys exclude or need others. A key with a value, as "strength=3", is given if it has that.
struct OptionRule {
  enum class Says {
    exclude,    ///< at most one of `keys` is given
    needs,      ///< each of `keys` needs one of `others`; without `keys` every request does
    only_with,  ///< each of `keys` means something only with one of `others`
    never_with  ///< none of `keys` means anything with one of `others`
  };
  Says says = Says::exclude;
  std::vector<std::string_view> keys;
  std::vector<std::string_view> others = {};
  /// The message where the general one does not say enough: "{}" is the key at fault, "{key}"
  /// another, "{key=}" that with its value ("--at-once K"), "{where}" those of `where`.
  std::string_view line = {};
  std::vector<std::string_view> where = {};  ///< it holds only with one of these; empty: always
  /// A list that may be a file, which itself may say one of `others`; so the rule is asked once the
  /// file was opened.
  std::string_view or_in_file_of = {};
};

/// The member of a request that has the value of a key.
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

/// All keys of one kind of request, and the rules between them.
template <typename Request>
struct RequestTable {
  std::string_view format;  ///< "changeover-job/1"
  std::vector<RequestOption<Request>> options;
  std::vector<OptionRule> rules;
  SearchTimes times;
};

/// How this door spells the key of an option: "--at-once" on the command line, "at_once" in a
/// document. A positional argument has the name that the help gives it.
[[nodiscard]] std::string spelled(const OptionRecord& record, Door door);
/// How this door spells an option with its value: "--at-once K" on the command line.
[[nodiscard]] std::string spelled_with_value(const OptionRecord& record, Door door);
/// The help of an option with its default: "pairs that must meet (default: all)".
[[nodiscard]] std::string help_of(const OptionRecord& record);

}  // namespace changeover
