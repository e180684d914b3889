#pragma once
// Which widths of lanes were compiled, and which of them can this machine run?

#include "carom/solver/soft_rows.hpp"

namespace carom::detail {

/// Four floats at once. \return kernel \ingroup solver
const SoftKernel<float>& narrowFloats();
/// Four doubles in registers of two. \return kernel \ingroup solver
const SoftKernel<double>& narrowDoubles();
/// Eight floats at once, where the machine knows AVX2. \return kernel \ingroup solver
const SoftKernel<float>& wideFloats();
/// Four doubles at once, where the machine knows AVX2. \return kernel \ingroup solver
const SoftKernel<double>& wideDoubles();

/// Whether this machine can run the wide ones. \return true with AVX2 \ingroup solver
bool runsWide();

}  // namespace carom::detail
