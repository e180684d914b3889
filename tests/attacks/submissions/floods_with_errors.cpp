// Makes so many and so long error messages that whoever keeps them runs out of memory.
#include "carom/rotation/hamilton_product.hpp"

#define E1(x) int x##a = none_of_this_is_known_anywhere_in_this_program; int x##b = none_of_this_is_known_either;
#define E2(x) E1(x##c) E1(x##d) E1(x##e) E1(x##f)
#define E3(x) E2(x##c) E2(x##d) E2(x##e) E2(x##f)
#define E4(x) E3(x##c) E3(x##d) E3(x##e) E3(x##f)
#define E5(x) E4(x##c) E4(x##d) E4(x##e) E4(x##f)
#define E6(x) E5(x##c) E5(x##d) E5(x##e) E5(x##f)
E6(v)

namespace carom {

Quaternion hamiltonProduct(const Quaternion&, const Quaternion&) {
  return {0, 0, 0, 0};
}

}  // namespace carom
