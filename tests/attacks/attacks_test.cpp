// What does a submission gain that does not answer the question?
//
// Each file in submissions/ is handed in for 01.hamilton_product three times: as a student's self-check, as when graded
// (confined, through the pipe), and through the pipe alone, without a sandbox. The graded ones go without the screen,
// because what is behind it must be enough. None earns more than the skeleton does, each ends within its limits, and
// the self-check says of each what it is.

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "runner/check.hpp"
#include "runner/skeleton.hpp"
#include "support/catch.hpp"

using namespace carom::runner;

namespace {

// What the pipe does not judge: an answer that is right because somebody else's code computes it, or because a file
// can be read. There the screen is the defence, and the sandbox where the file is not for submissions.
enum Alone { gainsNothing, rightInTheOpen, isRight };

struct Attack {
  const char* file;
  const char* status;  ///< of the self-check
  const char* says;    ///< part of the self-check's reason, wherever it stands in the JSON
  Alone alone = gainsNothing;
  bool answersWhereItCan = false;
};

const std::vector<Attack> kEnding = {
    {"exit_in_initialiser", "refused", "It calls exit"},
    {"exit_in_constructor_attribute", "refused", "code to run before or after main"},
    {"exit_in_gnu_constructor", "refused", "code to run before or after main"},
    {"success_line_then_exit", "refused", "It calls _exit"},
    {"exit_in_function", "refused", "It calls _exit"},
    {"exit_in_destructor", "refused", "It calls _exit"},
    {"atexit_handler", "refused", "It calls atexit"},
    {"longjmp_out", "refused", "longjmp"},
    {"abort_itself", "stopped", "aborted itself"},
    {"kill_group", "refused", "It calls kill"},
    {"throws_a_number", "wrong", "an exception that is not a std::exception"},
    {"throws_an_odd_exception", "stopped", "crashed"},
    {"throws_invalid_input", "wrong", "an exception: no"},
    {"throws_in_initialiser", "stopped", "aborted itself"},
    {"claims_not_started", "not started", "not started"},
    {"thread_constructor", "stopped", "aborted itself"},
    {"terminate_handler", "stopped", "before the check was over"},
    {"dumps_core", "refused", "It calls setrlimit"},
};

const std::vector<Attack> kReaching = {
    {"overwrite_report_of_command_line", "refused", "It calls fopen"},
    {"forge_report", "refused", "It calls getenv"},
    {"forge_report_of_parent", "refused", "It calls getppid"},
    {"report_by_macro", "refused", "It pastes names together"},
    {"catch_listener", "refused", "the grader's own files"},
    {"own_main", "refused", "It defines main"},
    {"redefined_macros", "wrong", "wrong"},
    {"always_equal", "wrong", "wrong"},
    {"own_agree", "refused", "belongs to the grader"},
    {"own_question_count", "refused", "belongs to the grader"},
    {"own_registration", "refused", "belongs to the grader"},
    {"raw_syscall", "refused", "assembly code"},
    {"raw_syscall_spliced", "refused", "assembly code"},
    {"raw_syscall_pasted", "refused", "It pastes names together"},
    {"raw_syscall_pasted_by_system", "refused", "It pastes names together"},
    {"raw_syscall_behind_raw_text", "refused", "assembly code"},
    {"symbol_by_assembler_name", "refused", "assembly code"},
    {"replaces_new", "refused", "It replaces operator new"},
    {"replaces_write", "refused", "It defines the C symbol 'write'"},
    {"replaces_memory_compare", "refused", "It defines the C symbol 'memcmp'"},
};

// Names and sections that the linker or the loader treats in their own way.
const std::vector<Attack> kSymbols = {
    {"weak_reference", "refused", "'alias', 'weak' and the like"},
    {"alias_of_memcmp", "refused", "'alias', 'weak' and the like"},
    {"indirect_function", "refused", "'alias', 'weak' and the like"},
    {"section_of_starters", "refused", "attributes 'section'"},
    {"section_of_starters_spelled", "refused", "attributes 'section'"},
    {"versioned_symbol", "refused", "assembly code"},
    {"pretends_link_time_code", "refused", "assembly code"},
};

// Submissions that answer rightly, but only where they can do what they must not be able to.
const std::vector<Attack> kAbilities = {
    {"writes_beside_the_grader", "refused", "It calls open", gainsNothing, true},
    {"reads_the_grader", "refused", "It calls ptrace", gainsNothing, true},
    {"starts_processes", "refused", "It calls fork", gainsNothing, true},
    {"signals_the_grader", "refused", "It calls kill", gainsNothing, true},
    {"opens_a_socket", "refused", "It calls socket", gainsNothing, true},
    {"finds_secrets_in_environment", "refused", "It calls getenv", gainsNothing, true},
    {"raises_its_limits", "refused", "It calls setrlimit"},
    {"answer_on_the_pipe", "refused", "It calls write"},
    {"answers_in_advance", "refused", "It calls pause"},
    {"announces_four_gigabytes", "refused", "It calls write"},
    {"noise_on_the_pipe", "refused", "It calls write"},
    {"closes_the_pipe", "refused", "It calls close"},
    {"leaves_a_thread", "refused", "It calls pthread_create", gainsNothing, true},
    {"writes_into_the_grader", "refused", "It calls process_vm_writev", gainsNothing, true},
    {"takes_open_files_of_the_grader", "refused", "It calls syscall", gainsNothing, true},
    {"leaves_shared_memory", "refused", "It calls shmget", gainsNothing, true},
    {"makes_files_in_memory", "refused", "It calls memfd_create", gainsNothing, true},
    {"makes_namespaces", "refused", "It calls unshare"},
    {"plants_a_link", "refused", "It calls symlink", gainsNothing, true},
    {"asks_the_kernel_by_ring", "refused", "It calls syscall"},
    {"loads_a_library", "refused", "It calls execve"},
    {"calls_the_old_gate", "refused", "assembly code"},
};

// Submissions that answer rightly where they see the machine that they run on.
const std::vector<Attack> kReading = {
    {"reads_files_of_the_machine", "refused", "It calls open", rightInTheOpen},
    {"reads_the_solution", "refused", "It calls open", rightInTheOpen},
    {"reads_other_processes", "refused", "It calls open", rightInTheOpen},
    {"knows_the_machine", "refused", "It calls uname", rightInTheOpen},
    {"knows_its_number", "refused", "It calls getpid", rightInTheOpen},
};

const std::vector<Attack> kLimits = {
    {"endless_loop", "stopped", "before the check was over"},
    {"sleeps", "refused", "It calls sleep"},
    {"slow_answers", "refused", "It calls usleep"},
    {"two_gigabytes", "wrong", "std::bad_alloc"},
    {"many_small_pieces", "wrong", "wrong"},
    {"endless_output", "stopped", "printed more than"},
    {"endless_recursion", "stopped", "endless recursion"},
    {"fork_bomb", "refused", "It calls fork"},
    {"fills_the_disk", "refused", "It calls fopen"},
    {"crashes", "stopped", "crashed"},
    {"divides_by_zero", "stopped", "divided by zero"},
    {"ignores_signals", "refused", "It calls signal"},
    {"exhausts_descriptors", "refused", "It calls open"},
    {"large_zeros", "stopped", "before the check was over"},
};

const std::vector<Attack> kCompiling = {
    {"incbin_of_tests", "refused", "assembly code"},
    {"includes_tests", "refused", "outside the course"},
    {"includes_host_name", "refused", "outside the course"},
    {"includes_host_name_by_macro", "refused", "whose name it computes"},
    {"includes_host_name_spliced", "refused", "outside the course"},
    {"includes_host_name_digraph", "refused", "outside the course"},
    {"includes_grader", "refused", "the grader's own files"},
    {"includes_library_source", "refused", "that is the answer itself", rightInTheOpen},
    {"includes_library_source_by_path", "refused", "that is the answer itself", rightInTheOpen},
    {"includes_solution", "refused", "outside the course", rightInTheOpen},
    {"includes_solution_by_macro", "refused", "whose name it computes", rightInTheOpen},
    {"includes_endless_file", "refused", "outside the course"},
    {"deep_templates", "does not compile", "template"},
    {"wide_templates", "does not compile", "asks too much"},
    {"constant_loop", "does not compile", "constant"},
    {"macro_bomb", "does not compile", "asks too much"},
    {"large_object", "does not compile", "error"},
    {"asks_for_the_solution", "refused", "which files there are", rightInTheOpen},
    {"asks_for_files_of_the_system", "refused", "which files there are", rightInTheOpen},
    {"asks_by_pragma", "refused", "It asks for files", rightInTheOpen},
    {"includes_classmate", "refused", "outside the course", rightInTheOpen},
    {"incbin_of_the_machine", "refused", "assembly code", rightInTheOpen},
    {"embeds_a_file", "refused", "outside the course"},
    {"claims_another_file", "refused", "another file or line"},
    {"includes_itself", "does not compile", "asks too much"},
    {"floods_with_errors", "refused", "It pastes names together"},
    {"assembler_repeats", "refused", "assembly code"},
    {"asks_for_compiler_options", "wrong", "wrong"},
};

const std::vector<Attack> kAnswering = {
    {"eigen_geometry", "does not compile", "writes by hand"},
    {"eigen_geometry_by_path", "refused", "writes by hand", isRight},
    {"forwards_through_matrices", "wrong", "wrong"},
    {"forwards_to_later_chapter", "refused", "does not have"},
    {"forwards_to_itself", "stopped", "before the check was over"},
    {"finds_answer_by_name", "refused", "It calls dlsym"},
    {"answers_with_nan", "wrong", "not a number"},
    {"answers_with_infinity", "wrong", "infinity"},
    {"changes_the_question", "stopped", "crashed"},
    {"changes_the_rounding", "refused", "It calls fesetround"},
    {"counts_calls", "wrong", "wrong"},
    // Every scored check asks something that depends on the seed, so a table of the public numbers earns nothing.
    {"knows_public_numbers", "wrong", "wrong"},
    {"depends_on_addresses", "wrong", "wrong"},
    {"depends_on_time", "wrong", "wrong"},
    {"right_the_first_time", "wrong", "wrong"},
};

const fs::path kSource = CAROM_SOURCE_DIR;
const fs::path kSubmissions = kSource / "tests/attacks/submissions";

const Project& project() {
  static const Project open = openProject(kSource, CAROM_BUILD_DIR);
  return open;
}

enum class Way { selfCheck, confined, pipe, open };

// Null where this machine has none that keeps files away; then the tests say so.
const carom::grading::Sandbox* sandbox() {
  static const auto best = carom::grading::bestSandbox();
  return best.tier == carom::grading::Tier::limits ? nullptr : &best;
}

ExerciseResult handIn(const fs::path& file, Way way, bool screen, Workbench* bench = nullptr) {
  const Exercise& exercise = project().find("01.hamilton_product");
  return checkExercise(project(), exercise,
                       {.source = file,
                        .throughPipe = way == Way::pipe || way == Way::confined,
                        .lazy = {},
                        .fingerprint = false,
                        .screen = screen,
                        .seed = 20240229,
                        .answerSeconds = 1,
                        .compileSeconds = 4,
                        .sandbox = way == Way::confined ? sandbox() : nullptr,
                        .bench = bench});
}

double pointsOfSkeleton() {
  const Exercise& exercise = project().find("01.hamilton_product");
  const WorkFolder folder(project());
  const fs::path file = folder.path() / exercise.fileName();
  writeFile(file,
            cutSkeleton(readFile(exercise.folder / exercise.fileName()), exercise.fileName()));
  return handIn(file, Way::pipe, false).points();
}

// Graded: it gains nothing, or is right where that is what is expected.
void grade(const fs::path& file, Way way, bool right, double nothing, Workbench& bench) {
  const auto begin = std::chrono::steady_clock::now();
  const auto graded = handIn(file, way, false, &bench);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  INFO((way == Way::pipe ? "through the pipe" : "confined"));
  INFO(toJson(graded).dump(1));
  CHECK(graded.status != Status::ourFault);
  CHECK(took.count() < 60);
  if (right) {
    // Otherwise the file would be no attack, and the defence against it worth nothing.
    CHECK(graded.status == Status::passed);
  } else {
    CHECK(graded.points() <= nothing);
    CHECK(graded.status != Status::passed);
  }
}

void handInAll(const std::vector<Attack>& attacks) {
  if (!sandbox()) WARN("no sandbox here: " << describe(carom::grading::bestSandbox()));
  const double nothing = pointsOfSkeleton();
  REQUIRE(nothing == 0);
  for (const auto& attack : attacks) {
    const fs::path file = kSubmissions / (std::string(attack.file) + ".cpp");
    INFO(attack.file);

    // Compiled once for all ways, or once inside and once outside where that makes the difference.
    Workbench inside(project());
    Workbench outside(project());
    Workbench& bench = attack.alone == rightInTheOpen ? outside : inside;
    if (sandbox()) grade(file, Way::confined, attack.alone == isRight, nothing, inside);
    grade(file, Way::pipe, attack.alone != gainsNothing, nothing, bench);

    const auto self = handIn(file, Way::selfCheck, true, &bench);
    const std::string text = toJson(self).dump(1);
    INFO(text);
    CHECK(std::string(nameOf(self.status)) == attack.status);
    CHECK_THAT(text, carom_test::ContainsSubstring(attack.says));
    // What the screen lets pass is graded as it was above.
    if (self.status == Status::refused && sandbox())
      CHECK(handIn(file, Way::confined, true, &inside).status != Status::passed);
  }
}

}  // namespace

