// Includes the worked answer.
#include "../../../solutions/01_rotation/hamilton_product/hamilton_product.cpp"
