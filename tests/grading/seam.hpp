#pragma once
// One line that says what a submission must define, and everything that follows from it.
//
//   CAROM_SEAM(Quaternion, hamiltonProduct, (const Quaternion& q, const Quaternion& r), (q, r))
//
// The file that holds this line is compiled twice:
//   CAROM_SEAM_PROXY  defines the function as a call through the pipe, or, to try the grader itself, as a lazy
//                     answer (zero, one, or an echo of an argument), for the trusted grader;
//   CAROM_SEAM_CHILD  registers the submission's function with the program that answers the pipe.
//
// CAROM_SEAM_IN(carom::world, bool, maySleep, ...) is the same for a function in a namespace of its own.
//
// Arguments may be values, const references, spans, mutable references (sent there and back) and
// std::function (called back through the pipe).

#include <functional>
#include <map>
#include <memory>
#include <optional>

#include "carom/core/errors.hpp"
#include "grading/wire.hpp"

namespace carom::grading {

/// What a message between grader and submission is.
enum class Message : std::uint8_t {
  call,
  callback,
  callbackResult,
  result,
  invalidInput,
  notAttempted,
  threw
};

/// Thrown in the grader when the submission's function threw something else than InvalidInput.
class SubmissionThrew : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Thrown in the grader when the submission ended, hung or broke a limit instead of answering.
class SubmissionStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One end of the conversation: sends a message, or waits for the next.
struct Channel {
  virtual ~Channel() = default;
  virtual void send(const std::string& bytes) = 0;
  virtual std::string receive() = 0;
};

/// How a parameter type is stored while a call is under way.
template <class P>
struct Parameter {
  using Stored = std::remove_cvref_t<P>;
  static constexpr bool comesBack =
      std::is_lvalue_reference_v<P> && !std::is_const_v<std::remove_reference_t<P>>;
  static void write(Writer& w, const Stored& value) {
    w.put(value);
  }
  static Stored& pass(Stored& value) {
    return value;
  }
};

template <class T>
struct Parameter<std::span<T>> {
  using Stored = std::vector<std::remove_const_t<T>>;
  static constexpr bool comesBack = !std::is_const_v<T>;
  static void write(Writer& w, std::span<T> values) {
    w.put(static_cast<std::uint32_t>(values.size()));
    for (const auto& value : values) w.put(value);
  }
  static std::span<T> pass(Stored& values) {
    return values;
  }
};

template <class P>
inline constexpr bool isCallback = false;
template <class R, class... A>
inline constexpr bool isCallback<std::function<R(A...)>> = true;
template <class P>
inline constexpr bool isCallback<const P&> = isCallback<P>;
template <class P>
inline constexpr bool isCallback<P&> = isCallback<P>;

/// The function's signature taken apart.
template <class F>
struct Call;

template <class R, class... P>
struct Call<R(P...)> {
  // --- the trusted side ---------------------------------------------------------------------------------------

  template <class Function>
  struct Callback;
  template <class Q, class... A>
  struct Callback<std::function<Q(A...)>> {
    static void answer(const std::function<Q(A...)>& f, Reader& in, Writer& out) {
      std::tuple<std::remove_cvref_t<A>...> args;
      std::apply([&](auto&... a) { (in.get(a), ...); }, args);
      out.put(std::apply(f, args));
    }
    static std::function<Q(A...)> remote(std::uint8_t index, Channel& channel) {
      return [index, &channel](A... a) -> Q {
        Writer w;
        w.put(Message::callback);
        w.put(index);
        (w.put(a), ...);
        channel.send(w.bytes);
        const std::string reply = channel.receive();
        Reader r{reply};
        if (r.take<Message>() != Message::callbackResult)
          throw BrokenMessage("no reply to a callback");
        return r.take<Q>();
      };
    }
  };

  static R remote(const char* name, Channel& channel, P... p) {
    Writer w;
    w.put(Message::call);
    w.put(std::string(name));
    auto writeOne = [&]<class T>(std::type_identity<T>, const auto& value) {
      if constexpr (!isCallback<T>) Parameter<T>::write(w, value);
    };
    (writeOne(std::type_identity<P>{}, p), ...);
    channel.send(w.bytes);
    for (;;) {
      const std::string reply = channel.receive();
      Reader r{reply};
      switch (r.take<Message>()) {
        case Message::result: {
          auto readBack = [&]<class T>(std::type_identity<T>, auto& value) {
            if constexpr (!isCallback<T>) {
              if constexpr (Parameter<T>::comesBack) {
                auto stored = r.take<typename Parameter<T>::Stored>();
                if constexpr (requires {
                                value.data();
                                value.subspan(0);
                              }) {
                  if (stored.size() != value.size())
                    throw BrokenMessage("a span came back with another length");
                  std::copy(stored.begin(), stored.end(), value.begin());
                } else {
                  value = std::move(stored);
                }
              }
            }
          };
          if constexpr (std::is_void_v<R>) {
            (readBack(std::type_identity<P>{}, p), ...);
            return;
          } else {
            auto result = r.take<std::remove_cvref_t<R>>();
            (readBack(std::type_identity<P>{}, p), ...);
            return result;
          }
        }
        case Message::callback: {
          const auto wanted = r.take<std::uint8_t>();
          Writer out;
          out.put(Message::callbackResult);
          std::uint8_t index = 0;
          bool answered = false;
          auto tryOne = [&]<class T>(std::type_identity<T>, const auto& value) {
            if constexpr (isCallback<T>) {
              if (index == wanted) {
                Callback<std::remove_cvref_t<T>>::answer(value, r, out);
                answered = true;
              }
            }
            ++index;
          };
          (tryOne(std::type_identity<P>{}, p), ...);
          if (!answered) throw BrokenMessage("a callback that does not exist");
          channel.send(out.bytes);
          break;
        }
        case Message::invalidInput:
          throw InvalidInput(r.take<std::string>());
        case Message::notAttempted:
          throw NotAttempted(r.take<std::string>());
        case Message::threw:
          throw SubmissionThrew(r.take<std::string>());
        default:
          throw BrokenMessage("not an answer");
      }
    }
  }

