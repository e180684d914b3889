#pragma once
#include "carom/core/random.hpp"
