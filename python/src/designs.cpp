// Designs and verdicts: made, read, verified, written, compared, enlarged, streamed.
#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <tuple>

#include "bind.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/best_known.hpp"
#include "changeover/construct/expansion.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/design.hpp"
#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/output.hpp"
#include "changeover/io/tables.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "core/each.hpp"
#include "gil.hpp"
#include "long_work.hpp"
#include "memory.hpp"

namespace changeover::python {
namespace {

std::uint32_t strength_of(std::uint64_t strength) {
  if (strength > std::numeric_limits<std::uint32_t>::max()) {
    throw BadInput("strength = " + std::to_string(strength) +
                   " cannot be; give a whole number from 2 to 4");
  }
  return static_cast<std::uint32_t>(strength);
}

HeldDesign verified_or_not(Design design) {
  Verdict verdict = verify(design, {.unchanged = true});
  return {std::make_shared<const Design>(std::move(design)), std::move(verdict)};
}

std::optional<Offer> best_of(const std::vector<Parameters>& asked,
                             const std::string& construction) {
  const Registry& registry = Registry::standard();
  const Construction* const named = registry.find(construction);
  if (named == nullptr && !construction.empty()) {
    throw BadInput("no construction is called '" + construction +
                   "'; changeover.constructions() lists them");
  }
  return best_offer(registry, asked, named);
}

std::vector<Parameters> asked_for(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                                  const std::optional<std::string>& kind, std::uint64_t strength) {
  return each_of<Parameters>(
      kinds_of(kind), [&](const Kind each) { return parameters(v, k, change, each, strength); });
}

std::optional<HeldDesign> design(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                                 const std::optional<std::string>& kind, std::uint64_t strength,
                                 const std::string& construction) {
  const std::vector<Parameters> asked = asked_for(v, k, change, kind, strength);
  return stoppable([&]() -> std::optional<HeldDesign> {
    const auto offer = best_of(asked, construction);
    if (!offer) {
      return std::nullopt;
    }
    const Registry& registry = Registry::standard();
    Design made = read_all(*registry.build(offer->recipe));
    made.recipe = offer->recipe;
    made.set_labels(registry.construction_of(offer->recipe).labels(offer->recipe, registry));
    return held(surely_verified(std::move(made), name(offer->recipe.parameters)));
  });
}

std::string text_of(const HeldDesign& self, const std::string& format) {
  StringSink sink;
  const Design& design = *self.design;
  using Writer = void (*)(const Design&, Sink&);
  static const std::map<std::string, Writer> others{
      {"text", [](const Design& d, Sink& s) { write_text(d, s); }},
      {"csv", [](const Design& d, Sink& s) { write_csv(d, s); }},
      {"gap", &write_gap},
      {"sage", &write_sage},
      {"designtheory", &write_designtheory},
      {"ljcr", &write_ljcr},
      {"latex", [](const Design& d, Sink& s) { write_latex(d, s); }}};
  if (format == "json") {
    const Bound bound = lower_bound(design.parameters());
    write_json(
        design, sink,
        DesignVerdict{.valid = self.verdict.valid(),
                      .tight = self.verdict.tight(),
                      .economical = self.verdict.economical(),
                      .b = self.verdict.b,
                      .lower_bound = bound.blocks,
                      .minimum_proved = self.verdict.valid() && self.verdict.b == bound.blocks});
  } else if (const auto found = others.find(format); found != others.end()) {
    found->second(design, sink);
  } else {
    throw BadInput("no format is called '" + format +
                   "'; there are text, json, csv, gap, sage, designtheory, ljcr, latex");
  }
  return sink.take();
}

py::list transitions_of(const HeldDesign& self) {
  py::list steps;
  DesignSource source(*self.design);
  for (Transitions step(source); step.next();) {
    steps.append(py::make_tuple(tuple_of(step.block()), tuple_of(step.introduced()),
                                tuple_of(step.leaving())));
  }
  return steps;
}

// What is said of blocks; the rest is inferred by the rules of files (io/input.hpp).
ReadOptions said(std::optional<std::uint64_t> v, std::optional<std::uint64_t> change,
                 const std::optional<std::string>& kind, std::uint64_t strength) {
  return {.v = v,
          .change = change,
          .kind = kind ? std::optional(kind_of(*kind)) : std::nullopt,
          .strength = strength_of(strength)};
}

// Rows of k numbers of 32 bits, and names of the elements, if they have some.
HeldDesign from_numbers(const py::bytes& bytes, std::size_t k, std::uint64_t v,
                        std::uint64_t change, const std::optional<std::string>& kind,
                        std::uint64_t strength,
                        const std::optional<std::vector<std::string>>& labels) {
  const ReadOptions options = said(v, change, kind, strength);
  const auto text = static_cast<std::string_view>(bytes);
  std::vector<Element> elements(text.size() / sizeof(Element));
  std::memcpy(elements.data(), text.data(), text.size());
  Design design(Parameters{.v = v,
                           .k = k,
                           .change = change,
                           .kind = options.kind.value_or(Kind::linear),
                           .strength = *options.strength});
  design.reserve(elements.size() / k);
  for (std::size_t i = 0; i < elements.size() / k; ++i) {
    design.append(std::span(elements).subspan(i * k, k));
  }
  if (labels && labels->size() == v) {
    design.set_labels(*labels);
  }
  return stoppable([&] { return verified_or_not(std::move(design)); });
}

HeldDesign read_text(const std::string& text, const std::string& name, const ReadOptions& options) {
  return stoppable([&] {
    return verified_or_not(
        read_design(name.empty() ? input_from_text(text) : input_from_text(text, name), options));
  });
}

// A stream of blocks in batches, verified on the way.
class Stream {
 public:
  Stream(std::unique_ptr<BlockSource> source, std::uint64_t b, std::size_t batch)
      : source_(std::move(source)), running_(source_->parameters()), b_(b), batch_(batch) {}

