#pragma once
// What happens when the input is wrong?
//
// A public function that is given something it cannot work with (a negative mass, a NaN, a broken
// mesh) throws InvalidInput and leaves its arguments as they were. The message names the value and
// the rule. Wrong use inside the library is a bug and ends the program (expect.hpp); an iteration
// that does not converge is neither, and is a status in the result.

#include <stdexcept>
#include <string>

namespace carom {

/// Thrown by public functions for input that they cannot work with; what() names the value and the
/// rule.
/// \ingroup core
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Thrown by a function of an exercise that has not been written yet (see todo()).
/// \ingroup core
class NotAttempted : public std::logic_error {
 public:
  /// Says which function is missing. \param function its name
  explicit NotAttempted(const std::string& function)
      : std::logic_error(function + " is not written yet") {}
};

}  // namespace carom
