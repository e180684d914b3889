// Registers of 32 bytes: eight floats at once, or four doubles. Compiled with the flags of AVX2.

#include "carom/solver/soft_rows_kernel.hpp"
#include "carom/solver/soft_rows_widths.hpp"

namespace carom::detail {

const SoftKernel<float>& wideFloats() {
  static const SoftKernel<float> kernel = kernelOf<Lanes<float, 8>>();
  return kernel;
}

const SoftKernel<double>& wideDoubles() {
  static const SoftKernel<double> kernel = kernelOf<Lanes<double, 4>>();
  return kernel;
}

}  // namespace carom::detail