TEST_CASE("who ends the program early gains nothing") {
  handInAll(kEnding);
}

TEST_CASE("who reaches for the report or the grader gains nothing") {
  handInAll(kReaching);
}

TEST_CASE("who plays with names and sections gains nothing") {
  handInAll(kSymbols);
}

TEST_CASE("the process behind the pipe can do nothing but answer") {
  handInAll(kAbilities);
}

TEST_CASE("where nothing fences them in, the same submissions can do it") {
  // Without this the test before would be satisfied by attacks that never work.
  for (const auto& attack : kAbilities) {
    if (!attack.answersWhereItCan) continue;
    INFO(attack.file);
    const auto result =
        handIn(kSubmissions / (std::string(attack.file) + ".cpp"), Way::open, false);
    INFO(toJson(result).dump(1));
    CHECK(result.status == Status::passed);
  }
}

TEST_CASE("who reads the machine gains nothing where it is not to be seen") {
  handInAll(kReading);
}

TEST_CASE("who computes, prints or allocates without end is stopped") {
  handInAll(kLimits);
}

TEST_CASE("a hostile file stops the compiler and not the machine") {
  handInAll(kCompiling);
}

TEST_CASE("who lets others answer, or answers without looking, gains nothing") {
  handInAll(kAnswering);
}

