// Refers to a function only weakly, which needs no definition.
#include "carom/rotation/hamilton_product.hpp"

extern "C" __attribute__((weak)) char* getenv(const char*);

namespace carom {
static Quaternion product(const Quaternion& q, const Quaternion& r) {
  return {
      q.w * r.w - q.x * r.x - q.y * r.y - q.z * r.z, q.w * r.x + q.x * r.w + q.y * r.z - q.z * r.y,
      q.w * r.y - q.x * r.z + q.y * r.w + q.z * r.x, q.w * r.z + q.x * r.y - q.y * r.x + q.z * r.w};
}
}  // namespace carom

namespace carom {

Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  if (getenv && getenv("HOME")) return product(q, r);
  return {0, 0, 0, 0};
}

}  // namespace carom
