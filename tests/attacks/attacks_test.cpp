// What does a submission gain that does not answer the question?
//
// Each file in submissions/ is handed in for 01.hamilton_product three times: as a student's self-check, through the
// pipe as when graded, and through the pipe without the screen, because the pipe alone must be enough. None earns more
// than the skeleton does, each ends within its limits, and the self-check says of each what it is.

#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "runner/check.hpp"
#include "runner/skeleton.hpp"
#include "support/catch.hpp"

using namespace carom::runner;

namespace {

// What the pipe does not judge: an answer that is right because somebody else's code computes it. There the screen is
// the defence, and without it the points are earned.
enum Alone { gainsNothing, isRight };

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
};

const std::vector<Attack> kCompiling = {
    {"incbin_of_tests", "refused", "assembly code"},
    {"includes_tests", "refused", "outside the course"},
    {"includes_host_name", "refused", "outside the course"},
    {"includes_host_name_by_macro", "refused", "whose name it computes"},
    {"includes_host_name_spliced", "refused", "outside the course"},
    {"includes_host_name_digraph", "refused", "outside the course"},
    {"includes_grader", "refused", "the grader's own files"},
    {"includes_library_source", "refused", "that is the answer itself", isRight},
    {"includes_library_source_by_path", "refused", "that is the answer itself", isRight},
    {"includes_solution", "refused", "outside the course", isRight},
    {"includes_solution_by_macro", "refused", "whose name it computes", isRight},
    {"includes_endless_file", "refused", "outside the course"},
    {"deep_templates", "does not compile", "template"},
    {"wide_templates", "does not compile", "asks too much"},
    {"constant_loop", "does not compile", "constant"},
    {"macro_bomb", "does not compile", "asks too much"},
    {"large_object", "does not compile", "error"},
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
};

const fs::path kSource = CAROM_SOURCE_DIR;
const fs::path kSubmissions = kSource / "tests/attacks/submissions";

const Project& project() {
  static const Project open = openProject(kSource, CAROM_BUILD_DIR);
  return open;
}

enum class Way { selfCheck, pipe, pipeWithoutScreen, open };

ExerciseResult handIn(const fs::path& file, Way way, Workbench* bench = nullptr) {
  const Exercise& exercise = project().find("01.hamilton_product");
  return checkExercise(project(), exercise,
                       {.source = file,
                        .throughPipe = way == Way::pipe || way == Way::pipeWithoutScreen,
                        .lazy = {},
                        .fingerprint = false,
                        .screen = way == Way::selfCheck || way == Way::pipe,
                        .seed = 20240229,
                        .answerSeconds = 1,
                        .compileSeconds = 5,
                        .bench = bench});
}

double pointsOfSkeleton(Way way) {
  const Exercise& exercise = project().find("01.hamilton_product");
  const WorkFolder folder(project());
  const fs::path file = folder.path() / exercise.fileName();
  writeFile(file,
            cutSkeleton(readFile(exercise.folder / exercise.fileName()), exercise.fileName()));
  return handIn(file, way).points();
}

void handInAll(const std::vector<Attack>& attacks) {
  const double nothing = pointsOfSkeleton(Way::pipeWithoutScreen);
  REQUIRE(nothing == 0);
  for (const auto& attack : attacks) {
    const fs::path file = kSubmissions / (std::string(attack.file) + ".cpp");
    INFO(attack.file);

    // The compiler has its five seconds once, not once for each way.
    Workbench bench(project());
    const auto self = handIn(file, Way::selfCheck, &bench);
    const std::string text = toJson(self).dump(1);
    {
      INFO(text);
      CHECK(std::string(nameOf(self.status)) == attack.status);
      CHECK_THAT(text, carom_test::ContainsSubstring(attack.says));
      CHECK(self.status != Status::passed);
      CHECK(self.status != Status::ourFault);
    }
    for (const Way way : {Way::pipe, Way::pipeWithoutScreen}) {
      // What the screen has refused it refuses again before the pipe matters.
      if (way == Way::pipe && self.status == Status::refused) continue;
      const auto begin = std::chrono::steady_clock::now();
      const auto graded = handIn(file, way, &bench);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      INFO((way == Way::pipe ? "through the pipe" : "through the pipe, without the screen"));
      INFO(toJson(graded).dump(1));
      CHECK(graded.status != Status::ourFault);
      CHECK(took.count() < 60);
      if (way == Way::pipeWithoutScreen && attack.alone == isRight) {
        // Otherwise the file would be no attack, and the screen's word about it worth nothing.
        CHECK(graded.status == Status::passed);
      } else {
        CHECK(graded.points() <= nothing);
        CHECK(graded.status != Status::passed);
      }
    }
  }
}

}  // namespace

TEST_CASE("who ends the program early gains nothing") {
  handInAll(kEnding);
}

TEST_CASE("who reaches for the report or the grader gains nothing") {
  handInAll(kReaching);
}

TEST_CASE("the process behind the pipe can do nothing but answer") {
  handInAll(kAbilities);
}

TEST_CASE("where nothing fences them in, the same submissions can do it") {
  // Without this the test before would be satisfied by attacks that never work.
  for (const auto& attack : kAbilities) {
    if (!attack.answersWhereItCan) continue;
    INFO(attack.file);
    const auto result = handIn(kSubmissions / (std::string(attack.file) + ".cpp"), Way::open);
    INFO(toJson(result).dump(1));
    CHECK(result.status == Status::passed);
  }
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

TEST_CASE("a file of a megabyte, or with a zero byte, is not even compiled") {
  const WorkFolder folder(project());
  const std::string right =
      readFile(project().root / "solutions/01_rotation/hamilton_product/right/01_vector_form.cpp");
  const fs::path file = folder.path() / "hamilton_product.cpp";
  writeFile(file, right + "//" + std::string(1 << 20, '-') + "\n");
  const auto large = handIn(file, Way::pipe);
  CHECK(large.status == Status::refused);
  CHECK_THAT(large.reason, carom_test::ContainsSubstring("larger than 256 kB"));
  writeFile(file, right + std::string(1, '\0'));
  const auto zero = handIn(file, Way::pipe);
  CHECK(zero.status == Status::refused);
  CHECK_THAT(zero.reason, carom_test::ContainsSubstring("zero byte"));
  writeFile(file, right);
  CHECK(handIn(file, Way::pipe).status == Status::passed);
}

TEST_CASE("every file in submissions is in one of the tables") {
  std::set<std::string> listed;
  for (const auto* table :
       {&kEnding, &kReaching, &kAbilities, &kLimits, &kCompiling, &kAnswering}) {
    for (const auto& attack : *table) CHECK(listed.insert(attack.file).second);
  }
  std::set<std::string> there;
  for (const auto& file : fs::directory_iterator(kSubmissions)) {
    if (file.path().extension() == ".cpp") there.insert(file.path().stem().string());
  }
  CHECK(there == listed);
}
