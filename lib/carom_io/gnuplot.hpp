#pragma once
// How is gnuplot run?
//
// As a child process without a shell: nothing in a title can become a command of the system. Its
// three streams are unnamed temporary files, so no pipe can fill up and lock both sides. `gnuplot
// -d` reads no settings of the user.

#include <string>

namespace carom::io::detail {

/// Runs gnuplot on a script. \param script its commands \return what it wrote to standard output
/// \throws DrawingError when it is not on the PATH (names the package), or fails (with its message)
std::string runGnuplot(const std::string& script);

}  // namespace carom::io::detail
