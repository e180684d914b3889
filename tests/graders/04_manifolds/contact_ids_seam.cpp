#include "carom/manifold/contact_ids.hpp"

#include "grading/fields_manifold.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<std::uint32_t>, contactIds, (std::span<const FeaturePair> pairs), (pairs))
