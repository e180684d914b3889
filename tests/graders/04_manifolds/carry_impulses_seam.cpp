#include "carry_impulses.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<Real>, carryImpulses,
           (std::span<const std::uint32_t> oldIds, std::span<const Real> oldImpulses,
            std::span<const std::uint32_t> newIds),
           (oldIds, oldImpulses, newIds))
