#include "request/parameters.hpp"

#include <fmt/format.h>

#include <string_view>

#include "cli/cli.hpp"
#include "core/each.hpp"
#include "core/parsed.hpp"

namespace changeover::cli {

void add_kind_to(Verb& verb, std::optional<Kind>& kind, const std::string& circular,
                 const std::string& linear) {
  verb.flag(
      "--circular", [&kind] { kind = Kind::circular; }, circular);
  verb.flag(
      "--linear", [&kind] { kind = Kind::linear; }, linear);
  verb.exclude({"--circular", "--linear"});
}

std::uint32_t strength_of(std::optional<std::uint64_t> named) {
  if (named && (*named < 2 || *named > max_strength)) {
    throw UsageError{
        fmt::format("--strength {} is out of range; give 2 to {}", *named, max_strength)};
  }
  return static_cast<std::uint32_t>(named.value_or(2));
}

std::vector<Kind> kinds_of(std::optional<Kind> named) {
  return named ? std::vector{*named} : std::vector{Kind::circular, Kind::linear};
}

std::optional<std::uint64_t> whole_number(const std::string& text) {
  return parsed<std::uint64_t>(text);
}

void ParameterRequest::add_to(Verb& verb, bool required, const std::string& without) {
  verb.positional("V", v, "number of elements", required);
  verb.positional("K", k, "elements in a block", required);
  verb.option("-m,--change", change, "M",
              "elements in which consecutive blocks differ (default 2)");
  add_kind_to(verb, kind, "the last and the first block are consecutive too",
              "the first and last block need not be consecutive (" + without + ")");
}

void ParameterRequest::add_beside_label_to(Verb& verb, std::string& what, std::string& k_typed) {
  verb.positional("LABEL", what,
                  "label of a design (or its beginning), as 20.5.2.linear.39; label of a cell, as "
                  "20.5.2.linear; or V");
  verb.positional("K", k_typed, "elements in a block, after V", false);
  verb.option("-m,--change", change, "M",
              "after V K: elements in which consecutive blocks differ (default 2)");
  add_strength_to(verb);
  add_kind_to(verb, kind, "after V K: circular designs only",
              "after V K: linear designs only (default: both kinds are looked at)");
  verb.rule("--change, --strength, --circular and --linear are for V K: a label says them itself");
  verb.require([this, &what, &k_typed] {
    if (k_typed.empty()) {
      refuse_beside_label(what);
    }
  });
}

void ParameterRequest::refuse_beside_label(const std::string& label) const {
  const char* const named = change                   ? "--change"
                            : strength               ? "--strength"
                            : kind == Kind::circular ? "--circular"
                            : kind == Kind::linear   ? "--linear"
                                                     : nullptr;
  if (named != nullptr && !whole_number(label)) {
    throw UsageError{
        fmt::format("{} is for V K; leave it out, for the label {} says it", named, label)};
  }
}

void ParameterRequest::add_strength_to(Verb& verb) {
  verb.option("-t,--strength", strength, "T", "cover every T-subset of the elements (default 2)");
}

Parameters ParameterRequest::of_kind(Kind one) const {
  if (!v || !k) {
    throw UsageError{"give V and K, the number of elements and of those in a block"};
  }
  const Parameters p{.v = *v,
                     .k = *k,
                     .change = change.value_or(2),
                     .kind = one,
                     .strength = strength_of(strength)};
  check(p);
  return p;
}

std::vector<Parameters> ParameterRequest::of_each_kind() const {
  return each_of<Parameters>(kinds_of(kind), [&](const Kind each) { return of_kind(each); });
}

std::vector<Parameters> ParameterRequest::of_each_kind(const std::string& v_typed,
                                                       const std::string& k_typed) const {
  ParameterRequest asked = *this;
  asked.v = whole_number(v_typed);
  asked.k = whole_number(k_typed);
  if (!asked.v && v_typed.find('.') != std::string::npos) {
    throw UsageError{fmt::format(
        "'{}' is not a number V; a label, as 20.5.2.linear, has no K after it", v_typed)};
  }
  if (!asked.v) {
    throw UsageError{fmt::format(
        "'{}' is neither a label nor a number V; give a label as 20.5.2.linear, or V and K",
        v_typed)};
  }
  if (k_typed.empty()) {
    throw UsageError{fmt::format("{} is a number V, and K is missing; give V and K", v_typed)};
  }
  if (!asked.k) {
    throw UsageError{
        fmt::format("'{}' after {} is not a number K; give V and K", k_typed, v_typed)};
  }
  return asked.of_each_kind();
}

ReadOptions ParameterRequest::reading() const {
  ReadOptions options{.v = v, .k = k, .change = change, .kind = kind, .strength = {}};
  if (strength) {
    options.strength = strength_of(strength);
  }
  return options;
}

Range range_of(const std::string& option, const std::string& text, std::uint64_t least) {
  const auto number = [&](std::string_view word) {
    const auto value = parsed<std::uint64_t>(word);
    if (!value) {
      throw UsageError{fmt::format("{} {}: write A..B, ..B or A with whole numbers", option, text)};
    }
    return *value;
  };
  const std::size_t dots = text.find("..");
  Range range;
  if (dots == std::string::npos) {
    range.from = range.to = number(text);
  } else {
    range.from = dots == 0 ? least : number(std::string_view(text).substr(0, dots));
    range.to = number(std::string_view(text).substr(dots + 2));
  }
  if (range.from > range.to) {
    throw UsageError{
        fmt::format("{} {}: the range is empty; write the smaller number first", option, text)};
  }
  return range;
}

}  // namespace changeover::cli
