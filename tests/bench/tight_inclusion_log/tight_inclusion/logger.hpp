#pragma once
// Stands in for Tight-Inclusion's logger, which would need spdlog: it says nothing.

namespace ticcd {

struct SilentLogger {
  template <class... Arguments>
  void error(const Arguments&...) {}
  template <class... Arguments>
  void trace(const Arguments&...) {}
};

inline SilentLogger& logger() {
  static SilentLogger silent;
  return silent;
}

}  // namespace ticcd
