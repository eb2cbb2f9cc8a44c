// What verbs share: the parameters that are asked for, where the answer goes, and the judgement that
// every design passes before it is shown.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/json.hpp"
#include "changeover/io/output_file.hpp"
#include "changeover/verify/verdict.hpp"
#include "cli.hpp"

namespace changeover::cli {

/// V K [--change M] [--circular|--linear].
struct ParameterRequest {
  std::uint64_t v = 0;
  std::uint64_t k = 0;
  std::optional<std::uint64_t> change;
  bool circular = false;
  bool linear = false;

  void add_to(Verb& verb);

  /// What is asked, once for each kind that may answer: the named one, or circular and linear.
  /// @throws UsageError, ImpossibleParameters.
  [[nodiscard]] std::vector<Parameters> parameters() const;
};

/// [--format WORD] [--json] [-o FILE].
struct OutputRequest {
  std::string format;
  bool json = false;
  std::string path;

  /// The first word is the default.
  void add_to(Verb& verb, const std::vector<std::string>& formats);

  /// The chosen format; --json is --format json. @throws UsageError if they contradict each other.
  [[nodiscard]] std::string chosen() const;

  /// Tries whether FILE can be written, so that long work is not done in vain. @throws MissingResource.
  void check_writable() const;
};

/// Writes all of an answer to the output that was asked for; "" and "-" are standard output.
void deliver(const std::string& text, const std::string& path);

/// The best that is known of some parameters: what the constructions offer, and for v ≤ 120 also what the
/// closure rules make of it.
[[nodiscard]] std::optional<Offer> best_known(const Parameters& p);

/// The best offer over some kinds, circular before linear among equals.
[[nodiscard]] std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                              const std::string& construction);

/// What is known of a design after it was verified.
struct Judgement {
  DesignVerdict verdict;
  Bound bound;              ///< the lower bound that the design is measured by
  std::string certificate;  ///< how it was verified, in a few words
};

/// Verifies a stream of blocks and rewinds it. If the list is long and is the development of base blocks
/// over Z_v, their differences are checked instead. @throws InternalError if what was promised does not hold.
[[nodiscard]] Judgement judge(BlockSource& source, const Offer& promise);

/// The same for a design without a promise, e.g. a user's; it need not be valid. `proved` is a bound that was
/// proved just now and may be larger than those that are known.
[[nodiscard]] Judgement judge(const Verdict& verdict, const std::optional<Bound>& proved = {});

/// "tight, minimum: 366 blocks, the lower bound (counting)", and the like.
[[nodiscard]] std::string quality(const Judgement& judgement);

/// "C(v,2) pairs" etc. for a line about an element-wise summary; plural by count.
[[nodiscard]] std::string count_of(std::uint64_t n, const std::string& singular);

/// Whether answers to standard output may be coloured: a terminal, and NO_COLOR is not set.
[[nodiscard]] bool may_colour(const OutputFile& out);

/// The columns of the terminal, COLUMNS, or 100.
[[nodiscard]] std::size_t terminal_width(const OutputFile& out);

}  // namespace changeover::cli