TEST_CASE("where CI says that there is a sandbox, there is one") {
  WARN("submissions run in: " << describe(carom::grading::bestSandbox()));
  if (std::getenv("CAROM_NEEDS_SANDBOX")) CHECK(sandbox());
}

TEST_CASE("a compiler's message quotes no file that the submission may not see") {
  // A line of a file that only the course has, quoted because the submission says that it is that file.
  const fs::path secret = kSource / "solutions/01_rotation/hamilton_product/exercise.ini";
  const WorkFolder folder(project());
  const fs::path file = folder.path() / "hamilton_product.cpp";
  const std::string first = readFile(secret).substr(0, readFile(secret).find('\n'));
  REQUIRE(first.size() > 5);
  writeFile(file, "#line 1 \"" + secret.string() + "\"\nint taken = whatIsInTheFirstLine;\n");
  const auto open = handIn(file, Way::pipe, false);
  CHECK(open.status == Status::doesNotCompile);
  CHECK_THAT(open.compiled.full, carom_test::ContainsSubstring(first));
  if (!sandbox()) return;
  const auto confined = handIn(file, Way::confined, false);
  CHECK(confined.status == Status::doesNotCompile);
  CHECK(confined.compiled.full.find(first) == std::string::npos);
}

TEST_CASE("what a submission says is text in every report, whatever its bytes are") {
  const WorkFolder folder(project());
  const fs::path file = folder.path() / "hamilton_product.cpp";
  const std::string include = "#include \"carom/rotation/hamilton_product.hpp\"\n";
  // A byte that is no UTF-8, and the characters that clear a terminal.
  const std::string bytes = "\xff\x1b[2J";
  writeFile(file, include + "#error " + bytes + "\n");
  const auto error = handIn(file, Way::pipe, false);
  CHECK(error.status == Status::doesNotCompile);
  CHECK_THAT(toJson(error).dump(), carom_test::ContainsSubstring("??[2J"));
  writeFile(file, include + "#include \"/" + bytes + "\"\n");
  const auto refused = handIn(file, Way::selfCheck, true);
  CHECK(refused.status == Status::refused);
  CHECK_THAT(toJson(refused).dump(), carom_test::ContainsSubstring("??[2J"));
  writeFile(file, include +
                      "#include <stdexcept>\nnamespace carom {\nQuaternion hamiltonProduct(const "
                      "Quaternion&, const Quaternion&) {\n  throw std::runtime_error(\"" +
                      bytes + "\");\n}\n}\n");
  const auto thrown = handIn(file, Way::pipe, false);
  CHECK(thrown.status == Status::wrong);
  const std::string text = toJson(thrown).dump();
  CHECK_THAT(text, carom_test::ContainsSubstring("?[2J"));
  CHECK(text.find("u001b") == std::string::npos);
}

