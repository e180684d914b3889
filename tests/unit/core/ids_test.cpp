#include "carom/core/ids.hpp"

#include <algorithm>
#include <type_traits>
#include <vector>

#include "support/catch.hpp"

using namespace carom;

namespace {
using BodyId = Id<struct BodyTag>;
using ShapeId = Id<struct ShapeTag>;
}  // namespace

TEST_CASE("an id of one kind is not an id of another") {
  CHECK_FALSE(std::is_convertible_v<BodyId, ShapeId>);
  CHECK_FALSE(std::is_same_v<BodyId, ShapeId>);
}

TEST_CASE("a default id names nothing") {
  CHECK(BodyId{}.isNull());
  CHECK_FALSE(BodyId{0, 1}.isNull());
}

TEST_CASE("a place that is used again has another id") {
  CHECK(BodyId{4, 1} == BodyId{4, 1});
  CHECK(BodyId{4, 1} != BodyId{4, 2});
}

TEST_CASE("ids sort by place, then by generation") {
  std::vector<BodyId> ids{{2, 1}, {0, 3}, {2, 0}, {0, 1}};
  std::sort(ids.begin(), ids.end());
  CHECK(ids == std::vector<BodyId>{{0, 1}, {0, 3}, {2, 0}, {2, 1}});
}
