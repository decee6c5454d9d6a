#include "verify/parties/library.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/dll/shared_library.hpp>
#include <boost/noncopyable.hpp>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "support/error_text.hpp"
#include "support/plain_text.hpp"
#include "support/sha256.hpp"
#include "verify/machine_code/guarded_call.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;

constexpr std::string_view array_suffix = "[]";

/// While one exists, exit() is a failure: a function must not end the verification with status 0.
class Calling : private boost::noncopyable {
 public:
  Calling() {
    static const int registered = std::atexit([] {
      if (running == 0) return;
      support::write_error("fixproof: a function of a library called exit()\n");
      std::_Exit(2);
    });
    if (registered != 0) throw std::runtime_error("no room for another function at exit");
    ++running;
  }
  ~Calling() { --running; }

 private:
  // NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): all that exit() can reach
  static inline std::atomic<int> running = 0;
};

/// Calls `one(i)` for every case from `first` on. A case that ends in a fault gets its ending, and
/// the rest goes on.
void guard_each(const Cases& asked, const std::function<void(std::size_t)>& one) {
  // Volatile, because it must survive a fault.
  volatile std::size_t next = 0;
  while (next < asked.endings.size()) {
    const int signal = machine_code::signal_of([&] {
      while (next < asked.endings.size()) {
        one(next);
        asked.endings[next] = Ending::value;
        next = next + 1;
      }
    });
    if (signal == 0) return;
    asked.endings[next] = signal == SIGFPE ? Ending::divide_error : Ending::broken;
    next = next + 1;
  }
}

/// The operands of the cases as one array of W each, and room for results of type R, which is
/// unsigned: integers of one width are returned alike.
template <class W, class R>
class Columns {
 public:
  Columns(const cases::Variant& v, const Cases& asked)
      : asked_(asked), count_(asked.endings.size()), results_(count_) {
    const std::size_t each = cases::words_per_number(cases::operand_format(v));
    const std::size_t operands = cases::words_in(v.operation);
    for (std::size_t k = 0; k < operands; ++k) {
      auto& column = columns_.at(k);
      column.resize(count_);
      for (std::size_t i = 0; i < count_; ++i) {
        const std::size_t at = (i * operands + k) * each;
        std::uint64_t word = asked.in[at];
        if (each == 2) word |= std::uint64_t{asked.in[at + 1]} << 32U;
        column[i] = static_cast<W>(word);
      }
    }
  }

  /// Null where the operation has fewer operands.
  [[nodiscard]] std::array<const W*, 3> operands() const {
    return {columns_[0].data(), columns_[1].data(), columns_[2].data()};
  }
  [[nodiscard]] R* results() { return results_.data(); }

  void store_results() const {
    for (std::size_t i = 0; i < count_; ++i) {
      const std::uint64_t word{results_[i]};
      if constexpr (sizeof(R) == 8) {
        asked_.out[2 * i] = static_cast<std::uint32_t>(word);
        asked_.out[2 * i + 1] = static_cast<std::uint32_t>(word >> 32U);
      } else {
        asked_.out[i] = static_cast<std::uint32_t>(word);
      }
    }
  }

 private:
  const Cases& asked_;
  std::size_t count_;
  std::array<std::vector<W>, 3> columns_;
  std::vector<R> results_;
};

template <class Type>
Type* as(void (*function)()) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the name of the party says so
  return reinterpret_cast<Type*>(function);
}

template <class W, class R>
void call_for_each(void (*function)(), const cases::Variant& v, const Cases& asked) {
  Columns<W, R> columns(v, asked);
  const std::array<const W*, 3> in = columns.operands();
  R* results = columns.results();
  switch (cases::words_in(v.operation)) {
    case 1:
      guard_each(asked, [=, f = as<R(W)>(function)](std::size_t i) { results[i] = f(in[0][i]); });
      break;
    case 2:
      guard_each(asked, [=, f = as<R(W, W)>(function)](std::size_t i) {
        results[i] = f(in[0][i], in[1][i]);
      });
      break;
    default:
      guard_each(asked, [=, f = as<R(W, W, W)>(function)](std::size_t i) {
        results[i] = f(in[0][i], in[1][i], in[2][i]);
      });
      break;
  }
  columns.store_results();
}

template <class W, class R>
void call_for_all(void (*function)(), const cases::Variant& v, const Cases& asked) {
  Columns<W, R> columns(v, asked);
  const std::array<const W*, 3> in = columns.operands();
  const auto call = [&](std::size_t first, std::size_t count) {
    R* results = columns.results() + first;
    switch (cases::words_in(v.operation)) {
      case 1:
        return as<void(const W*, R*, std::size_t)>(function)(in[0] + first, results, count);
      case 2:
        return as<void(const W*, const W*, R*, std::size_t)>(function)(in[0] + first, in[1] + first,
                                                                       results, count);
      default:
        return as<void(const W*, const W*, const W*, R*, std::size_t)>(function)(
            in[0] + first, in[1] + first, in[2] + first, results, count);
    }
  };
  const std::size_t count = asked.endings.size();
  if (machine_code::signal_of([&] { call(0, count); }) == 0) {
    std::fill(asked.endings.begin(), asked.endings.end(), Ending::value);
  } else {
    // Finds out which cases fault.
    guard_each(asked, [&](std::size_t i) { call(i, 1); });
  }
  columns.store_results();
}

