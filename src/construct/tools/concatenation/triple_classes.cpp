#include "construct/tools/concatenation/triple_classes.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "construct/tools/concatenation/slopes.hpp"

namespace changeover {
namespace {

// Three groups: for each class the elements of groups 1 and 2 that are with a of group 0, for all
// a in turn.
constexpr std::string_view of_six[] = {
    "253004134251", "542540011332", "021145345023", "413453200215",
    "314312552400", "035221403514", "100533225144",
};

constexpr std::string_view of_ten[] = {
    "00471876299385346152", "86115728703994450263", "95802267387149561304", "59968133074872602415",
    "73699082441758013526", "68740991835527124630", "37087519928466235041", "14253640516203778998",
    "21324354650610889779", "42536405162031997887",
};

std::span<const std::string_view> squares(std::uint64_t g) {
  if (g == 6) {
    return of_six;
  }
  return g == 10 ? std::span<const std::string_view>(of_ten) : std::span<const std::string_view>();
}

/// Classes that a cyclic group of order N turns into all of them: three points at a time are a
/// triple. Points are 0-9, a-z, A-Z: orbits of N points, then one group that is not moved. The
/// other groups reach into `orbits` orbits each, in which they are cosets of a subgroup of order
/// g/orbits.
struct Written {
  std::uint64_t q;
  std::uint64_t g;
  std::uint64_t order;   ///< N, which divides g(q−1)/2
  std::uint64_t orbits;  ///< a divisor of g
  std::string_view points;
};

// Found by annealing.
constexpr Written classes_in_writing[] = {
    {9, 1, 1, 1, "206183745401856723671248503521780643"},
    {15, 1, 7, 1, "2540a98b3d6ec17"},
    {21, 1, 5, 1, "iec8a4g3k6b102hfj5d79ed0ka736j5g9chfb4i281"},
    {27, 1, 13, 1, "afl2ge71cjm6kbqdh9403o5pn8i"},
    {39, 1, 19, 1, "jx7hqbpym4d6iswg0A2aBcnC9uv1o5ztr3l8fek"},
    {51, 1, 25, 1, "J9HvbgneKMaAwpqoNF3rhy641d5EO7cuit2xmf0sIDB8LjCzGlk"},
    {9, 2, 4, 1, "32cf5b704hda8916eg5e917ad6bg823h4cf0"},
    {12, 2, 11, 2, "1e4293cgbdf80hkiamnl6j75"},
    {15, 2, 14, 1, "k5nhiapb8e31gt7frj90dsm6o4cql2"},
    {18, 2, 17, 2, "hfuio8lns1eczbjx43rg9ydkvm0qp527a6wt"},
    {21, 2, 20, 1, "r8kE6Bd1gfzvctebxDCuhqol9y05wFjmnA7psi2a34"},
    {24, 2, 23, 2, "46D0HgrwlBJC8h5s3vuEIjykbtFLqdxezaAGp91o72icmKnf"},
    {27, 2, 26, 1, "KQnwM8JLCHEfkhg1uAaipB0lcoe7qPF3xRjrDdm5bIzv4s6Gy2N9Ot"},
    {30, 2, 29, 2, "q6dc2wxf137v0oJiRBrNgjVKaPLQzSTObu5s4EW8pMAmDlnkUXeFGy9hHICt"},
    {5, 3, 1, 3,
     "5c70e69d41a32b82d58934a0b6c7e11854eb96203ca7d7094c81bde326a5ae85b0472c19d63461e95b73a2cd08"},
    {7, 3, 3, 1, "ag842kb3f15e9jc06i7dh14bi9e2afj5638d7kghc03gi0e716akd9h2jfc458b"},
    {11, 3, 15, 1, "tu0egr1o2s8cfm4hq79i6knlb35jdwpva"},
    {13, 3, 9, 1, "73vCteBc1bouxdkr2j49gz8lmqhnA5s6wipy0fa4nhtcsp5qxz38m6Co021abyA7reuj9Bkwvldfig"},
    {19, 3, 27, 1, "s67NuHob0Egae9qRdQP1Ax5vlpOIFMriChzj8TGtK2wBmfSLc4Jyn3kUD"},
    {6, 4, 10, 2, "n8j104k7g2iafeb6ld35h9mc"},
    {9, 4, 16, 2, "pbm29cvuqs6l7jwk3x105fyorh4nzd8ategi"},
    {12, 4, 22, 2, "3cxDruF4KEzAohiaLB2y0JjGfs95vdClIHtn1q6k8me7bgpw"},
    {4, 6, 3, 2, "2mgjeb07c1ia9h56fld3n8k4l4c0fj9n28m3dbkih6ga5e17g394dic61bl0amekf2hn785j"},
    {5, 6, 6, 1, "81dlt5qe64s9k0franc2bh3iomgp7j1qkhsjd7m5gplb38o4r2feia60ntc9"},
    {6, 6, 15, 2, "wqc6ytzr5vl2mxbuk39da7nj8e14phsgf0oi"},
    {7, 6, 18, 1, "fjlzpoDy4vre0EnAi7ug3btB192cakxs85CqFm6whd"},
    {8, 6, 21, 2, "b0duiGL6CEh2vBco8qxpAD9KtF5rnmHskwaJyIe7j3z14glf"},
    {10, 6, 27, 2, "kxTdACE23taVnIWRLeljq5imJUb7f4Bw8pFXs06yNhoO9DzQKurGHcM1SgvP"},
    {6, 8, 20, 2, "Fvh1eCHx6Iwj2LkAE4ydcuBs593fJlbKDzrgqmpnt07aioG8"},
    {6, 10, 25, 2, "XDifecP2x8pFQvhTnyog5t07KEszr1Sq3HjV6CRJGIMBaAkwWubmd9UlN4OL"},
    {4, 12, 6, 2,
     "zHgwIlsm3uad9qBrf0GkpJy1obE5DcteFhC6jv7x4A8iL2nKpbK5luz3L7tfvG6H0n2dExDagq4cI8okAwCi9FmBey"
     "Jhsrj1Fw4hoLxfKd7AJn6lB1eu0Eiy3Ir8mz5sCqDjtbkgv9Hpac2G"},
};

const Written* written_for(std::uint64_t q, std::uint64_t g) {
  const auto* found = std::ranges::find_if(
      classes_in_writing, [&](const Written& each) { return each.q == q && each.g == g; });
  return found == std::end(classes_in_writing) ? nullptr : found;
}

std::uint64_t point_of(char c) {
  return static_cast<std::uint64_t>(c <= '9' ? c - '0' : c <= 'Z' ? c - 'A' + 36 : c - 'a' + 10);
}

Element element_of(const Written& from, std::uint64_t point) {
  const auto [q, g, order, orbits, points] = from;
  if (point >= (q - 1) * g) {
    return static_cast<Element>(point);
  }
  const std::uint64_t orbit = point / order;
  const std::uint64_t residue = point % order;
  const std::uint64_t cosets = order / (g / orbits);
  const std::uint64_t group = orbit / orbits * cosets + residue % cosets;
  const std::uint64_t place = orbit % orbits * (g / orbits) + residue / cosets;
  return static_cast<Element>(group * g + place);
}

std::vector<Block> written_class(const Written& from, std::uint64_t index) {
  const std::uint64_t elements = from.q * from.g;
  const std::uint64_t moved = elements - from.g;
  std::vector<Block> triples;
  const auto begin = static_cast<std::size_t>(index / from.order * elements);
  for (std::size_t i = 0; i < elements; ++i) {
    std::uint64_t point = point_of(from.points[begin + i]);
    if (point < moved) {
      const std::uint64_t residue = point % from.order;
      point = point - residue + (residue + index) % from.order;
    }
    if (i % 3 == 0) {
      triples.emplace_back();
    }
    triples.back().push_back(element_of(from, point));
  }
  return triples;
}

/// How many elements each of a smaller design becomes, so that lines make the classes for groups of
/// g: 1 if they are written, 0 if none are known.
std::uint64_t inflation(std::uint64_t q, std::uint64_t g) {
  if (q < 3 || g == 0 || q > UINT64_MAX / g) {
    return 0;
  }
  if (written_for(q, g) != nullptr) {
    return 1;
  }
  for (const Written& each : classes_in_writing) {
    if (each.q == q && g % each.g == 0 && Slopes::known(g / each.g, 3)) {
      return g / each.g;
    }
  }
  return 0;
}

}  // namespace

std::uint64_t triple_class_count(std::uint64_t q, std::uint64_t g) {
  if (q == 3 && Slopes::known(g, 3)) {
    return g;
  }
  if (q == 3 && !squares(g).empty()) {
    return squares(g).size();
  }
  return inflation(q, g) == 0 ? 0 : g * (q - 1) / 2;
}

std::vector<Block> triple_class(std::uint64_t q, std::uint64_t g, std::uint64_t index) {
  const bool square = q == 3 && !squares(g).empty();
  const bool lines = q == 3 && !square && Slopes::known(g, 3);
  const std::uint64_t times = square || lines ? g : inflation(q, g);
  if (times == 0) {
    return {};
  }
  // Triples of groups, or of the smaller design, each of whose elements becomes `times`.
  const std::vector<Block> triples = square || lines
                                         ? std::vector<Block>{{0, 1, 2}}
                                         : written_class(*written_for(q, g / times), index / times);
  const auto slopes = square ? std::nullopt : std::optional<Slopes>({times, 3});
  std::vector<Block> blocks;
  for (const Block& triple : triples) {
    for (std::uint64_t a = 0; a < times; ++a) {
      Block block;
      for (std::uint64_t i = 0; i < 3; ++i) {
        std::uint64_t place = a;
        if (square && i > 0) {
          const std::string_view digits = squares(g)[static_cast<std::size_t>(index)];
          place = static_cast<std::uint64_t>(digits[static_cast<std::size_t>(2 * a + i - 1)] - '0');
        } else if (!square) {
          place = slopes->at(i, index % times, a);
        }
        block.push_back(static_cast<Element>(triple[static_cast<std::size_t>(i)] * times + place));
      }
      blocks.push_back(std::move(block));
    }
  }
  return blocks;
}

}  // namespace changeover