  [[nodiscard]] py::object next(const py::object& type) {
    const OneAtATime one(busy_);
    const auto k = static_cast<std::size_t>(source_->parameters().k);
    const auto room = std::make_shared<std::vector<Element>>(batch_ * k);
    std::size_t filled = 0;
    {
      const GilReleased released;
      while (filled < room->size()) {
        const auto read = source_->read(std::span(*room).subspan(filled));
        if (read.empty()) {
          break;
        }
        if (read.data() != room->data() + filled) {
          std::ranges::copy(read, room->data() + filled);
        }
        filled += read.size();
      }
      running_.add(std::span<const Element>(*room).first(filled));
    }
    if (filled == 0) {
      finish();
      throw py::stop_iteration();
    }
    seen_ += filled / k;
    return blocks_of(type, room, room->data(), filled / k, k);
  }

  [[nodiscard]] py::dict facts() const {
    py::dict facts = facts_of(source_->parameters());
    facts["b"] = b_;
    return facts;
  }

 private:
  void finish() {
    if (!finished_) {
      finished_ = true;
      const Verdict verdict = running_.finish();
      if (!verdict.valid() || seen_ != b_) {
        throw InternalError(name(source_->parameters()) +
                            ": the stream is not the design that was promised");
      }
    }
  }

  std::unique_ptr<BlockSource> source_;
  RunningVerdict running_;
  std::uint64_t b_;
  std::size_t batch_;
  std::uint64_t seen_ = 0;
  bool finished_ = false;
  bool busy_ = false;
};

std::unique_ptr<Stream> stream(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                               const std::optional<std::string>& kind, std::size_t batch) {
  if (batch == 0 || batch > (std::size_t{1} << 30)) {
    throw BadInput("batch is a number of blocks, 1 to 2^30");
  }
  const std::vector<Parameters> asked = asked_for(v, k, change, kind, 2);
  return stoppable([&]() -> std::unique_ptr<Stream> {
    const auto offer = best_of(asked, "");
    return offer ? std::make_unique<Stream>(Registry::standard().build(offer->recipe), offer->b,
                                            batch)
                 : nullptr;
  });
}

HeldDesign enlarged(const HeldDesign& self, std::optional<std::uint64_t> new_elements,
                    std::optional<std::uint64_t> set, const std::string& factorization) {
  const auto kind = factorization_kind_from_string(factorization);
  if (!kind) {
    throw BadInput("factorization is 'circle' or 'doubled', not '" + factorization + "'");
  }
  if (!self.verdict.valid()) {
    throw BadInput("it is not a valid " + name(self.design->parameters()) +
                   "; its verdict says why");
  }
  return stoppable([&] {
    Enlarged larger =
        enlarge(*self.design, {.new_elements = new_elements, .set = set, .factorization = *kind});
    return held(surely_verified(std::move(larger.design), "the expanded design"));
  });
}

py::dict facts_of_design(const HeldDesign& self) {
  const Design& design = *self.design;
  py::dict facts = facts_of(design.parameters());
  facts["name"] = name(design.parameters());
  facts["b"] = design.block_count();
  facts["labels"] = design.labels().empty() ? py::none() : py::cast(design.labels());
  facts["valid"] = self.verdict.valid();
  return facts;
}

bool equal(const HeldDesign& self, const HeldDesign& other) {
  return self.design->parameters() == other.design->parameters() &&
         self.design->labels() == other.design->labels() &&
         std::ranges::equal(self.design->elements(), other.design->elements());
}

bool same(const HeldDesign& self, const HeldDesign& other, bool reversal) {
  return stoppable([&] {
    return find_isomorphism(*self.design, *other.design, {.reversal = reversal}).has_value();
  });
}

HeldDesign canonical(const HeldDesign& self, bool reversal) {
  return stoppable(
      [&] { return verified_or_not(canonical_form(*self.design, {.reversal = reversal}).design); });
}

}  // namespace

Kind kind_of(const std::string& word) {
  if (const auto kind = kind_from_string(word)) {
    return *kind;
  }
  throw BadInput("kind is 'linear' or 'circular', not '" + word + "'");
}

std::vector<Kind> kinds_of(const std::optional<std::string>& word) {
  return word ? std::vector<Kind>{kind_of(*word)} : std::vector<Kind>{Kind::circular, Kind::linear};
}

Parameters parameters(std::uint64_t v, std::uint64_t k, std::uint64_t change, Kind kind,
                      std::uint64_t strength) {
  const Parameters p{
      .v = v, .k = k, .change = change, .kind = kind, .strength = strength_of(strength)};
  check(p);
  return p;
}

py::dict facts_of(const Parameters& parameters) {
  return py::dict(py::arg("v") = parameters.v, py::arg("k") = parameters.k,
                  py::arg("change") = parameters.change,
                  py::arg("kind") = std::string(to_string(parameters.kind)),
                  py::arg("strength") = parameters.strength);
}

HeldDesign held(VerifiedDesign design) {
  Verdict verdict = design.verdict();
  return {std::make_shared<const Design>(std::move(design).take()), std::move(verdict)};
}

namespace {

DrawnPicture drawn(const HeldDesign& self, const std::string& kind, const std::string& theme,
                   const std::string& order, const std::string& colour, bool leaving,
                   std::uint64_t first, const std::optional<std::uint64_t>& last) {
  const auto picture = picture_kind_from_string(kind);
  const auto by = element_order_from_string(order);
  const auto says = stay_colour_from_string(colour);
  const auto ground = theme_from_string(theme);
  if (!picture || !by || !says || !ground) {
    throw BadInput(
        "there is no such picture, order, colour or theme; help(changeover.Design.draw) has them");
  }
  const DrawOptions options{.picture = *picture,
                            .order = *by,
                            .colour = *says,
                            .leaving = leaving,
                            .from = first,
                            .to = last};
  const Design& design = *self.design;
  if (const auto defect = draw_defect(design.parameters(), design.block_count(), options)) {
    throw BadInput(*defect);
  }
  return stoppable([&] { return written(draw(design, options), *ground); });
}

}  // namespace

void bind_designs(py::module_& module) {
  py::class_<HeldDesign>(module, "Design")
      .def("facts", &facts_of_design)
      .def("verdict", [](const HeldDesign& self) { return verdict_to_json(self.verdict); })
      .def("lower_bound",
           [](const HeldDesign& self) { return lower_bound(self.verdict.parameters).blocks; })
      .def("blocks",
           [](const HeldDesign& self, const py::object& type) {
             const Design& design = *self.design;
             return blocks_of(type, self.design, design.elements().data(), design.block_count(),
                              static_cast<std::size_t>(design.k()));
           })
      .def("recipe",
           [](const HeldDesign& self) {
             return self.design->recipe ? recipe_to_json(*self.design->recipe) : "null";
           })
      .def("transitions", &transitions_of)
      .def("expand", &enlarged)
      .def("to_string", &text_of)
      .def("draw", &drawn)
      .def("is_same_as", &same)
      .def("canonical", &canonical)
      .def("group_order",
           [](const HeldDesign& self) {
             return stoppable([&] { return automorphisms(*self.design).order; });
           })
      .def("equals", &equal)
      .def_static("best_known", &design)
      .def_static("from_numbers", &from_numbers, py::arg("elements"), py::arg("k"), py::arg("v"),
                  py::arg("change"), py::arg("kind"), py::arg("strength"),
                  py::arg("labels") = py::none())
      .def_static("read_text", [](const std::string& text,
                                  const std::string& name) { return read_text(text, name, {}); })
      .def_static("read_text",
                  [](const std::string& text, const std::string& name,
                     std::optional<std::uint64_t> v, std::optional<std::uint64_t> change,
                     const std::optional<std::string>& kind, std::uint64_t strength) {
                    return read_text(text, name, said(v, change, kind, strength));
                  })
      .def_static("read", [](const std::string& path) {
        return stoppable([&] { return verified_or_not(read_design(path)); });
      });
  module.attr("most_elements") = max_elements_in_memory;
  py::class_<Stream>(module, "Stream")
      .def_static("of", &stream)
      .def("facts", &Stream::facts)
      .def("next", &Stream::next);
  module.def("write_file", [](const std::string& path, const std::string& text) {
    OutputFile file(path);
    file.write(text);
    file.commit();
  });
}

}  // namespace changeover::python
