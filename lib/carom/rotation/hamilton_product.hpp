#pragma once
// How are two rotations put together?
//
// By the Hamilton product: multiply out (a + bi + cj + dk)(a' + b'i + c'j + d'k) with
// i^2 = j^2 = k^2 = ijk = -1, from which ij = k, jk = i, ki = j, and ji = -k, kj = -i, ik = -j.
// Rotations do not commute, so neither does the product; a rotation is not a vector that could be
// added. Nothing is normalised here: products of unit quaternions drift by about half an ulp each.

#include "carom/rotation/quaternion.hpp"

namespace carom {

/// The product q r: as rotations, r first and then q, like matrices. (The source does not say
/// which.)
/// \param q left factor, applied last
/// \param r right factor, applied first
/// \return q r; its norm is |q| |r|. Not-a-number goes in and comes out
/// \source{5,6,8}
/// \erratum{2.3,3.12}
/// \ingroup rotation
Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r);

}  // namespace carom
