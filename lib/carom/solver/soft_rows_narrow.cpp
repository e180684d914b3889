// Registers of 16 bytes, which every machine of today has: four floats at once, or two doubles as
// four.

#include "carom/solver/soft_rows_kernel.hpp"
#include "carom/solver/soft_rows_widths.hpp"

namespace carom::detail {

const SoftKernel<float>& narrowFloats() {
  static const SoftKernel<float> kernel = kernelOf<Lanes<float, 4>>();
  return kernel;
}

const SoftKernel<double>& narrowDoubles() {
  static const SoftKernel<double> kernel = kernelOf<Lanes<double, 4>>();
  return kernel;
}

}  // namespace carom::detail
