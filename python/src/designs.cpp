// Designs and verdicts: made, read, verified, written, compared, enlarged, streamed.
#include <algorithm>
#include <map>
#include <sstream>

#include "bind.hpp"
#include "changeover/bounds/lower_bound.hpp"
#include "changeover/construct/enlarge.hpp"
#include "changeover/construct/explanation.hpp"
#include "changeover/construct/registry.hpp"
#include "changeover/core/error.hpp"
#include "changeover/io/formats.hpp"
#include "changeover/io/input.hpp"
#include "changeover/io/other_formats.hpp"
#include "changeover/io/tables.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "foreign_blocks.hpp"
#include "gil.hpp"
#include "long_work.hpp"

namespace changeover::python {
namespace {

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
                                  const std::optional<std::string>& kind, std::uint32_t strength) {
  std::vector<Parameters> asked;
  for (const Kind each : kinds_of(kind)) {
    asked.push_back({.v = v, .k = k, .change = change, .kind = each, .strength = strength});
    check(asked.back());
  }
  return asked;
}

std::optional<HeldDesign> design(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                                 const std::optional<std::string>& kind, std::uint32_t strength,
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
    const auto tuple = [](std::span<const Element> elements) {
      py::tuple all(elements.size());
      for (std::size_t i = 0; i < elements.size(); ++i) {
        all[i] = py::int_(elements[i]);
      }
      return all;
    };
    steps.append(
        py::make_tuple(tuple(step.block()), tuple(step.introduced()), tuple(step.leaving())));
  }
  return steps;
}

// A stream of blocks in batches, verified on the way.
class Stream {
 public:
  Stream(std::unique_ptr<BlockSource> source, std::uint64_t b, std::size_t batch)
      : source_(std::move(source)), running_(source_->parameters()), b_(b), batch_(batch) {}

  [[nodiscard]] Blocks next() {
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
          std::copy(read.begin(), read.end(), room->data() + filled);
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
    return {room, room->data(), filled / k, k};
  }

