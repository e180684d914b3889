#include "soa_layout.hpp"

#include "grading/seam.hpp"
#include "speed_fields.hpp"

CAROM_SEAM(std::vector<BodyBlock>, soaLayout, (std::span<const WholeBody> bodies), (bodies))
CAROM_SEAM(void, aosLayout, (std::span<const BodyBlock> blocks, std::span<WholeBody> bodies),
           (blocks, bodies))
