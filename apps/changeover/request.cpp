#include "request.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "changeover/construct/planner.hpp"
#include "changeover/core/error.hpp"
#include "changeover/verify/difference.hpp"
#include "changeover/verify/interval_difference.hpp"

namespace changeover::cli {

void ParameterRequest::add_to(Verb& verb) {
  verb.positional("V", v, "number of elements");
  verb.positional("K", k, "elements in a block");
  verb.option("-m,--change", change, "M",
              "elements in which consecutive blocks differ (default 2)");
  verb.flag("--circular", circular, "the last and the first block are consecutive too");
  verb.flag("--linear", linear, "they need not be");
}

std::vector<Parameters> ParameterRequest::parameters() const {
  if (circular && linear) {
    throw UsageError{"--circular and --linear exclude each other"};
  }
  std::vector<Parameters> asked;
  for (const Kind kind : {Kind::circular, Kind::linear}) {
    if (kind == Kind::circular ? !linear : !circular) {
      asked.push_back({.v = v, .k = k, .change = change.value_or(2), .kind = kind});
      check(asked.back());
    }
  }
  return asked;
}

void OutputRequest::add_to(Verb& verb, const std::vector<std::string>& formats) {
  format = formats.front();
  verb.choice("-f,--format", format, formats, "how the answer is written (default " + format + ")");
  if (std::find(formats.begin(), formats.end(), "json") != formats.end()) {
    verb.flag("--json", json, "the same as --format json");
  }
  verb.option("-o,--output", path, "FILE", "write to FILE instead of standard output");
}

std::string OutputRequest::chosen() const { return json ? "json" : format; }

void OutputRequest::check_writable() const {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (!path.empty() && path != "-" && (!exists(status) || is_regular_file(status))) {
    const OutputFile trial(path);  // Goes away without a trace.
  }
}

void deliver(const std::string& text, const std::string& path) {
  OutputFile out(path);
  out.write(text);
  out.commit();
}

std::optional<Offer> best_known(const Parameters& p) {
  return changeover::best_known(Registry::standard(), p,
                                [](const Design& design) { return verify(design).valid(); });
}

std::optional<Offer> best_offer(const std::vector<Parameters>& asked,
                                const std::string& construction) {
  std::optional<Offer> best;
  const auto consider = [&](std::optional<Offer> offer) {
    if (offer && (!best || offer->b < best->b)) {
      best = std::move(offer);
    }
  };
  for (const Parameters& p : asked) {
    if (construction.empty()) {
      consider(impossibility(p) ? std::nullopt : best_known(p));
    } else if (const Construction* named = Registry::standard().find(construction)) {
      consider(named->offer(p, Registry::standard()));
    }
  }
  return best;
}

Judgement judge(const Verdict& verdict, const std::optional<Bound>& proved) {
  Judgement judgement;
  judgement.bound = lower_bound(verdict.parameters);
  if (proved && proved->blocks > judgement.bound.blocks) {
    judgement.bound = *proved;
  }
  judgement.verdict = {.valid = verdict.valid(),
                       .tight = verdict.tight(),
                       .economical = verdict.economical(),
                       .b = verdict.b,
                       .lower_bound = judgement.bound.blocks,
                       .minimum_proved = verdict.valid() && verdict.b == judgement.bound.blocks};
  judgement.certificate = "every block read";
  if (verdict.valid() && verdict.b < judgement.bound.blocks) {
    throw InternalError(fmt::format("{} has {} blocks, below the lower bound {}",
                                    name(verdict.parameters), verdict.b, judgement.bound.blocks));
  }
  return judgement;
}

// The certificate of a development over Z_v, if the recipe has one.
static std::optional<DifferenceVerdict> certificate(const Recipe& recipe) {
  const Construction& construction = Registry::standard().construction_of(recipe);
  if (const auto base = construction.interval_base_blocks(recipe)) {
    return verify_differences(*base);
  }
  if (const auto base = construction.base_blocks(recipe)) {
    return verify_differences(*base);
  }
  return std::nullopt;
}

Judgement judge(BlockSource& source, const Offer& promise) {
  const Parameters& p = source.parameters();
  constexpr std::uint64_t many_elements = 20'000'000;
  const bool is_long = p.v > max_elements_in_memory || promise.b > many_elements / p.k;
  Judgement judgement;
  const auto differences = is_long ? certificate(promise.recipe) : std::nullopt;
  if (differences) {
    judgement.bound = lower_bound(p);
    judgement.verdict = {.valid = differences->valid(),
                         .tight = differences->tight,
                         .economical = differences->tight,
                         .b = differences->b,
                         .lower_bound = judgement.bound.blocks,
                         .minimum_proved = differences->b == judgement.bound.blocks};
    judgement.certificate = "differences of the base blocks";
  } else {
    judgement = judge(verify(source));
    if (!source.rewind()) {
      throw InternalError("a construction that cannot be read twice");
    }
  }
  const DesignVerdict& verdict = judgement.verdict;
  if (!verdict.valid || verdict.b != promise.b || (promise.tight && !verdict.tight) ||
      (promise.economical && !verdict.economical)) {
    throw InternalError(fmt::format("the construction {} does not keep its promise for {}",
                                    promise.recipe.construction, name(p)));
  }
  return judgement;
}

std::string quality(const Judgement& judgement) {
  const DesignVerdict& verdict = judgement.verdict;
  std::string text;
  if (verdict.tight) {
    text += "tight, ";
  } else if (verdict.economical) {
    text += "economical, ";
  }
  if (verdict.minimum_proved) {
    return text + fmt::format("minimum (its {} {} the lower bound: {})",
                              count_of(verdict.b, "block"), verdict.b == 1 ? "is" : "are",
                              judgement.bound.name);
  }
  return text + fmt::format("{} {} over the lower bound {}",
                            count_of(verdict.b - verdict.lower_bound, "block"),
                            verdict.b - verdict.lower_bound == 1 ? "is" : "are",
                            verdict.lower_bound);
}

std::string count_of(std::uint64_t n, const std::string& singular) {
  return fmt::format("{} {}{}", n, singular, n == 1 ? "" : "s");
}

bool may_colour(const OutputFile& out) {
  const char* no_colour = std::getenv("NO_COLOR");
  return out.is_standard_output() && isatty(STDOUT_FILENO) != 0 &&
         (no_colour == nullptr || *no_colour == '\0');
}

std::size_t terminal_width(const OutputFile& out) {
  constexpr std::size_t fallback = 100;
  if (const char* columns = std::getenv("COLUMNS")) {
    std::size_t width = 0;
    const std::string_view text(columns);
    if (std::from_chars(text.data(), text.data() + text.size(), width).ec == std::errc() &&
        width > 0) {
      return width;
    }
  }
  winsize size{};
  if (out.is_standard_output() && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    return size.ws_col;
  }
  return fallback;
}

}  // namespace changeover::cli
