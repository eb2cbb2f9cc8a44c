// What is to be tested: a number of parts, a list of them, or the values of a model; without those
// that broke, and with the further pieces of parts of which a set-up may need several.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/plan/job_request.hpp"
#include "plan/request/parts_left.hpp"
#include "plan/request/question.hpp"

namespace changeover {

/// The parts of a job, on which the rest of it is built.
class AskedParts {
 public:
  AskedParts(const JobRequest& request, Door door) : question_(request, door) {}

 protected:
  /// Reads them, with their costs and slots. @throws BadOption, BadInput, MissingResource
  void take_parts();

  /// Adds the pieces, once it is known which parts may be together.
  void take_pieces();

  /// The parts of these names, those that broke among them. A model is not a list, and knows its
  /// values by several names. @throws BadOption, which names `key`, for an unknown name
  [[nodiscard]] Block called(std::string_view key, const std::vector<std::string>& words) const;

  /// The same without those that broke, as the job numbers them.
  [[nodiscard]] Block named(std::string_view key, const std::vector<std::string>& words) const {
    return left_(called(key, words));
  }

  Question question_;
  JobRequest whole_;  ///< the request with its lists as rows
  Job job_;
  std::optional<Job> all_values_;   ///< of a model, with those that broke
  std::vector<std::string> names_;  ///< of all parts of the list, and further pieces
  PartsLeft left_;                  ///< which of them remain
  std::vector<std::string> notes_;

 private:
  void take_number(Amount test, Amount change);
  void take_list(Amount test, std::optional<Amount> change);

  // The values of a model and their costs. If the fewest tests are requested and no costs are
  // given, changes are counted.
  void take_model();

  // The parts of the list that broke.
  void take_parts_left(const std::vector<std::string>& names);

  // The unit of costs: as requested, or as in the list.
  void take_unit(CostUnit said);
  void take_slots(const std::vector<std::string>& of_parts, std::vector<Slot> slots,
                  const std::string& name);

  std::vector<std::uint64_t> quantities_;  // of the parts of the list, if it has them
};

}  // namespace changeover
