// The same by another path.
#include <carom/rotation/hamilton_product.cpp>
