#include "carom/solver/soft_rows_widths.hpp"

namespace carom {

template <>
const SoftKernel<float>& narrowKernel<float>() {
  return detail::narrowFloats();
}

template <>
const SoftKernel<double>& narrowKernel<double>() {
  return detail::narrowDoubles();
}

#ifdef CAROM_WIDE_LANES

bool detail::runsWide() {
  static const bool wide = __builtin_cpu_supports("avx2") != 0;
  return wide;
}

template <>
const SoftKernel<float>& widestKernel<float>() {
  return detail::runsWide() ? detail::wideFloats() : detail::narrowFloats();
}

template <>
const SoftKernel<double>& widestKernel<double>() {
  return detail::runsWide() ? detail::wideDoubles() : detail::narrowDoubles();
}

#else

bool detail::runsWide() {
  return false;
}

template <>
const SoftKernel<float>& widestKernel<float>() {
  return detail::narrowFloats();
}

template <>
const SoftKernel<double>& widestKernel<double>() {
  return detail::narrowDoubles();
}

#endif

}  // namespace carom