  [[nodiscard]] std::uint64_t b() const { return b_; }
  [[nodiscard]] const Parameters& parameters() const { return source_->parameters(); }

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

py::dict as_dict_of(const RecipeNode& node) {
  py::dict one;
  one["construction"] = std::string(node.construction->name());
  one["v"] = node.parameters.v;
  one["k"] = node.parameters.k;
  one["change"] = node.parameters.change;
  one["kind"] = std::string(to_string(node.parameters.kind));
  one["explanation"] = node.explanation;
  one["citation"] = node.citation;
  one["b"] = node.b;
  py::list inputs;
  for (const RecipeNode& input : node.inputs) {
    inputs.append(as_dict_of(input));
  }
  one["inputs"] = inputs;
  return one;
}

py::object explain(std::uint64_t v, std::uint64_t k, std::uint64_t change,
                   const std::optional<std::string>& kind, std::uint32_t strength) {
  const std::vector<Parameters> asked = asked_for(v, k, change, kind, strength);
  const auto tree = stoppable([&]() -> std::optional<RecipeNode> {
    const auto offer = best_of(asked, "");
    return offer ? std::optional(explained(Registry::standard(), offer->recipe)) : std::nullopt;
  });
  return tree ? py::object(as_dict_of(*tree)) : py::none();
}

HeldDesign enlarged(const HeldDesign& self, std::optional<std::uint64_t> new_elements,
                    std::optional<std::uint64_t> set, const std::string& factorization) {
  const auto kind = factorization_kind_from_string(factorization);
  if (!kind) {
    throw BadInput("factorization is 'circle' or 'doubled', not '" + factorization + "'");
  }
  if (!self.verdict.valid()) {
    throw BadInput("it is no valid " + name(self.design->parameters()) + "; its verdict says why");
  }
  return stoppable([&] {
    Enlarged larger =
        enlarge(*self.design, {.new_elements = new_elements, .set = set, .factorization = *kind});
    return held(surely_verified(std::move(larger.design), "the expanded design"));
  });
}

std::vector<py::dict> constructions() {
  std::vector<py::dict> all;
  for (const Construction* each : Registry::standard().constructions()) {
    py::dict one;
    one["name"] = std::string(each->name());
    one["summary"] = std::string(each->summary());
    one["preconditions"] = std::string(each->preconditions());
    one["guarantee"] = std::string(each->guarantee());
    one["citation"] = each->citation().to_string();
    all.push_back(one);
  }
  return all;
}

void bind_verdict(py::module_& module) {
  py::class_<Verdict>(module, "Verdict",
                      "What is true of a list of blocks; a true value if it is a design.")
      .def_property_readonly("valid", &Verdict::valid,
                             "It is a change covering design with these parameters.")
      .def_property_readonly("tight", &Verdict::tight, "Every pair is newly covered exactly once.")
      .def_property_readonly("economical", &Verdict::economical,
                             "It has as many blocks as the counting bound.")
      .def_readonly("b", &Verdict::b, "Number of blocks.")
      .def_property_readonly(
          "lower_bound", [](const Verdict& self) { return lower_bound(self.parameters).blocks; },
          "No design with these parameters has fewer blocks.")
      .def_property_readonly(
          "minimum",
          [](const Verdict& self) {
            return self.valid() && self.b == lower_bound(self.parameters).blocks;
          },
          "Proved: no design with these parameters has fewer blocks.")
      .def_property_readonly("v", [](const Verdict& self) { return self.parameters.v; })
      .def_property_readonly("k", [](const Verdict& self) { return self.parameters.k; })
      .def_property_readonly("change", [](const Verdict& self) { return self.parameters.change; })
      .def_property_readonly(
          "kind", [](const Verdict& self) { return std::string(to_string(self.parameters.kind)); })
      .def_property_readonly("strength",
                             [](const Verdict& self) { return self.parameters.strength; })
      .def_readonly("bad_steps", &Verdict::bad_steps,
                    "How many steps do not change exactly `change` elements.")
      .def_property_readonly(
          "bad_step_examples",
          [](const Verdict& self) {
            std::vector<std::tuple<std::uint64_t, std::uint64_t, std::uint64_t>> steps;
            for (const BadStep& step : self.bad_step_examples) {
              steps.emplace_back(step.from, step.to, step.changes);
            }
            return steps;
          },
          "Up to twenty (from, to, changes); blocks are numbered from 1.")
      .def_readonly("uncovered", &Verdict::uncovered, "How many pairs are in no block.")
      .def_readonly("uncovered_examples", &Verdict::uncovered_examples, "Up to twenty of them.")
      .def_readonly("excess", &Verdict::excess,
                    "Newly covered pairs, with repetition, less the distinct ones.")
      .def_readonly("fixed", &Verdict::fixed, "Elements that are in every block.")
      .def_property_readonly(
          "introductions",
          [](const Verdict& self) {
            std::vector<std::uint64_t> all;
            for (const ElementCount& each : self.elements) {
              all.push_back(each.introductions);
            }
            return all;
          },
          "i_x: by element, in how many blocks it is introduced.")
      .def_property_readonly(
          "memberships",
          [](const Verdict& self) {
            std::vector<std::uint64_t> all;
            for (const ElementCount& each : self.elements) {
              all.push_back(each.blocks);
            }
            return all;
          },
          "r_x: by element, how many blocks contain it.")
      .def(
          "as_dict", [](const Verdict& self) { return from_json(verdict_to_json(self)); },
          "Everything that the verifier found, as `changeover verify --json` has it under \"details\".")
      .def("__bool__", &Verdict::valid)
      .def("__repr__", [](const Verdict& self) {
        return "<Verdict: " + name(self.parameters) + ", " + std::to_string(self.b) + " blocks, " +
               (self.valid() ? (self.tight() ? "valid, tight>" : "valid>") : "not valid>");
      });
}

void bind_design_class(py::module_& module) {
  const auto parameters = [](const HeldDesign& self) -> const Parameters& {
    return self.design->parameters();
  };
  py::class_<HeldDesign>(
      module, "Design",
      "Blocks with their verdict: changeover.design() makes one, and Design(blocks, ...) is one of yours.")
      .def(py::init([](const py::object& blocks, std::optional<std::uint64_t> v,
                       std::optional<std::uint64_t> change, const std::string& kind,
                       std::uint32_t strength) {
             Design design = design_from(
                 blocks, {.v = v, .change = change, .kind = kind_of(kind), .strength = strength});
             return stoppable([&] { return verified_or_not(std::move(design)); });
           }),
           py::arg("blocks"), py::arg("v") = py::none(), py::arg("change") = py::none(),
           py::arg("kind") = "linear", py::arg("strength") = 2)
      .def_property_readonly(
          "v", [=](const HeldDesign& self) { return parameters(self).v; }, "Number of elements.")
      .def_property_readonly(
          "k", [=](const HeldDesign& self) { return parameters(self).k; }, "Elements in a block.")
      .def_property_readonly(
          "change", [=](const HeldDesign& self) { return parameters(self).change; },
          "Elements in which consecutive blocks differ.")
      .def_property_readonly(
          "kind",
          [=](const HeldDesign& self) { return std::string(to_string(parameters(self).kind)); },
          "'linear' or 'circular'.")
      .def_property_readonly("strength",
                             [=](const HeldDesign& self) { return parameters(self).strength; })
      .def_property_readonly(
          "b", [](const HeldDesign& self) { return self.design->block_count(); },
          "Number of blocks.")
      .def_property_readonly(
          "blocks", [](const HeldDesign& self) { return blocks_of(self.design); },
          "The blocks, shape (b, k), without a copy.")
      .def_property_readonly(
          "labels",
          [](const HeldDesign& self) {
            return self.design->labels().empty() ? std::nullopt
                                                 : std::optional(self.design->labels());
          },
          "Names of the elements, or None if they are numbers.")
      .def_readonly("verdict", &HeldDesign::verdict, "What the verifier found.")
      .def_property_readonly(
          "recipe",
          [](const HeldDesign& self) -> py::object {
            return self.design->recipe ? py::object(as_dict(*self.design->recipe)) : py::none();
          },
          "How the blocks are made, as a dict, if that is known.")
      .def_property_readonly("transitions", &transitions_of,
                             "A list of (block, introduced, leaving), tuples of element numbers.")
      .def(
          "expand", &enlarged, py::kw_only(), py::arg("new_elements") = py::none(),
          py::arg("set") = py::none(), py::arg("factorization") = "circle",
          "A design on more elements, verified: by the recursion with an expansion set, the one that is found as number "
          "`set` if given; where there is none, and for a number of new_elements (0: the best one), at unchanged subsets "
          "that may overlap. factorization, circle or doubled, is that of the new elements. Raises MissingResource with "
          "the reason if there is no such set or the elements cannot be inserted.")
      .def("to_string", &text_of, py::arg("format") = "text",
           "As text, json, csv, gap, sage, designtheory, ljcr or latex.")
      .def(
          "is_same_as",
          [](const HeldDesign& self, const HeldDesign& other, bool reversal) {
            return stoppable([&] {
              return find_isomorphism(*self.design, *other.design, {.reversal = reversal})
                  .has_value();
            });
          },
          py::arg("other"), py::arg("reversal") = false,
          "Whether they are the same up to names of elements and, if circular, rotation.")
      .def(
          "canonical",
          [](const HeldDesign& self, bool reversal) {
            return stoppable([&] {
              return verified_or_not(canonical_form(*self.design, {.reversal = reversal}).design);
            });
          },
          py::arg("reversal") = false,
          "The same design for all designs that are the same as this one.")
      .def_property_readonly(
          "group_order",
          [](const HeldDesign& self) {
            const std::string order = stoppable([&] { return automorphisms(*self.design).order; });
            return py::int_(py::str(order));
          },
          "Order of the automorphism group, exact.")
      .def(
          "__eq__",
          [](const HeldDesign& self, const HeldDesign& other) {
            return self.design->parameters() == other.design->parameters() &&
                   self.design->labels() == other.design->labels() &&
                   std::ranges::equal(self.design->elements(), other.design->elements());
          },
          py::is_operator())
      .def(py::pickle([](const HeldDesign& self) { return py::make_tuple(text_of(self, "json")); },
                      [](const py::tuple& state) {
                        const auto text = state[0].cast<std::string>();
                        return stoppable(
                            [&] { return verified_or_not(read_design(input_from_text(text))); });
                      }))
      .def("__len__", [](const HeldDesign& self) { return self.design->block_count(); })
      .def("__iter__",
           [](const HeldDesign& self) { return py::iter(py::cast(blocks_of(self.design))); })
      .def("__repr__", [=](const HeldDesign& self) {
        return "<" + name(parameters(self)) + ", " + std::to_string(self.design->block_count()) +
               " blocks" + (self.verdict.valid() ? ">" : ", not valid>");
      });
}

}  // namespace

