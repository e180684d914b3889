#pragma once
// One include for Catch2 2.13 (Debian 12) and 3 (newer systems). Test files include only this header.

#if CAROM_CATCH_MAJOR >= 3
#include <catch2/catch_approx.hpp>
#include <catch2/catch_session.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/catch_tostring.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/generators/catch_generators_range.hpp>
#include <catch2/matchers/catch_matchers_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

namespace carom_test {

#if CAROM_CATCH_MAJOR >= 3
template <class T>
using MatcherBase = Catch::Matchers::MatcherBase<T>;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;
#else
template <class T>
using MatcherBase = Catch::MatcherBase<T>;
using Catch::Detail::Approx;
inline auto ContainsSubstring(const std::string& part) {
  return Catch::Matchers::Contains(part);
}
#endif
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using Catch::Matchers::WithinULP;

}  // namespace carom_test
