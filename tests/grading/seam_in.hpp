#pragma once
// CAROM_SEAM for a function that lives in a namespace of its own inside carom, as those of the
// world do. Types in the parameters are named from carom: world::RestWatch.

#include "grading/seam.hpp"

#if defined(CAROM_SEAM_PROXY)
#define CAROM_SEAM_IN(scope, result, name, parameters, arguments)                         \
  namespace scope {                                                                       \
  result name parameters {                                                                \
    if (grading::lazyMode()) return grading::lazyAnswer<result>(CAROM_UNPAREN arguments); \
    return grading::Call<result parameters>::remote(#name, grading::submission(),         \
                                                    CAROM_UNPAREN arguments);             \
  }                                                                                       \
  }
#elif defined(CAROM_SEAM_CHILD)
#define CAROM_SEAM_IN(scope, result, name, parameters, arguments)                             \
  namespace carom::grading {                                                                  \
  static const Registration registered_##name(#name, [](Reader& r, Channel& channel) {        \
    return Call<result parameters>::serve(static_cast<result(*) parameters>(&scope::name), r, \
                                          channel);                                           \
  });                                                                                         \
  }
#endif
