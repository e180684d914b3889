#include "carom/solver/color_graph.hpp"

#include "grading/fields_solver.hpp"
#include "grading/seam.hpp"

CAROM_SEAM(std::vector<std::int32_t>, colorGraph,
           (std::span<const ColorEdge> edges, std::int32_t movable), (edges, movable))
