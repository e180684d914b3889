// Includes the file in which the library keeps the answer.
#include "hamilton_product.cpp"