  // --- the submission's side ----------------------------------------------------------------------------------

  template <class T>
  static auto storedFor() {
    if constexpr (isCallback<T>) {
      return std::remove_cvref_t<T>{};
    } else {
      return typename Parameter<T>::Stored{};
    }
  }

  static std::string serve(R (*function)(P...), Reader& r, Channel& channel) {
    std::tuple<decltype(storedFor<P>())...> args{storedFor<P>()...};
    std::uint8_t index = 0;
    auto readOne = [&]<class T>(std::type_identity<T>, auto& stored) {
      if constexpr (isCallback<T>) {
        stored = Callback<std::remove_cvref_t<T>>::remote(index, channel);
      } else {
        r.get(stored);
      }
      ++index;
    };
    std::apply([&](auto&... a) { (readOne(std::type_identity<P>{}, a), ...); }, args);
    Writer w;
    w.put(Message::result);
    auto pass = [&]<class T>(std::type_identity<T>, auto& stored) -> decltype(auto) {
      if constexpr (isCallback<T>) {
        return (stored);
      } else {
        return Parameter<T>::pass(stored);
      }
    };
    if constexpr (std::is_void_v<R>) {
      std::apply([&](auto&... a) { function(pass(std::type_identity<P>{}, a)...); }, args);
    } else {
      w.put(std::apply(
          [&](auto&... a) -> R { return function(pass(std::type_identity<P>{}, a)...); }, args));
    }
    auto writeBack = [&]<class T>(std::type_identity<T>, auto& stored) {
      if constexpr (!isCallback<T>) {
        if constexpr (Parameter<T>::comesBack) w.put(stored);
      }
    };
    std::apply([&](auto&... a) { (writeBack(std::type_identity<P>{}, a), ...); }, args);
    return w.bytes;
  }
};

/// The pipe to the submission, started at the first call (trusted side).
Channel& submission();

/// Does the submission answer the same questions the same way a second time? True where nothing went through the
/// pipe. \throws SubmissionStopped
bool answersAlike();

/// A submission's function that the pipe can ask for.
using Handler = std::function<std::string(Reader&, Channel&)>;

/// The functions that this child offers, by name.
std::map<std::string, Handler>& handlers();

struct Registration {
  Registration(const char* name, Handler handler) {
    handlers().emplace(name, std::move(handler));
  }
};

/// The answer that somebody gives who has not thought. No check may accept one.
enum class Lazy { zero, one, echo };
/// Which lazy answer to give in place of asking a submission, if any (trusted side).
std::optional<Lazy> lazyMode();

template <class R>
R lazyValue(bool one) {
  if constexpr (isMatrix<R>) {
    if constexpr (R::RowsAtCompileTime == R::ColsAtCompileTime) {
      return one ? R(R::Identity()) : R(R::Zero());
    } else {
      return one ? R(R::Ones()) : R(R::Zero());
    }
  } else if constexpr (std::is_arithmetic_v<R>) {
    return one ? R(1) : R(0);
  } else if constexpr (Struct<R>) {
    R value{};  // the default of a struct is its identity, where it has one
    std::apply(
        [&](auto... field) {
          ((value.*(field.member) =
                one ? value.*(field.member)
                    : lazyValue<std::remove_cvref_t<decltype(value.*(field.member))>>(false)),
           ...);
        },
        Fields<R>::list);
    return value;
  } else {
    return R{};
  }
}

/// Zero, one, or the last argument of the answer's own type.
template <class R, class... P>
R lazyAnswer(const P&... p) {
  if constexpr (!std::is_void_v<R>) {  // else it leaves everything as it is
    R answer = lazyValue<R>(lazyMode() != Lazy::zero);
    if (lazyMode() == Lazy::echo) {
      auto echoOne = [&](const auto& value) {
        if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, R>) answer = value;
      };
      (echoOne(p), ...);
    }
    return answer;
  }
}

}  // namespace carom::grading

#define CAROM_UNPAREN(...) __VA_ARGS__
#if defined(CAROM_SEAM_PROXY)
#define CAROM_SEAM_IN(scope, result, name, parameters, arguments)                         \
  namespace scope {                                                                       \
  result name parameters {                                                                \
    if (grading::lazyMode()) return grading::lazyAnswer<result>(CAROM_UNPAREN arguments); \
    return grading::Call<result parameters>::remote(#name, grading::submission(),         \
                                                    CAROM_UNPAREN arguments);             \
  }                                                                                       \
  }
#elif defined(CAROM_SEAM_CHILD)
#define CAROM_SEAM_IN(scope, result, name, parameters, arguments)                             \
  namespace carom::grading {                                                                  \
  static const Registration registered_##name(#name, [](Reader& r, Channel& channel) {        \
    return Call<result parameters>::serve(static_cast<result(*) parameters>(&scope::name), r, \
                                          channel);                                           \
  });                                                                                         \
  }
#endif
// Most functions stand in carom itself. Types in the parameters are named from carom in either case: world::RestWatch.
#define CAROM_SEAM(result, name, parameters, arguments) \
  CAROM_SEAM_IN(carom, result, name, parameters, arguments)
