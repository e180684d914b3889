#pragma once
// How many numbers does one instruction of the row solver work on?
//
// As many as the machine can, but for tests and for those who want to see that it makes no
// difference to the result.

namespace carom {

/// How many numbers are worked on at once. \ingroup solver
enum class RowWidth {
  widest,  ///< as many as the machine can
  narrow,  ///< registers of 16 bytes, which every machine has
  plain    ///< one: the plain twin
};

}  // namespace carom
