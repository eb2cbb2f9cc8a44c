#include "changeover/isomorphism/isomorphism.hpp"

#include <algorithm>
#include <utility>

#include "changeover/core/error.hpp"
#include "isomorphism/decimal.hpp"
#include "isomorphism/least_form.hpp"

namespace changeover {
namespace {

std::string group_order(const AutomorphismGroup& group) {
  Decimal order;
  // At most 2b position maps and v < 2³² elements: every factor fits.
  order.multiply(static_cast<std::uint32_t>(group.rotations));
  order.multiply(group.reflections ? 2 : 1);
  for (const auto& twins : group.twins) {
    for (std::size_t n = 2; n <= twins.size(); ++n) {
      order.multiply(static_cast<std::uint32_t>(n));
    }
  }
  return order.text();
}

}  // namespace

AutomorphismGroup automorphisms(const Design& design, const Sameness& same) {
  const std::size_t b = design.block_count();
  LeastForm least = least_form(design, same);
  AutomorphismGroup group;
  group.rotations = b == 0 ? 1 : b / least.step;
  group.reflections = least.mirror.has_value();
  group.twins = std::move(least.twins);
  group.order = group_order(group);

  for (const auto& twins : group.twins) {
    for (std::size_t i = 1; i < twins.size(); ++i) {
      Isomorphism exchange = identity(design.v());
      std::swap(exchange.elements[twins[i - 1]], exchange.elements[twins[i]]);
      group.generators.push_back(std::move(exchange));
    }
  }
  // Two readings with the same form: to the form by one of them, back by the other.
  StandardNames names(design);
  const auto add = [&](const Reading& reading) {
    names.read(reading);
    group.generators.push_back(compose(least.map, inverse(names.map(), b), b));
  };
  if (group.rotations > 1) {
    add({.start = least.reading.block(least.step, b), .backwards = least.reading.backwards});
  }
  if (least.mirror) {
    add(*least.mirror);
  }
  for (const Isomorphism& each : group.generators) {
    if (!carries(each, design, design)) {
      throw InternalError("a generator of a group is not a symmetry of its design");
    }
  }
  return group;
}

std::uint64_t standard_forms_in_class(const Design& design, const AutomorphismGroup& group,
                                      const Sameness& same) {
  const bool turns = design.parameters().kind == Kind::circular && same.rotation;
  const std::uint64_t b = std::max<std::uint64_t>(design.block_count(), 1);
  return (turns ? b : 1) * (same.reversal ? 2 : 1) / group.position_maps();
}

}  // namespace changeover
