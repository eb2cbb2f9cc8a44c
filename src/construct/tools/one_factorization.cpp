#include "changeover/construct/one_factorization.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "changeover/core/error.hpp"
#include "core/words.hpp"

namespace changeover {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

void check_even(std::uint32_t order) {
  if (order == 0 || order % 2 != 0) {
    throw ImpossibleParameters(fmt::format(
        "K_{} has no 1-factorization: the number of vertices must be even and at least 2", order));
  }
}

void check_index(std::uint32_t order, std::uint32_t index) {
  check_even(order);
  if (index >= order - 1) {
    throw BadInput(fmt::format("factor {} of K_{}: factors are numbered from 0 to {}", index, order,
                               order - 2));
  }
}

/// 2·centre − vertex mod modulus: where the reflection that fixes `centre` takes `vertex`.
std::uint32_t reflected(std::uint32_t vertex, std::uint32_t centre, std::uint32_t modulus) {
  const std::uint64_t sum = std::uint64_t{2} * centre + modulus - vertex;
  return static_cast<std::uint32_t>(sum % modulus);
}

/// Appends {i−j, i+j} mod modulus for all j ≥ 1, both ends raised by `offset`, in ascending order,
/// and {centre, opposite} in its place unless `opposite` is `nowhere`. `opposite` is not raised.
void append_reflection(OneFactor& factor, std::uint32_t centre, std::uint32_t modulus,
                       std::uint32_t offset, std::uint32_t opposite) {
  for (std::uint32_t vertex = 0; vertex < modulus; ++vertex) {
    const std::uint32_t image = reflected(vertex, centre, modulus);
    if (vertex < image) {
      factor.push_back({offset + vertex, offset + image});
    } else if (vertex == image && opposite != nowhere) {
      factor.push_back({offset + vertex, opposite});
    }
  }
}

std::uint64_t pair_index(Edge edge) { return std::uint64_t{edge.b} * (edge.b - 1) / 2 + edge.a; }

/// One line on why `factor` is not a 1-factor on that many vertices. `last_met` holds, for every
/// vertex, the factor before this one that met it last, and is brought up to date.
std::optional<std::string> factor_defect(const OneFactor& factor, std::uint32_t index,
                                         std::vector<std::uint32_t>& last_met) {
  const std::size_t order = last_met.size();
  for (const Edge& edge : factor) {
    const auto wrong = [&](std::string_view what) {
      return fmt::format("edge {{{}, {}}} of factor {} {}", edge.a, edge.b, index, what);
    };
    if (edge.a >= order || edge.b >= order) {
      return wrong(fmt::format("has a vertex outside 0..{}", order - 1));
    }
    if (edge.a == edge.b) {
      return wrong("joins a vertex with itself");
    }
    if (edge.a > edge.b) {
      return wrong("is not written with the smaller vertex first");
    }
    for (const std::uint32_t vertex : {edge.a, edge.b}) {
      if (last_met[vertex] == index) {
        return fmt::format("factor {} meets vertex {} twice", index, vertex);
      }
      last_met[vertex] = index;
    }
  }
  const auto missed =
      std::ranges::find_if(last_met, [index](std::uint32_t last) { return last != index; });
  if (missed != last_met.end()) {
    return fmt::format("factor {} misses vertex {}", index, missed - last_met.begin());
  }
  return std::nullopt;
}

/// The other end of the edge at a vertex, for every factor: row f, column v.
class PartnerTable {
 public:
  explicit PartnerTable(const OneFactorization& factorization) : order_(factorization.order) {
    if (const auto defect = factorization_defect(factorization)) {
      throw BadInput(fmt::format("not a 1-factorization: {}", *defect));
    }
    partners_.resize(factorization.factors.size() * order_);
    for (std::size_t f = 0; f < factorization.factors.size(); ++f) {
      for (const Edge& edge : factorization.factors[f]) {
        partners_[f * order_ + edge.a] = edge.b;
        partners_[f * order_ + edge.b] = edge.a;
      }
    }
  }

  /// Number of vertices on the cycle through `start` in the union of factors f and g. Marks them.
  std::uint32_t walk(std::size_t f, std::size_t g, std::uint32_t start,
                     std::vector<bool>& visited) const {
    std::uint32_t length = 0;
    std::uint32_t vertex = start;
    do {
      visited[vertex] = true;
      vertex = partners_[f * order_ + vertex];
      visited[vertex] = true;
      vertex = partners_[g * order_ + vertex];
      length += 2;
    } while (vertex != start);
    return length;
  }

 private:
  std::size_t order_;
  std::vector<std::uint32_t> partners_;
};

}  // namespace

std::string_view to_string(FactorizationKind kind) {
  return kind == FactorizationKind::doubled ? "doubled" : "circle";
}

std::optional<FactorizationKind> factorization_kind_from_string(std::string_view name) {
  return named(name, {FactorizationKind::circle, FactorizationKind::doubled});
}

