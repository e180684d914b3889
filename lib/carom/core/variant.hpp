#pragma once
// Is this program built on the library's functions, or on a student's?
//
// A fast path inside the library would quietly bypass a function that an exercise replaces. So
// every fast path asks here first, and a program that is built with a replaced function takes the
// plain way everywhere. The answer is one object file, chosen at link time (variant_library.cpp or
// variant_mine.cpp).

namespace carom {

/// True in a program in which at least one function of the library is replaced by an exercise's.
/// \return whether fast paths must give way to the plain functions that chapters explain
/// \ingroup core
bool takesPlainPath();

}  // namespace carom
