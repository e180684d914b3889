#pragma once
// Ways to weigh a mesh that a program might take, beside the library's: written as plainly as they
// are usually written. Each integrates over the tetrahedra between one point and the triangles;
// they differ in that point, in the number they compute with, and in how they add.

#include "carom/mass/mass_properties.hpp"

namespace carom::bench {

/// One loop that reads the three corners of every triangle and adds them: the least that any method
/// must do, and the measure of all others. \return the sum of all corners
Vector3 gatherCorners(const TriangleMesh& mesh);

/// One pass about the world's origin, in double.
MassProperties onePass(const TriangleMesh& mesh);

/// The same in float: the corners are rounded to float first.
MassProperties onePassFloat(const TriangleMesh& mesh);

/// One pass about the first vertex, in double.
MassProperties shiftedPass(const TriangleMesh& mesh);

/// As shiftedPass(), every sum with Kahan's compensation.
MassProperties shiftedKahan(const TriangleMesh& mesh);

/// As shiftedPass(), the sums of halves added, and of their halves, down to 64 triangles.
MassProperties shiftedPairwise(const TriangleMesh& mesh);

}  // namespace carom::bench
