#include "carom/world/wake.hpp"

#include "grading/fields_broadphase.hpp"
#include "grading/seam.hpp"

CAROM_SEAM_IN(carom::world, void, wake,
              (std::int32_t first, std::span<const IndexPair> contacts,
               std::span<const std::uint8_t> movable, std::span<std::uint8_t> asleep),
              (first, contacts, movable, asleep))
