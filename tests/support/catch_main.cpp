// The main program of every Catch2 executable here, compiled once.
#if CAROM_CATCH_MAJOR >= 3
#include <catch2/catch_session.hpp>
#else
#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>
#endif

#include "support/catch_main.hpp"

namespace carom_test {
void (*afterTests)(int exitCode) = nullptr;
}

int main(int argc, char** argv) {
  const int exitCode = Catch::Session().run(argc, argv);
  if (carom_test::afterTests) carom_test::afterTests(exitCode);
  return exitCode;
}
