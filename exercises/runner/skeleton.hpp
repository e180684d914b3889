#pragma once
// Cuts the skeleton out of the worked answer, so that the two can never drift apart.
//
// In solutions/ the answer stands between marker lines, and what the student starts from stands beside it in
// comments, so that the file compiles as it is:
//
//     //# solution
//     return a * b;
//     //# stub
//     // What is the product of ... ?
//     //#| return todo<Real>("product");
//     //# end
//
// Answer files of predictions use `##` instead of `//#`.

#include <string>
#include <string_view>

namespace carom::runner {

/// What the student gets: stubs instead of answers, no markers. \throws Failure naming the line for markers that
/// are unknown, nested, unbalanced or left over, and for an empty stub
std::string cutSkeleton(std::string_view source, std::string_view fileName);

/// What is shown after a pass: the answer without stubs and markers.
std::string cutAnswer(std::string_view source, std::string_view fileName);

/// Number of lines that a student has to write.
int answerLines(std::string_view source, std::string_view fileName);

/// The lines of the answer alone, trimmed.
std::string answerOnly(std::string_view source, std::string_view fileName);

}  // namespace carom::runner
