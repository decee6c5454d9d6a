/// @file
/// Tests that repeat for many types but are compiled once. They have the names of TYPED_TESTs, of
/// which the compiler makes several classes for each type.
#pragma once

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <typeinfo>
#include <vector>

#include "tests/support/test.hpp"

namespace each_type {

/// What a test knows of a type at run time: its `Traits`, made by `Traits::of<T>()`.
template <class Traits>
struct Type {
  const std::type_info* type;
  Traits traits;
};

/// The traits of each of these types.
template <class Traits, class... T>
std::vector<Type<Traits>> all(testing::Types<T...> /*types*/) {
  return {{&typeid(T), Traits::template of<T>()}...};
}

inline std::string name_of(const std::type_info& type) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(type.name(), nullptr, nullptr, &status), &std::free);
  return status == 0 ? name.get() : type.name();
}

class Test : public testing::Test {
 public:
  explicit Test(std::function<void()> body) : body_(std::move(body)) {}

 private:
  void TestBody() override { body_(); }

  std::function<void()> body_;
};

/// Adds the test suite/index.name.
inline void add(const char* suite, std::size_t index, const char* name, const std::type_info& type,
                const char* file, int line, const std::function<void()>& body) {
  testing::RegisterTest((suite + ('/' + std::to_string(index))).c_str(), name,
                        name_of(type).c_str(), nullptr, file, line,
                        [body]() -> Test* { return new Test(body); });
}

template <class Traits>
bool add_all(const char* suite, const char* name, const std::vector<Type<Traits>>& types,
             const char* file, int line, void (*body)(const Traits&)) {
  for (std::size_t i = 0; i < types.size(); ++i) {
    add(suite, i, name, *types[i].type, file, line,
        [body, traits = types[i].traits] { body(traits); });
  }
  return true;
}

/// Adds the test suite/i.name for the i-th of `Types`, for bodies that have a name of their own.
template <class Types, class Traits>
bool add_each(const char* suite, const char* name, void (*body)(const Traits&),
              const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  return add_all(suite, name, all<Traits>(Types()), file, line, body);
}

}  // namespace each_type

/// The test `suite`/i.`name` for the i-th of `types`; its body sees the Traits as `type`.
#define TEST_OF_EACH(suite, name, Traits, types)                                              \
  void suite##_##name(const Traits& type);                                                    \
  [[maybe_unused]] const bool suite##_##name##_added =                                        \
      each_type::add_all<Traits>(#suite, #name, (types), __FILE__, __LINE__, suite##_##name); \
  void suite##_##name(const Traits& type)
