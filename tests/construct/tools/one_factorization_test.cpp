#include "changeover/construct/one_factorization.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "changeover/core/error.hpp"
#include "message_of.hpp"

namespace changeover::one_factorization_test {
namespace {

using CycleTypes = std::map<std::vector<std::uint32_t>, std::uint64_t>;

constexpr FactorizationKind both_kinds[] = {FactorizationKind::circle, FactorizationKind::doubled};

bool is_prime(std::uint32_t n) {
  for (std::uint32_t d = 2; d * d <= n; ++d) {
    if (n % d == 0) {
      return false;
    }
  }
  return n >= 2;
}

/// The 1-factorization of K_6 drawn in [ChafeeStevens2025], a..f as 0..5, colour by colour.
OneFactorization paper_k6() {
  return {6,
          {{{1, 4}, {0, 2}, {3, 5}},
           {{2, 4}, {1, 3}, {0, 5}},
           {{3, 4}, {2, 5}, {0, 1}},
           {{4, 5}, {1, 2}, {0, 3}},
           {{0, 4}, {1, 5}, {2, 3}}}};
}

/// The 1-factorization of K_8 drawn in [ChafeeStevens2025], on 8..15 as it is printed.
std::vector<OneFactor> paper_k8() {
  return {{{8, 9}, {10, 14}, {11, 13}, {12, 15}}, {{8, 10}, {11, 14}, {12, 13}, {9, 15}},
          {{8, 11}, {9, 10}, {12, 14}, {13, 15}}, {{8, 15}, {9, 14}, {10, 13}, {11, 12}},
          {{8, 12}, {13, 14}, {9, 11}, {10, 15}}, {{8, 13}, {9, 12}, {10, 11}, {14, 15}},
          {{8, 14}, {9, 13}, {10, 12}, {11, 15}}};
}

OneFactorization lowered(const std::vector<OneFactor>& factors, std::uint32_t by) {
  OneFactorization result{static_cast<std::uint32_t>(factors.size() + 1), factors};
  for (OneFactor& factor : result.factors) {
    for (Edge& edge : factor) {
      edge = {edge.a - by, edge.b - by};
    }
  }
  return result;
}

std::set<std::set<Edge>> as_sets(const OneFactorization& factorization) {
  std::set<std::set<Edge>> sets;
  for (const OneFactor& factor : factorization.factors) {
    sets.insert(std::set<Edge>(factor.begin(), factor.end()));
  }
  return sets;
}

/// Which factor an edge is in, and where a factor leads from a vertex.
class Tables {
 public:
  explicit Tables(const OneFactorization& f)
      : n(f.order), colour_(std::size_t{n} * n), partner_(f.factors.size() * n) {
    for (std::uint32_t c = 0; c < f.factors.size(); ++c) {
      for (const Edge& e : f.factors[c]) {
        colour_[e.a * n + e.b] = colour_[e.b * n + e.a] = c;
        partner_[c * n + e.a] = e.b;
        partner_[c * n + e.b] = e.a;
      }
    }
  }
  [[nodiscard]] std::uint32_t colour(std::uint32_t u, std::uint32_t v) const {
    return colour_[u * n + v];
  }
  /// The vertices of the Hamiltonian cycle that leaves `start` along factor c and goes on along d.
  [[nodiscard]] std::vector<std::uint32_t> tour(std::uint32_t start, std::uint32_t c,
                                                std::uint32_t d) const {
    std::vector<std::uint32_t> vertices{start};
    while (vertices.size() < n) {
      vertices.push_back(partner_[(vertices.size() % 2 == 1 ? c : d) * n + vertices.back()]);
    }
    return vertices;
  }

  std::uint32_t n;

