// What is known of a design after it was verified; every design passes this before it is shown.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/output.hpp"
#include "changeover/verify/verdict.hpp"

namespace changeover::cli {

/// What is known of a design after it was verified.
struct Judgement {
  DesignVerdict verdict;
  Bound bound;              ///< the lower bound that the design is measured by
  std::string certificate;  ///< how it was verified, in a few words
  /// The bound is of a built-in table, where a search was to prove one: its name says so and is
  /// always shown.
  bool from_tables = false;
};

/// Verifies a stream of blocks and rewinds it. If the list is long and is the development of base
/// blocks, their differences are checked instead. @throws InternalError if what was
/// promised does not hold.
///
/// A list of 10⁸ blocks without such a certificate takes a minute or more, in which nothing would
/// be shown. So a caller that only passes blocks on may do one of two things instead:
///   - write them to a file, verified while they are written: the file appears whole when the
///     verdict is good, and not at all when it is not;
///   - write them to standard output and say first that they are verified while they are written,
///     and last that they were. If the verdict is bad, the last line is missing and the exit code
///     is 5.
[[nodiscard]] Judgement judge(BlockSource& source, const Offer& promise);

/// Whether that takes long unless there is a certificate.
[[nodiscard]] bool takes_long_to_judge(const BlockSource& source, const Offer& promise);

/// The part of judge() that reads no blocks: the judgement of a long list with a certificate, else
/// nothing.
[[nodiscard]] std::optional<Judgement> judge_at_once(const BlockSource& source,
                                                     const Offer& promise);

/// What to say of a design that takes_long_to_judge(): which command verifies it, if one can.
/// `options` are more options of that command, with a space before each.
[[nodiscard]] std::string not_verified_here(const Parameters& p, std::string_view options = {});

/// Hands on the blocks of a stream and verifies them on the way. A caller that reads the end of it
/// has a design that was verified: read() @throws InternalError there if what was promised does not
/// hold.
class JudgedWhileRead final : public BlockSource {
 public:
  /// Both must outlive it.
  JudgedWhileRead(BlockSource& source, const Offer& promise);

  [[nodiscard]] const Parameters& parameters() const override { return source_.parameters(); }
  [[nodiscard]] std::optional<std::uint64_t> block_count() const override {
    return source_.block_count();
  }
  std::span<const Element> read(std::span<Element> room) override;
  bool rewind() override { return false; }

  /// Once the end was read.
  [[nodiscard]] const Judgement& judgement() const;

 private:
  BlockSource& source_;
  const Offer& promise_;
  RunningVerdict running_;
  std::uint64_t blocks_ = 0;
  std::optional<Judgement> judgement_;
};

/// The same for a design without a promise, e.g. a user's; it need not be valid. `proved` is a
/// bound that was proved just now; it is the one that counts unless a larger one is known.
[[nodiscard]] Judgement judge(const Verdict& verdict, const std::optional<Bound>& proved = {});

/// "tight, minimum: 366 blocks, the lower bound (counting)", and the like.
[[nodiscard]] std::string quality(const Judgement& judgement);

/// The names of one or two elements where all others, three or more, are numbers: perhaps ∞,
/// perhaps a slip of the keyboard. Empty otherwise. O(labels).
[[nodiscard]] std::vector<std::string> names_among_numbers(const std::vector<std::string>& labels);

/// The document of `verify --json`: {"verdict":…,"bound":{"name","reason"},"details":…,
/// "names_among_numbers":[…]}.
[[nodiscard]] std::string verify_json(const Verdict& verdict, const Judgement& judgement,
                                      const std::vector<std::string>& labels);

}  // namespace changeover::cli