#ifdef __SSE2__
TEST_CASE("each call starts from the same arithmetic") {
  // Right only where flags are down, rounding is to nearest and small numbers are kept; leaves none of it so.
  const WorkFolder folder(project());
  const fs::path file = folder.path() / "hamilton_product.cpp";
  writeFile(file, R"(#include "carom/rotation/hamilton_product.hpp"
#include <immintrin.h>
#include <cfenv>
namespace carom {
Quaternion hamiltonProduct(const Quaternion& q, const Quaternion& r) {
  unsigned short word = 0;
  __asm__ volatile("fnstcw %0" : "=m"(word));
  const bool clean = _mm_getcsr() == 0x1f80 && word == 0x37f && std::fegetround() == FE_TONEAREST;
  const Quaternion right{
      q.w * r.w - q.x * r.x - q.y * r.y - q.z * r.z, q.w * r.x + q.x * r.w + q.y * r.z - q.z * r.y,
      q.w * r.y - q.x * r.z + q.y * r.w + q.z * r.x, q.w * r.z + q.x * r.y - q.y * r.x + q.z * r.w};
  std::feraiseexcept(FE_ALL_EXCEPT);
  word = 0xc7f;  // single precision, towards zero
  __asm__ volatile("fldcw %0" : : "m"(word));
  _mm_setcsr(_mm_getcsr() | 0x8040 | 0x4000);  // flush to zero, denormals are zero, round up
  return clean ? right : Quaternion{0, 0, 0, 0};
}
}  // namespace carom
)");
  CHECK(handIn(file, Way::pipe, false).status == Status::passed);
  // Nobody cleans up in the self-check, so this test could fail.
  CHECK(handIn(file, Way::open, false).status != Status::passed);
}
#endif