 private:
  std::vector<std::uint32_t> colour_, partner_;
};

/// All isomorphisms between two perfect 1-factorizations: each is settled by where it takes one
/// vertex and two factors, for it then follows a Hamiltonian cycle.
std::vector<std::vector<std::uint32_t>> isomorphisms(const OneFactorization& from,
                                                     const OneFactorization& to) {
  const Tables a(from);
  const Tables b(to);
  const std::uint32_t n = a.n;
  std::vector<std::vector<std::uint32_t>> found;
  const auto source = a.tour(0, 0, 1);
  for (std::uint32_t start = 0; start < n; ++start) {
    for (std::uint32_t c = 0; c + 1 < n; ++c) {
      for (std::uint32_t d = 0; d + 1 < n; ++d) {
        if (c == d) {
          continue;
        }
        const auto target = b.tour(start, c, d);
        std::vector<std::uint32_t> map(n);
        for (std::uint32_t i = 0; i < n; ++i) {
          map[source[i]] = target[i];
        }
        constexpr std::uint32_t unknown = 0xffffffff;
        std::vector<std::uint32_t> image(n - 1, unknown);
        bool agrees = true;
        for (std::uint32_t u = 0; u < n && agrees; ++u) {
          for (std::uint32_t v = u + 1; v < n && agrees; ++v) {
            std::uint32_t& goes_to = image[a.colour(u, v)];
            const std::uint32_t colour = b.colour(map[u], map[v]);
            agrees = goes_to == unknown || goes_to == colour;
            goes_to = colour;
          }
        }
        if (agrees) {
          found.push_back(map);
        }
      }
    }
  }
  return found;
}

TEST(OneFactorization, the_example_in_the_header_holds) {
  OneFactorization k8 = one_factorization(8);
  OneFactor again = circle_factor(8, 3);
  EXPECT_EQ(again, k8.factors[3]);
  EXPECT_FALSE(factorization_defect(k8));
  EXPECT_TRUE(is_perfect(k8));
  auto other = cycle_types(one_factorization(8, FactorizationKind::doubled));
  EXPECT_TRUE(other.contains({4, 4}));
}

TEST(OneFactorization, both_kinds_are_valid_for_every_even_order) {
  for (std::uint32_t order = 2; order <= 130; order += 2) {
    for (const FactorizationKind kind : both_kinds) {
      const OneFactorization f = one_factorization(order, kind);
      EXPECT_EQ(f.order, order);
      EXPECT_EQ(factorization_defect(f), std::nullopt) << order << ' ' << to_string(kind);
    }
  }
}

TEST(OneFactorization, a_single_factor_equals_that_of_the_whole_and_is_ascending) {
  for (std::uint32_t order = 2; order <= 40; order += 2) {
    for (const FactorizationKind kind : both_kinds) {
      const OneFactorization f = one_factorization(order, kind);
      for (std::uint32_t i = 0; i + 1 < order; ++i) {
        EXPECT_TRUE(std::is_sorted(f.factors[i].begin(), f.factors[i].end()));
        EXPECT_EQ(f.factors[i], kind == FactorizationKind::circle ? circle_factor(order, i)
                                                                  : doubled_factor(order, i));
      }
    }
  }
}

TEST(OneFactorization, the_circle_is_the_textbook_rotation) {
  const std::uint32_t order = 12;
  for (std::uint32_t i = 0; i < 11; ++i) {
    std::set<Edge> expected{{i, 11}};
    for (std::uint32_t j = 1; j <= 5; ++j) {
      const std::uint32_t u = (i + j) % 11;
      const std::uint32_t v = (i + 11 - j) % 11;
      expected.insert({std::min(u, v), std::max(u, v)});
    }
    const OneFactor factor = circle_factor(order, i);
    EXPECT_EQ(std::set<Edge>(factor.begin(), factor.end()), expected);
  }
}

TEST(OneFactorization, one_factor_of_a_large_order_needs_no_others) {
  const std::uint32_t order = 1'000'000;
  for (const OneFactor& factor : {circle_factor(order, 777'777), doubled_factor(order, 3),
                                  doubled_factor(order - 2, 999'996)}) {
    std::vector<bool> met(factor.size() * 2);
    for (const Edge& edge : factor) {
      ASSERT_LT(edge.a, edge.b);
      ASSERT_FALSE(met.at(edge.a) || met.at(edge.b));
      met[edge.a] = met[edge.b] = true;
    }
    EXPECT_EQ(std::count(met.begin(), met.end(), false), 0);
  }
}

TEST(OneFactorization, odd_and_zero_orders_are_impossible) {
  for (const std::uint32_t order : {0U, 1U, 3U, 7U, 4'294'967'295U}) {
    EXPECT_THROW((void)one_factorization(order), ImpossibleParameters);
    EXPECT_THROW((void)one_factorization(order, FactorizationKind::doubled), ImpossibleParameters);
    EXPECT_THROW((void)circle_factor(order, 0), ImpossibleParameters);
    EXPECT_THROW((void)doubled_factor(order, 0), ImpossibleParameters);
  }
  EXPECT_THROW((void)near_one_factorization(0), ImpossibleParameters);
  EXPECT_THROW((void)near_one_factorization(6), ImpossibleParameters);
}

TEST(OneFactorization, a_factor_beyond_the_last_is_bad_input) {
  EXPECT_EQ(circle_factor(8, 6).size(), 4U);
  EXPECT_REFUSAL((void)circle_factor(8, 7), BadInput,
                 "factor 7 of K_8: factors are numbered from 0 to 6");
  EXPECT_REFUSAL((void)doubled_factor(8, 7), BadInput,
                 "factor 7 of K_8: factors are numbered from 0 to 6");
}

TEST(OneFactorization, near_factors_miss_one_vertex_each_and_cover_every_edge_once) {
  for (std::uint32_t order = 1; order <= 41; order += 2) {
    const auto factors = near_one_factorization(order);
    ASSERT_EQ(factors.size(), order);
    std::set<Edge> edges;
    std::set<std::uint32_t> isolated;
    for (const NearOneFactor& factor : factors) {
      std::set<std::uint32_t> met{factor.isolated};
      isolated.insert(factor.isolated);
      for (const Edge& edge : factor.edges) {
        EXPECT_LT(edge.a, edge.b);
        EXPECT_TRUE(met.insert(edge.a).second && met.insert(edge.b).second);
        EXPECT_TRUE(edges.insert(edge).second);
      }
      EXPECT_EQ(met.size(), order);
      EXPECT_LT(*met.rbegin(), order);
    }
    EXPECT_EQ(isolated.size(), order);
    EXPECT_EQ(edges.size(), std::size_t{order} * (order - 1) / 2);
  }
}

TEST(OneFactorization, names_are_read_back) {
  for (const FactorizationKind kind : both_kinds) {
    EXPECT_EQ(factorization_kind_from_string(to_string(kind)), kind);
  }
  EXPECT_EQ(factorization_kind_from_string("square"), std::nullopt);
}

TEST(OneFactorization, the_figure_of_K6_is_isomorphic_to_the_circle) {
  const OneFactorization figure = paper_k6();
  EXPECT_EQ(factorization_defect(figure), std::nullopt);
  EXPECT_EQ(cycle_types(figure), cycle_types(one_factorization(6)));
  EXPECT_EQ(isomorphisms(figure, one_factorization(6)).size(), 120U);  // one class of 720/120 = 6
}

TEST(OneFactorization, the_figure_of_K8_is_the_circle_raised_by_8) {
  const OneFactorization figure = lowered(paper_k8(), 8);
  EXPECT_EQ(factorization_defect(figure), std::nullopt);
  EXPECT_EQ(cycle_types(figure), (CycleTypes{{{8}, 21}}));
  EXPECT_EQ(as_sets(figure), as_sets(one_factorization(8)));
}

TEST(OneFactorization, the_kinds_agree_up_to_K6) {
  for (const std::uint32_t order : {2U, 4U, 6U}) {
    const OneFactorization circle = one_factorization(order);
    const OneFactorization doubled = one_factorization(order, FactorizationKind::doubled);
    EXPECT_EQ(cycle_types(circle), cycle_types(doubled));
    EXPECT_TRUE(order == 2 ? circle == doubled : !isomorphisms(circle, doubled).empty());
  }
}

TEST(OneFactorization, the_circle_is_perfect_exactly_when_order_less_one_is_prime) {
  for (std::uint32_t order = 4; order <= 62; order += 2) {
    const OneFactorization f = one_factorization(order);
    EXPECT_EQ(is_perfect(f), is_prime(order - 1)) << order;
    const bool hamiltonian_only =
        cycle_types(f) == CycleTypes{{{order}, (order - 1) * (order - 2) / 2}};
    EXPECT_EQ(is_perfect(f), hamiltonian_only) << order;
  }
}

TEST(OneFactorization, the_doubled_kind_is_perfect_exactly_when_half_the_order_is_prime) {
  for (std::uint32_t order = 4; order <= 62; order += 2) {
    EXPECT_EQ(is_perfect(one_factorization(order, FactorizationKind::doubled)), is_prime(order / 2))
        << order;
  }
  for (const FactorizationKind kind : both_kinds) {
    EXPECT_TRUE(is_perfect(one_factorization(2, kind)));
    EXPECT_TRUE(cycle_types(one_factorization(2, kind)).empty());
  }
}

TEST(OneFactorization, cycle_types_of_the_circle_are_as_documented) {
  for (std::uint32_t order = 4; order <= 40; order += 2) {
    const std::uint32_t m = order - 1;
    CycleTypes expected;
    for (std::uint32_t difference = 1; difference <= (m - 1) / 2; ++difference) {
      const std::uint32_t g = std::gcd(difference, m);
      std::vector<std::uint32_t> type((g - 1) / 2, 2 * m / g);
      type.insert(type.begin(), m / g + 1);
      expected[type] += m;
    }
    EXPECT_EQ(cycle_types(one_factorization(order)), expected) << order;
  }
}

TEST(OneFactorization, cycle_types_separate_the_kinds_except_where_both_are_perfect) {
  for (std::uint32_t order = 8; order <= 62; order += 2) {
    const CycleTypes circle = cycle_types(one_factorization(order));
    const CycleTypes doubled = cycle_types(one_factorization(order, FactorizationKind::doubled));
    EXPECT_EQ(circle == doubled, order == 14 || order == 38 || order == 62) << order;

    const auto has_equal_shorter_cycles = [order](const CycleTypes& types, std::uint32_t length) {
      return types.contains(std::vector<std::uint32_t>(order / length, length));
    };
    for (std::uint32_t length = 4; length < order; length += 2) {
      EXPECT_FALSE(order % length == 0 && has_equal_shorter_cycles(circle, length)) << order;
      if (order % length == 0 && (order % 4 == 0 ? length == 4 : length > 2)) {
        EXPECT_TRUE(has_equal_shorter_cycles(doubled, length)) << order;
      }
    }
  }
}

// Where both are perfect nothing is left to chance: all maps that could be isomorphisms are tried.
TEST(OneFactorization, the_perfect_ones_of_K14_and_K38_are_not_isomorphic) {
  for (const std::uint32_t order : {14U, 38U}) {
    const OneFactorization circle = one_factorization(order);
    const OneFactorization doubled = one_factorization(order, FactorizationKind::doubled);
    ASSERT_TRUE(is_perfect(circle) && is_perfect(doubled));
    EXPECT_TRUE(isomorphisms(circle, doubled).empty());

    const auto of_circle = isomorphisms(circle, circle);
    EXPECT_EQ(of_circle.size(), std::size_t{order - 1} * (order - 2));
    for (const auto& map : of_circle) {
      EXPECT_EQ(map[order - 1], order - 1) << "the vertex in the middle is fixed";
    }
    const auto of_doubled = isomorphisms(doubled, doubled);
    EXPECT_EQ(of_doubled.size(), std::size_t{order} * (order / 2 - 1));
    std::set<std::uint32_t> orbit;
    for (const auto& map : of_doubled) {
      orbit.insert(map[0]);
    }
    EXPECT_EQ(orbit.size(), order) << "vertex-transitive";
  }
}

TEST(OneFactorization, a_relabelled_copy_is_found_isomorphic) {
  OneFactorization f = one_factorization(14);
  for (OneFactor& factor : f.factors) {
    for (Edge& edge : factor) {
      const std::uint32_t a = (edge.a * 5 + 2) % 14;
      const std::uint32_t b = (edge.b * 5 + 2) % 14;
      edge = {std::min(a, b), std::max(a, b)};
    }
  }
  EXPECT_EQ(factorization_defect(f), std::nullopt);
  EXPECT_EQ(isomorphisms(one_factorization(14), f).size(), 156U);
}

TEST(FactorizationDefect, names_the_defect_in_one_line) {
  const OneFactorization good = one_factorization(6);
  const auto defect_after = [&good](auto change) {
    OneFactorization bad = good;
    change(bad);
    return factorization_defect(bad).value_or("none");
  };
  using F = OneFactorization;
  EXPECT_EQ(defect_after([](F&) {}), "none");
  EXPECT_EQ(defect_after([](F& f) { f.order = 5; }),
            "the order is 5; it must be even and at least 2");
  EXPECT_EQ(defect_after([](F& f) { f.order = 0; }),
            "the order is 0; it must be even and at least 2");
  EXPECT_EQ(defect_after([](F& f) { f.order = 4'000'000'000U; }),
            "5 factors where K_4000000000 needs 3999999999");
  EXPECT_EQ(defect_after([](F& f) { f.factors.pop_back(); }), "4 factors where K_6 needs 5");
  EXPECT_EQ(defect_after([](F& f) { f.factors[2].pop_back(); }), "factor 2 misses vertex 2");
  EXPECT_EQ(defect_after([](F& f) { f.factors[4].clear(); }), "factor 4 misses vertex 0");
  EXPECT_EQ(defect_after([](F& f) {
              f.factors[1].push_back({0, 5});
            }),
            "factor 1 meets vertex 0 twice");
  EXPECT_EQ(defect_after([](F& f) { f.factors[3][1].b = 6; }),
            "edge {2, 6} of factor 3 has a vertex outside 0..5");
  EXPECT_EQ(defect_after([](F& f) { f.factors[3][1].b = 2; }),
            "edge {2, 2} of factor 3 joins a vertex with itself");
  EXPECT_EQ(defect_after([](F& f) {
              f.factors[0][1] = {4, 1};
            }),
            "edge {4, 1} of factor 0 is not written with the smaller vertex first");
  EXPECT_EQ(defect_after([](F& f) { f.factors[4] = f.factors[1]; }),
            "edge {0, 2} is in factors 1 and 4; edge {1, 2} is in none");
  EXPECT_EQ(defect_after([](F& f) { f.factors[1] = f.factors[4]; }),
            "edge {0, 3} is in factors 1 and 4; edge {0, 2} is in none");
}

TEST(FactorizationDefect, rejects_every_change_of_a_single_vertex) {
  for (const FactorizationKind kind : both_kinds) {
    const OneFactorization good = one_factorization(10, kind);
    for (std::size_t f = 0; f < good.factors.size(); ++f) {
      for (std::size_t e = 0; e < good.factors[f].size(); ++e) {
        for (std::uint32_t vertex = 0; vertex < 12; ++vertex) {
          OneFactorization bad = good;
          bad.factors[f][e].a = vertex;
          EXPECT_EQ(factorization_defect(bad).has_value(), bad != good);
          bad = good;
          bad.factors[f][e].b = vertex;
          EXPECT_EQ(factorization_defect(bad).has_value(), bad != good);
        }
      }
    }
  }
}

TEST(FactorizationDefect, rejects_two_edges_exchanged_between_factors) {
  OneFactorization f = one_factorization(8, FactorizationKind::doubled);
  // {0,1},{4,5} of the copies against {0,4},{1,5} of shift 0: every factor stays a 1-factor …
  const auto exchange = [&f](Edge out, Edge in) {
    for (OneFactor& factor : f.factors) {
      std::replace(factor.begin(), factor.end(), out, in);
    }
  };
  const OneFactorization before = f;
  exchange({0, 4}, {0, 1});
  exchange({1, 5}, {4, 5});
  ASSERT_NE(f, before);
  // … but two edges now occur twice.
  const std::string defect = factorization_defect(f).value_or("none");
  EXPECT_NE(defect.find("is in none"), std::string::npos) << defect;
}

TEST(CycleTypes, and_perfection_refuse_what_is_no_factorization) {
  OneFactorization bad = one_factorization(6);
  bad.factors.pop_back();
  EXPECT_THROW((void)cycle_types(bad), BadInput);
  EXPECT_THROW((void)is_perfect(bad), BadInput);
  EXPECT_THROW((void)is_perfect(OneFactorization{}), BadInput);
  bad.order = 4'294'967'294U;
  EXPECT_THROW((void)is_perfect(bad), BadInput);
}

}  // namespace
}  // namespace changeover::one_factorization_test
