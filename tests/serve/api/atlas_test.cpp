// The atlas says what the table says, and groups are those of the designs.

#include "serve/api/atlas.hpp"
#include "changeover/io/input.hpp"
#include "changeover/isomorphism/isomorphism.hpp"
#include "changeover/verify/verdict.hpp"
#include "serve/api/about.hpp"
#include "serve/http/message.hpp"
#include "served.hpp"

namespace changeover::test::atlas_test {
namespace {

class Atlas : public Served {};

TEST_F(Atlas, IsTheTableInColumns) {
  for (const char* const kind : {"circular", "linear"}) {
    for (const int change : {1, 2, 3}) {
      const std::string query =
          "?k=3..7&v=3..30&change=" + std::to_string(change) + "&kind=" + kind;
      const auto table = json("/api/table" + query);
      const auto atlas = json("/api/atlas" + query);
      EXPECT_EQ(atlas["k_to"], 7);
      EXPECT_EQ(atlas["v_from"], 3);
      ASSERT_EQ(atlas["b"].size(), table.size());
      for (std::size_t i = 0; i < table.size(); ++i) {
        const auto& cell = table[i];
        EXPECT_EQ(atlas["b"][i], cell["b"]) << cell;
        EXPECT_EQ(atlas["lower_bound"][i], cell["lower_bound"]) << cell;
        const auto& by = atlas["construction"][i];
        EXPECT_EQ(by.is_null() ? by : atlas["constructions"][by.get<std::size_t>()],
                  cell["construction"])
            << cell;
        const auto& digits = atlas["label"][i];
        EXPECT_EQ(digits.is_null(), cell["label"].is_null()) << cell;
        if (!digits.is_null()) {
          EXPECT_TRUE(cell["label"].get<std::string>().ends_with("." + digits.get<std::string>()));
        }
      }
    }
  }
}

TEST_F(Atlas, HasAllStoredCellsUnlessARangeIsAsked) {
  const auto range = serve::atlas_range(2, 2);
  EXPECT_EQ(range.k.from, 3U);
  EXPECT_EQ(range.k.to, 40U);
  EXPECT_EQ(range.v.to, 160U);
  EXPECT_EQ(get("/api/atlas").status, 400);  // of which kind?
  EXPECT_EQ(get("/api/atlas?kind=linear&strength=9").status, 400);
  EXPECT_EQ(get("/api/atlas?kind=linear&k=3..200&v=3..900").status, 413);
}

// An extra parameter has it computed: that is what was stored when the program was built.
TEST_F(Atlas, WhatIsStoredIsWhatIsComputed) {
  if (serve::stored_atlases().empty()) {
    GTEST_SKIP() << "this build stores none";
  }
  for (const char* const query : {"?change=1&kind=circular", "?change=3&kind=linear"}) {
    const auto stored = json(std::string("/api/atlas") + query);
    const auto part = json(std::string("/api/atlas") + query + "&k=3..40&v=4..159");
    const std::size_t width = 157;
    ASSERT_EQ(stored["b"].size(), 38 * width);
    for (const char* const column : {"b", "lower_bound", "label", "construction"}) {
      const auto value = [&](const nlohmann::json& of, std::size_t i) -> nlohmann::json {
        const auto& held = of[column][i];
        return std::string_view(column) == "construction" && !held.is_null()
                   ? of["constructions"][held.get<std::size_t>()]
                   : held;
      };
      for (std::size_t i = 0; i < part["b"].size(); ++i) {
        const std::size_t k = i / (width - 1);
        ASSERT_EQ(value(stored, k * width + i % (width - 1)), value(part, i)) << column << i;
      }
    }
  }
}

TEST_F(Atlas, OfLargerStrengthsSaysWhatCellsSay) {
  const auto atlas = json("/api/atlas?kind=linear&change=1&strength=3&k=4..5&v=4..9");
  std::size_t known = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto cell =
        get("/api/cell?kind=linear&change=1&strength=3&k=" + std::to_string(4 + i / 6) +
            "&v=" + std::to_string(4 + i % 6));
    if (cell.status != 200) {
      EXPECT_TRUE(atlas["b"][i].is_null());
      continue;
    }
    const auto said = nlohmann::json::parse(cell.body);
    EXPECT_EQ(atlas["lower_bound"][i], said["lower_bound"]) << said;
    EXPECT_EQ(atlas["b"][i], said["best"].is_null() ? said["best"] : said["best"]["b"]) << said;
    known += atlas["b"][i].is_null() ? 0U : 1U;
  }
  EXPECT_GT(known, 4U);
}

// The page tells from the numbers alone which designs are tight, as the glossary says.
TEST_F(Atlas, TightnessIsInTheNumbersAndGroupsAreThoseOfTheDesigns) {
  for (const char* const kind : {"circular", "linear"}) {
    for (const int change : {1, 2, 3}) {
      const std::string query = std::string("kind=") + kind + "&change=" + std::to_string(change);
      const auto atlas = json("/api/atlas?k=3..6&v=5..20&" + query);
      const auto groups = json("/api/groups?k=3..6&v=5..20&" + query);
      std::size_t i = 0;
      for (std::uint64_t k = 3; k <= 6; ++k) {
        for (std::uint64_t v = 5; v <= 20; ++v, ++i) {
          if (atlas["b"][i].is_null()) {
            EXPECT_TRUE(groups["order"][i].is_null());
            continue;
          }
          const Design design = read_design(input_from_text(
              get("/api/design?" + query + "&v=" + std::to_string(v) + "&k=" + std::to_string(k))
                  .body));
          EXPECT_EQ(groups["order"][i], automorphisms(design).order);
          const std::uint64_t b = atlas["b"][i];
          const auto m = static_cast<std::uint64_t>(change);
          const std::uint64_t each = m * (k - m) + m * (m - 1) / 2;
          const std::uint64_t counted =
              std::string_view(kind) == "linear" ? k * (k - 1) / 2 + (b - 1) * each : b * each;
          if (v > k && b > 1) {
            EXPECT_EQ(counted == v * (v - 1) / 2, verify(design).tight()) << query << v << k;
          }
        }
      }
    }
  }
}

TEST_F(Atlas, ACellSaysHowManyDesignsThereAre) {
  const auto two = json("/api/cell?v=9&k=4&change=1&kind=circular")["classified"];
  EXPECT_EQ(two["b"], 12);
  EXPECT_EQ(two["classes"], 2);  // McSorley1999
  EXPECT_EQ(two["standard_forms"], 16);
  EXPECT_EQ(two["groups"],
            nlohmann::json::parse(R"([{"order":1,"classes":1},{"order":3,"classes":1}])"));
  EXPECT_TRUE(json("/api/cell?v=40&k=6&change=2&kind=circular")["classified"].is_null());
}

TEST_F(Atlas, RepairsAListThatIsNearlyADesign) {
  const std::string list =
      "1 3 7 8\n2 5 7 8\n0 2 3 8\n2 3 4 5\n1 2 3 6\n0 1 4 7\n0 1 5 6\n4 6 7 8\n";
  const auto repaired = json_of(post("/api/repair?change=2&kind=linear", list));
  EXPECT_EQ(repaired["given"], 8);
  EXPECT_EQ(repaired["bad_steps"], 2);
  EXPECT_GE(repaired["kept"], 5);
  EXPECT_TRUE(verify(read_design(input_from_text(repaired["design"].dump()))).valid());
  EXPECT_EQ(post("/api/repair", "1 2 2\n").status, 422);
}

TEST_F(Atlas, ThePageMayHaveItsOwnStyleAndNoOther) {
  const Reply page = get("/");
  EXPECT_EQ(page.header("content-security-policy"),
            serve::content_policy(page.body) + "; frame-ancestors 'none'");
  // printf 'a{}' | openssl dgst -sha256 -binary | base64
  EXPECT_NE(serve::content_policy("<style>a{}</style><p>")
                .find("; style-src 'self' 'sha256-X1RutGBrXCt9KkSaXMK7tHftWiRscFHOhxsS8tv8hBk='; "),
            std::string::npos);
  EXPECT_EQ(serve::content_policy("<p>").find("sha256"), std::string::npos);
}

TEST_F(Atlas, TheStartPageTakesPermanentAddresses) {
  EXPECT_EQ(get("/?cell=20.5.2.circular").status, 200);
  EXPECT_EQ(get("/?design=20.5.2.circular.29.17482f88").status, 200);
  EXPECT_EQ(get("/?other=1").status, 400);
}

}  // namespace
}  // namespace changeover::test::atlas_test
