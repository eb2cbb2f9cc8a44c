#include "changeover/isomorphism/isomorphism.hpp"

#include <utility>

#include "changeover/core/error.hpp"
#include "isomorphism/least_form.hpp"

namespace changeover {
namespace {

Design from_elements(const Parameters& p, const std::vector<Element>& elements) {
  Design design(p);
  design.reserve(elements.size() / p.k);
  for (std::size_t at = 0; at < elements.size(); at += p.k) {
    design.append(std::span(elements).subspan(at, p.k));
  }
  return design;
}

CanonicalForm checked(CanonicalForm form, const Design& design) {
  if (!carries(form.map, design, form.design)) {
    throw InternalError("a canonical form is not the image of its design");
  }
  return form;
}

}  // namespace

CanonicalForm canonical_form(const Design& design, const Sameness& same) {
  LeastForm least = least_form(design, same);
  return checked(
      {.design = from_elements(design.parameters(), least.form), .map = std::move(least.map)},
      design);
}

CanonicalForm standard_form(const Design& design) {
  return canonical_form(design, {.rotation = false, .reversal = false});
}

}  // namespace changeover