/// CosSin and the matrices, which exist in 16.16 alone.
void call_routine(void (*function)(), const cases::Variant& v, const Cases& asked) {
  using Word = std::int32_t;
  const std::size_t in = cases::words_in(v.operation);
  const std::size_t out = cases::words_out(v.operation);
  guard_each(asked, [&](std::size_t i) {
    const std::uint32_t* from = asked.in.data() + i * in;
    std::array<Word, cases::max_words_in> operands{};
    std::transform(from, from + in, operands.begin(), [](auto w) { return static_cast<Word>(w); });
    std::array<Word, cases::max_words_out> results{};
    if (v.operation == Operation::cossin) {
      const auto angle = static_cast<std::int16_t>(operands[0]);
      as<void(std::int16_t, Word*, Word*)>(function)(angle, results.data(), results.data() + 1);
    } else {
      constexpr std::size_t matrix = 12;
      as<void(const Word*, const Word*, Word*)>(function)(operands.data(), operands.data() + matrix,
                                                          results.data());
    }
    std::transform(results.begin(), results.begin() + static_cast<std::ptrdiff_t>(out),
                   asked.out.data() + i * out,
                   [](Word w) { return static_cast<std::uint32_t>(w); });
  });
}

/// Calls call.operator()<W>() for the integer of the format's words.
template <class Call>
void with_word(const cases::Format& format, const Call& call) {
  switch (format.word_bits) {
    case 8:
      return format.is_signed ? call.template operator()<std::int8_t>()
                              : call.template operator()<std::uint8_t>();
    case 16:
      return format.is_signed ? call.template operator()<std::int16_t>()
                              : call.template operator()<std::uint16_t>();
    case 64:
      return format.is_signed ? call.template operator()<std::int64_t>()
                              : call.template operator()<std::uint64_t>();
    default:
      return format.is_signed ? call.template operator()<std::int32_t>()
                              : call.template operator()<std::uint32_t>();
  }
}

class LibraryFunction final : public Party {
 public:
  /// @throws std::invalid_argument naming what is missing
  explicit LibraryFunction(std::string_view name) : name_(name) {
    const std::size_t colon = name.rfind(':');
    const std::string file(name.substr(0, colon));
    std::string function(name.substr(colon + 1));
    if (function.ends_with(array_suffix)) {
      takes_arrays_ = true;
      function.resize(function.size() - array_suffix.size());
    }
    // A name without a folder is a file of this folder, else one of the system's libraries.
    const bool is_here = std::filesystem::exists(file);
    using boost::dll::load_mode::type;
    const type mode = boost::dll::load_mode::rtld_now |
                      (is_here ? type{} : boost::dll::load_mode::search_system_folders);
    const auto refused = [&file](std::string_view reason) {
      return std::invalid_argument(fmt::format("cannot load the library {}: {}",
                                               support::quoted(file), support::printable(reason)));
    };
    if (!is_here && file.find('/') != std::string::npos) throw refused("there is no such file");
    try {
      library_.load(is_here ? std::filesystem::absolute(file).string() : file, mode);
    } catch (const std::exception& error) {
      throw refused(error.what());
    }
    if (!library_.has(function)) {
      throw std::invalid_argument(
          fmt::format("the library {} exports no function {}; C++ functions need extern \"C\"",
                      support::quoted(file), support::quoted(function)));
    }
    address_ = &library_.get<void()>(function);
  }

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string identity() const override {
    return "SHA-256 " + support::sha256_hex_of_file(library_.location().string());
  }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    if (cases::is_conversion(v.operation)) return false;
    return is_of_numbers(v.operation) || (!takes_arrays_ && v.format == cases::q16_16);
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    const Calling calling;
    if (!is_of_numbers(v.operation)) return call_routine(address_, v, asked);
    cases::Format results = v.format;
    results.is_signed = false;
    with_word(cases::operand_format(v), [&]<class W>() {
      with_word(results, [&]<class R>() {
        if constexpr (std::is_unsigned_v<R>) {
          takes_arrays_ ? call_for_all<W, R>(address_, v, asked)
                        : call_for_each<W, R>(address_, v, asked);
        }
      });
    });
  }

 private:
  /// Whether operands and result are single words.
  static bool is_of_numbers(Operation operation) {
    return operation == Operation::mul || operation == Operation::div ||
           !cases::is_routine(operation);
  }

  std::string name_;
  boost::dll::shared_library library_;
  bool takes_arrays_ = false;
  void (*address_)() = nullptr;
};

}  // namespace

bool names_function(std::string_view name) { return name.find(':') != std::string_view::npos; }

const Party& party_of_function(std::string_view name) {
  // Loaded once, because a library may not be unloaded while its code can run.
  static std::mutex loading;
  static std::map<std::string, std::unique_ptr<LibraryFunction>, std::less<>> loaded;
  const std::lock_guard lock(loading);
  const auto found = loaded.find(name);
  if (found != loaded.end()) return *found->second;
  return *loaded.emplace(name, std::make_unique<LibraryFunction>(name)).first->second;
}

}  // namespace fixproof::parties
