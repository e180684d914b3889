// One number at a time: the plain twin, and what the wide ones are compared with.

#include "carom/solver/soft_rows_kernel.hpp"

namespace carom {

template <class T>
const SoftKernel<T>& plainKernel() {
  static const SoftKernel<T> kernel = kernelOf<T>();
  return kernel;
}

template const SoftKernel<float>& plainKernel<float>();
template const SoftKernel<double>& plainKernel<double>();

}  // namespace carom