void bind_designs(py::module_& module) {
  bind_verdict(module);
  bind_design_class(module);
  py::class_<Stream>(module, "Stream",
                     "Batches of blocks, one after another; verified when the last one was read.")
      .def_property_readonly("b", &Stream::b, "Number of blocks of the whole stream.")
      .def_property_readonly("v", [](const Stream& self) { return self.parameters().v; })
      .def_property_readonly("k", [](const Stream& self) { return self.parameters().k; })
      .def_property_readonly(
          "kind", [](const Stream& self) { return std::string(to_string(self.parameters().kind)); })
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &Stream::next);
  module.def(
      "design", &design, py::arg("v"), py::arg("k"), py::arg("change") = 2,
      py::arg("kind") = py::none(), py::arg("strength") = 2, py::kw_only(),
      py::arg("construction") = "",
      "The best design that is known without search, verified, or None.\n\n"
      "v elements, blocks of k, consecutive blocks differ in `change` elements; kind 'linear' or 'circular', "
      "or None: whichever has fewer blocks, circular if both have as many. Raises ImpossibleParameters if no "
      "such blocks can be written down, MissingResource if the design is too long for memory: see stream().");
  module.def(
      "stream", &stream, py::arg("v"), py::arg("k"), py::arg("change") = 2,
      py::arg("kind") = py::none(), py::kw_only(), py::arg("batch") = 65536,
      "The blocks of the same design as design() in batches: an iterator of Blocks of shape (at most batch, k), or "
      "None. For designs that are too long for memory. Raises InternalError at the end if what was read is no design.");
  module.def(
      "explain", &explain, py::arg("v"), py::arg("k"), py::arg("change") = 2,
      py::arg("kind") = py::none(), py::arg("strength") = 2,
      "How the design of design() is built: a dict with construction, v, k, change, kind, explanation, citation, b "
      "and inputs, a list of the same for the designs that it is made of. None if nothing serves.");
  module.def("constructions", &constructions,
             "A dict for each construction: name, summary, preconditions, guarantee, citation.");
  module.def(
      "verify",
      [](const py::object& blocks, std::optional<std::uint64_t> v,
         std::optional<std::uint64_t> change, const std::optional<std::string>& kind,
         std::uint32_t strength) {
        Design design =
            design_from(blocks, {.v = v,
                                 .change = change,
                                 .kind = kind ? std::optional(kind_of(*kind)) : std::nullopt,
                                 .strength = strength});
        return stoppable([&] { return verify(design, {.unchanged = true}); });
      },
      py::arg("blocks"), py::arg("v") = py::none(), py::arg("change") = py::none(),
      py::arg("kind") = py::none(), py::arg("strength") = 2,
      "What is true of a list of blocks.\n\n"
      "blocks: a Design, an array of shape (b, k) of whole numbers, or lists of numbers or names. If v is not said, what "
      "occurs is the whole set; if change is not said, the first two blocks say it; kind is 'linear' unless said. Raises "
      "BadInput for blocks of different sizes, repeated elements, or elements that are not below v. O(bk).");
  module.def(
      "read",
      [](const std::string& path) {
        return stoppable([&] { return verified_or_not(read_design(path)); });
      },
      py::arg("path"),
      "The design of a file of any format that is known: text, JSON, CSV, GAP, Sage, XML of designtheory.org. Its verdict may "
      "be that it is none. Raises BadInput with line and column, MissingResource.");
  module.def(
      "loads",
      [](const std::string& text) {
        return stoppable([&] { return verified_or_not(read_design(input_from_text(text))); });
      },
      py::arg("text"), "The same for a text in memory.");
}

}  // namespace changeover::python
