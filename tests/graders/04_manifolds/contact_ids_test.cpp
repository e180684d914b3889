// Grader of 04.contact_ids: names by hand, names that must stay, and names that must differ.

#include "carom/manifold/contact_ids.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "grading/fields_manifold.hpp"
#include "grading/grade.hpp"

using namespace carom;
using namespace carom::grading;

namespace {

constexpr const char* kWhole = "whole numbers";

using Pairs = std::vector<FeaturePair>;
using Ids = std::vector<std::uint32_t>;

constexpr FeatureKind kSurface = FeatureKind::surface;
constexpr FeatureKind kVertex = FeatureKind::vertex;
constexpr FeatureKind kEdge = FeatureKind::edge;
constexpr FeatureKind kFace = FeatureKind::face;

Feature anyFeature(Random& random, int indices) {
  return {static_cast<FeatureKind>(random.integer(0, 3)),
          static_cast<std::uint32_t>(random.integer(0, indices))};
}

// A name taken apart again, so that a message can be read.
std::string inWords(std::uint32_t id) {
  const auto half = [](std::uint32_t bits) {
    return "kind " + std::to_string(bits >> 14) + ", index " + std::to_string(bits & 16383);
  };
  return "A: " + half(id >> 16) + "; B: " + half(id & 65535);
}

// What a name must say.
std::string inWords(const FeaturePair& pair) {
  const auto half = [](const Feature& f) {
    return "kind " + std::to_string(static_cast<int>(f.kind)) + ", index " +
           std::to_string(f.index);
  };
  return "A: " + half(pair.onA) + "; B: " + half(pair.onB);
}

// All pairs of features with small numbers.
Pairs allPairs() {
  Pairs all;
  for (int n = 0; n < 4 * 4 * 6 * 6; ++n) {
    all.push_back({{static_cast<FeatureKind>(n % 4), static_cast<std::uint32_t>(n / 16 % 6)},
                   {static_cast<FeatureKind>(n / 4 % 4), static_cast<std::uint32_t>(n / 96)}});
  }
  return all;
}

std::size_t different(const Ids& ids) {
  return std::set<std::uint32_t>(ids.begin(), ids.end()).size();
}

}  // namespace

TEST_CASE("layout") {
  struct Case {
    FeaturePair pair;
    std::uint32_t id;
    const char* what;
  };
  const Case cases[] = {{{{kVertex, 3}, {kFace, 5}},
                         ((16384u + 3) << 16) + 3 * 16384 + 5,
                         "corner 3 of A on face 5 of B"},
                        {{{kFace, 5}, {kVertex, 3}},
                         ((3 * 16384u + 5) << 16) + 16384 + 3,
                         "face 5 of A under corner 3 of B"},
                        {{{kEdge, 1}, {kEdge, 16383}},
                         ((2 * 16384u + 1) << 16) + 2 * 16384 + 16383,
                         "edge 1 of A across the last possible edge of B"},
                        {{{kSurface, 0}, {kFace, 2}}, 3 * 16384u + 2, "a ball on face 2"}};
  for (const Case& c : cases) {
    GRADE(inWords(contactIds(Pairs{c.pair}).at(0)), inWords(c.pair),
          within(0, "the bits of the name"), given("features", c.pair), about(c.what));
    GRADE(contactIds(Pairs{c.pair}), Ids{c.id}, within(0, kWhole), given("features", c.pair),
          about(c.what));
  }
}

TEST_CASE("stays") {
  const FeaturePair point = {{kVertex, 7}, {kFace, 2}};
  const FeaturePair others[] = {{{kEdge, 4}, {kEdge, 9}}, {{kVertex, 1}, {kFace, 2}}};
  GRADE(contactIds(Pairs{point}) == Ids{contactIds(Pairs{others[0], others[1], point}).back()},
        true, within(0, "yes or no"), given("features", point),
        about("does the point keep its name when others come before it in the list?"));
  GRADE(contactIds(Pairs{others[1], point, others[0]}).size(), std::size_t{3}, within(0, kWhole),
        about("one name per point, in the same order"));
  GRADE(contactIds(Pairs{others[1], point}).at(0) == contactIds(Pairs{point, others[1]}).at(1),
        true, within(0, "yes or no"), given("features", others[1]),
        about("does a point keep its name when the list is the other way round?"));
}

TEST_CASE("differ") {
  GRADE(different(contactIds(allPairs())), std::size_t{4 * 4 * 6 * 6}, within(0, "a count"),
        about("how many different names 576 different pairs of features have"));
  Random random(seed());
  for (int n = 0; n < 12; ++n) {
    const FeaturePair pair = {anyFeature(random, 16383), anyFeature(random, 16383)};
    const FeaturePair swapped = {pair.onB, pair.onA};
    GRADE(contactIds(Pairs{swapped}), Ids{swappedId(contactIds(Pairs{pair}).at(0))},
          within(0, kWhole), given("features", swapped),
          about("with A and B exchanged the two halves of the name are exchanged"));
    const std::uint32_t upper = contactIds(Pairs{pair}).at(0) >> 16;
    GRADE(contactIds(Pairs{{pair.onA, {kFace, 1}}}).at(0) >> 16, upper, within(0, kWhole),
          given("features", FeaturePair{pair.onA, {kFace, 1}}),
          about("the upper half of the name is A's, whatever it touches"));
  }
}

TEST_CASE("refuses") {
  const FeaturePair tooMany = {{kVertex, 16384}, {kFace, 0}};
  GRADE_REFUSES(contactIds(Pairs{tooMany}), given("features", tooMany));
}

PROBES() {
  Random random(408);
  for (int n = 0; n < 16; ++n) {
    Pairs pairs;
    for (int k = 0; k < 4; ++k) pairs.push_back({anyFeature(random, 300), anyFeature(random, 300)});
    PROBE(contactIds(pairs));
  }
}
