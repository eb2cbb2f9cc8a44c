// changeover factorize N: 1-factorizations of the complete graph K_N.
#include <fmt/format.h>

#include "answer/answer.hpp"
#include "changeover/construct/one_factorization.hpp"
#include "changeover/core/error.hpp"
#include "changeover/draw/draw.hpp"
#include "io/write/json_writer.hpp"
#include "verbs.hpp"

namespace changeover::cli {
namespace {

struct FactorizeRequest {
  std::optional<std::uint64_t> order;
  std::string kind = "circle";
  bool near = false;
  OutputRequest output;
};

using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct Factors {
  std::vector<Edges> edges;
  std::vector<std::uint32_t> isolated;  // of a near-1-factorization, one for each factor
};

Factors near_factors(std::uint32_t order) {
  Factors factors;
  for (const NearOneFactor& factor : near_one_factorization(order)) {
    Edges edges;
    for (const Edge& edge : factor.edges) {
      edges.emplace_back(edge.a, edge.b);
    }
    factors.edges.push_back(std::move(edges));
    factors.isolated.push_back(factor.isolated);
  }
  return factors;
}

Factors factors(std::uint32_t order, FactorizationKind kind) {
  const OneFactorization factorization = one_factorization(order, kind);
  if (const auto defect = factorization_defect(factorization)) {
    throw InternalError("the 1-factorization is not one: " + *defect);
  }
  Factors factors;
  for (const OneFactor& factor : factorization.factors) {
    Edges edges;
    for (const Edge& edge : factor) {
      edges.emplace_back(edge.a, edge.b);
    }
    factors.edges.push_back(std::move(edges));
  }
  return factors;
}

std::string as_text(const Factors& factors) {
  std::string text;
  for (std::size_t i = 0; i < factors.edges.size(); ++i) {
    text += fmt::format("F_{}:", i + 1);
    for (const auto& [a, b] : factors.edges[i]) {
      text += fmt::format(" {{{},{}}}", a, b);
    }
    text += factors.isolated.empty() ? "\n" : fmt::format(" {}\n", factors.isolated[i]);
  }
  return text;
}

std::string as_json(const FactorizeRequest& request, const Factors& factors) {
  JsonWriter json;
  json.begin_object().key("order").value(*request.order);
  json.key("kind").value(request.near ? "near" : request.kind);
  json.list("factors", factors.edges, [&](const Edges& edges) {
    json.list(edges, [&](const auto& edge) {
      json.begin_array().value(edge.first).value(edge.second).end_array();
    });
  });
  if (request.near) {
    json.key("isolated").value(factors.isolated);
  }
  json.end_object();
  return json.take() + "\n";
}

Answer run(const FactorizeRequest& request) {
  constexpr std::uint64_t most = 20'000;  // n²/2 edges are written
  if (*request.order > most) {
    throw UsageError{
        fmt::format("N = {} exceeds {}: K_N has too many edges to list", *request.order, most)};
  }
  const auto order = static_cast<std::uint32_t>(*request.order);
  const Factors found = request.near
                            ? near_factors(order)
                            : factors(order, factorization_kind_from_string(request.kind).value());
  const std::string format = request.output.format();
  if (format == "svg" || format == "tikz") {
    constexpr std::uint64_t most_drawn = 40;
    if (request.near || order > most_drawn) {
      throw UsageError{fmt::format(
          "only 1-factorizations of K_2 to K_{} are drawn; write text or json", most_drawn)};
    }
    FactorFigure figure{.order = order, .factors = found.edges};
    if (request.kind == "circle" && order > 2) {
      figure.centre = order - 1;  // the vertex that the rotation fixes
    }
    const Picture picture = draw_factors(figure);
    return text_answer(format == "svg" ? svg(picture) : tikz(picture), request.output);
  }
  return text_answer(request.output.json() ? as_json(request, found) : as_text(found),
                     request.output);
}

}  // namespace

void add_factorize(Program& program) {
  auto [verb, request] = program.add<FactorizeRequest>(
      "factorize", "make a 1-factorization of the complete graph K_N", run);
  verb.positional("N", request.order, "number of vertices, even (odd with --near)");
  verb.choice("--kind", request.kind, {"circle", "doubled"},
              "circle: by rotation, GK_N; doubled: from two copies of K_(N/2) (default circle)");
  verb.flag("--near", request.near, "a near-1-factorization of K_N, N odd; not with --kind");
  verb.exclude({"--near", "--kind"});
  request.output.add_to(verb, {"text", "json", "svg", "tikz"});
  verb.examples({"changeover factorize 8", "changeover factorize 8 --kind doubled --json",
                 "changeover factorize 6 --format svg -o k6.svg", "changeover factorize 7 --near"});
}

}  // namespace changeover::cli
