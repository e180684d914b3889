#pragma once
// Who is who in a world where things come and go?
//
// Bodies, shapes and contacts live in arrays, and a removed one's place is used again. An id that
// is a bare index would then silently mean somebody else, so it carries the generation of its
// place: the number of times that the place has been handed out. A stale id does not match, and is
// found out. The tag makes the id of a body and the id of a shape different types. (The idea is
// common; see Box3D's handles, Catto 2025.) An id does not know which world it belongs to.

#include <compare>
#include <cstdint>

namespace carom {

/// Names one of the things of a kind, for example `Id<struct BodyTag>`. Ordered by index, then by
/// generation, so that sorting by ids is the same on every machine. Default: null, names nothing.
/// \tparam Tag any type, also an incomplete one; different tags make different id types
/// \ingroup core
template <class Tag>
struct Id {
  std::uint32_t index = 0;       ///< place in the array
  std::uint32_t generation = 0;  ///< how often the place has been handed out; 0 means null

  /// Compares index, then generation.
  /// \param self one id
  /// \param other another id of the same kind
  /// \return their order
  friend constexpr auto operator<=>(const Id& self, const Id& other) = default;

  /// Does this id name nothing? \return true for a default-constructed id
  constexpr bool isNull() const {
    return generation == 0;
  }
};

}  // namespace carom