OneFactor circle_factor(std::uint32_t order, std::uint32_t index) {
  check_index(order, index);
  OneFactor factor;
  factor.reserve(order / 2);
  append_reflection(factor, index, order - 1, 0, order - 1);
  return factor;
}

OneFactor doubled_factor(std::uint32_t order, std::uint32_t index) {
  check_index(order, index);
  const std::uint32_t half = order / 2;
  const std::uint32_t inner = half % 2 == 0 ? half - 1 : half;  // factors made within the copies
  OneFactor factor;
  factor.reserve(half);
  if (index >= inner) {
    const std::uint32_t shift = index + 1 - half;
    for (std::uint32_t j = 0; j < half; ++j) {
      factor.push_back({j, half + (j < half - shift ? j + shift : j - (half - shift))});
    }
  } else if (half % 2 == 0) {
    append_reflection(factor, index, half - 1, 0, half - 1);
    append_reflection(factor, index, half - 1, half, order - 1);
  } else {
    append_reflection(factor, index, half, 0, half + index);
    append_reflection(factor, index, half, half, nowhere);
  }
  return factor;
}

OneFactorization one_factorization(std::uint32_t order, FactorizationKind kind) {
  check_even(order);
  OneFactorization factorization{.order = order, .factors = {}};
  factorization.factors.reserve(order - 1);
  for (std::uint32_t index = 0; index < order - 1; ++index) {
    factorization.factors.push_back(kind == FactorizationKind::doubled
                                        ? doubled_factor(order, index)
                                        : circle_factor(order, index));
  }
  return factorization;
}

std::vector<NearOneFactor> near_one_factorization(std::uint32_t order) {
  if (order % 2 == 0) {
    throw ImpossibleParameters(
        fmt::format("K_{} has no near-1-factorization: the number of vertices must be odd", order));
  }
  std::vector<NearOneFactor> factors;
  factors.reserve(order);
  for (std::uint32_t index = 0; index < order; ++index) {
    NearOneFactor factor{.isolated = index, .edges = {}};
    factor.edges.reserve(order / 2);
    append_reflection(factor.edges, index, order, 0, nowhere);
    factors.push_back(std::move(factor));
  }
  return factors;
}

std::optional<std::string> factorization_defect(const OneFactorization& factorization) {
  const std::uint32_t order = factorization.order;
  if (order == 0 || order % 2 != 0) {
    return fmt::format("the order is {}; it must be even and at least 2", order);
  }
  // Before anything of that size is allocated.
  if (factorization.factors.size() != order - 1) {
    return fmt::format("{} where K_{} needs {}", count_of(factorization.factors.size(), "factor"),
                       order, order - 1);
  }
  std::vector<std::uint32_t> last_met(order, nowhere);
  for (std::uint32_t f = 0; f < order - 1; ++f) {
    if (auto defect = factor_defect(factorization.factors[f], f, last_met)) {
      return defect;
    }
  }
  // All are 1-factors, so there are as many edges as in K_order: one is missing if one is repeated.
  std::vector<std::uint32_t> factor_of(std::uint64_t{order} * (order - 1) / 2, nowhere);
  std::optional<std::string> repeated;
  for (std::uint32_t f = 0; f < order - 1; ++f) {
    for (const Edge& edge : factorization.factors[f]) {
      std::uint32_t& owner = factor_of[pair_index(edge)];
      if (owner == nowhere) {
        owner = f;
      } else if (!repeated) {
        repeated = fmt::format("edge {{{}, {}}} is in factors {} and {}", edge.a, edge.b, owner, f);
      }
    }
  }
  if (!repeated) {
    return std::nullopt;
  }
  Edge missing{0, 1};
  while (factor_of[pair_index(missing)] != nowhere) {
    missing = missing.a + 1 < missing.b ? Edge{missing.a + 1, missing.b} : Edge{0, missing.b + 1};
  }
  return fmt::format("{}; edge {{{}, {}}} is in none", *repeated, missing.a, missing.b);
}

std::map<std::vector<std::uint32_t>, std::uint64_t> cycle_types(
    const OneFactorization& factorization) {
  const PartnerTable partners(factorization);
  std::map<std::vector<std::uint32_t>, std::uint64_t> types;
  std::vector<std::uint32_t> lengths;
  std::vector<bool> visited;
  for (std::size_t g = 1; g < factorization.factors.size(); ++g) {
    for (std::size_t f = 0; f < g; ++f) {
      lengths.clear();
      visited.assign(factorization.order, false);
      for (std::uint32_t start = 0; start < factorization.order; ++start) {
        if (!visited[start]) {
          lengths.push_back(partners.walk(f, g, start, visited));
        }
      }
      std::ranges::sort(lengths);
      ++types[lengths];
    }
  }
  return types;
}

bool is_perfect(const OneFactorization& factorization) {
  const PartnerTable partners(factorization);
  std::vector<bool> visited(factorization.order, false);
  for (std::size_t g = 1; g < factorization.factors.size(); ++g) {
    for (std::size_t f = 0; f < g; ++f) {
      if (partners.walk(f, g, 0, visited) != factorization.order) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace changeover
