#include "carom/world/find_islands.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM_IN(carom::world, void, findIslands,
              (std::span<const IndexPair> contacts, std::span<const std::uint8_t> movable,
               std::span<std::int32_t> island),
              (contacts, movable, island))
