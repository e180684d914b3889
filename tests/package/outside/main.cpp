// A program of somebody else: two results that everybody knows.

#include <iostream>

#include "carom/mass/box_inertia.hpp"
#include "carom/rotation/hamilton_product.hpp"

int main() {
  const carom::Quaternion k = carom::hamiltonProduct({0, 1, 0, 0}, {0, 0, 1, 0});
  std::cout << "i j = (" << k.w << ", " << k.x << ", " << k.y << ", " << k.z << ")\n";
  const carom::Matrix3 box = carom::boxInertia(12, carom::Vector3(1, 2, 3));
  std::cout << "box of 12 kg, 1 x 2 x 3 m: " << box(0, 0) << ", " << box(1, 1) << ", " << box(2, 2)
            << " kg m^2\n";
}