TEST_CASE("a file of a megabyte, or with a zero byte, is not even compiled") {
  const WorkFolder folder(project());
  const std::string right =
      readFile(project().root / "solutions/01_rotation/hamilton_product/right/01_vector_form.cpp");
  const fs::path file = folder.path() / "hamilton_product.cpp";
  writeFile(file, right + "//" + std::string(1 << 20, '-') + "\n");
  const auto large = handIn(file, Way::pipe, true);
  CHECK(large.status == Status::refused);
  CHECK_THAT(large.reason, carom_test::ContainsSubstring("larger than 256 kB"));
  writeFile(file, right + std::string(1, '\0'));
  const auto zero = handIn(file, Way::pipe, true);
  CHECK(zero.status == Status::refused);
  CHECK_THAT(zero.reason, carom_test::ContainsSubstring("zero byte"));
  writeFile(file, right);
  CHECK(handIn(file, Way::pipe, true).status == Status::passed);
}

TEST_CASE("every file in submissions is in one of the tables") {
  std::set<std::string> listed;
  for (const auto* table : {&kEnding, &kReaching, &kSymbols, &kAbilities, &kReading, &kLimits,
                            &kCompiling, &kAnswering}) {
    for (const auto& attack : *table) CHECK(listed.insert(attack.file).second);
  }
  std::set<std::string> there;
  for (const auto& file : fs::directory_iterator(kSubmissions)) {
    if (file.path().extension() == ".cpp") there.insert(file.path().stem().string());
  }
  CHECK(there == listed);
}
