#pragma once
// Graders draw their questions from the library's own generator.

#include "carom/core/random.hpp"

namespace carom::grading {

using carom::Random;

}  // namespace carom::grading
