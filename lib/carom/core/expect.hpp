#pragma once
// Contracts inside the library.
//
// CAROM_EXPECT guards what only a bug in the library can break, and ends the program with the place
// and the reason. What a user can get wrong is checked with exceptions instead (errors.hpp).

namespace carom::detail {
[[noreturn]] void expectationFailed(const char* condition, const char* rule, const char* file,
                                    int line);
}

/// Ends the program when `condition` is false. `rule` says what the caller must do. Compiled out
/// with NDEBUG.
#ifdef NDEBUG
#define CAROM_EXPECT(condition, rule) static_cast<void>(0)
#else
#define CAROM_EXPECT(condition, rule) \
  ((condition) ? static_cast<void>(0) \
               : ::carom::detail::expectationFailed(#condition, rule, __FILE__, __LINE__))
#endif
