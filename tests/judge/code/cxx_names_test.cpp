// Functions that are named as a source of C++ names them.
#include "judge/code/cxx_names.hpp"

#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace cxx_names_test {

namespace {

using namespace fixproof;
using judged::expect;
using judged::judge;

const std::string quickly = "--as|mul|--cases|1000";

/// An object with these functions, each a product.
std::string object_with(const ScratchFolder& folder, const std::vector<std::string>& names) {
  std::string source = "bits 64\n";
  for (const std::string& name : names) {
    source += "global " + name + "\n" + name +
              ": movsxd rax, edi\nmovsxd rcx, esi\nimul rax, rcx\nsar rax, 16\nret\n";
  }
  std::string object = folder.path("f.o");
  const auto run =
      command::run({"nasm", "-f", "elf64", "-o", object, folder.write("f.asm", source)});
  EXPECT_EQ(run.status, 0) << run.err;
  return object;
}

TEST(CxxNames, AFunctionHasItsNameInTheSource) {
  const ScratchFolder folder;
  const std::string object =
      object_with(folder, {"_ZN1n1fEii", "_ZN1n1gEii", "_Z1hIiET_S0_S0_", "plain"});
  for (const std::string name :
       {":n::f", ":n::f(int, int)", ":n::f(int,int)", ":_ZN1n1fEii", ":h", ":h<int>",
        ":h<int>(int, int)", ":int h<int>(int, int)", ":plain"}) {
    expect(judge(object + name, quickly), 0, {"AGREES on 1,000 cases"});
  }
  expect(judge(object, quickly + "|--symbol|n::g"), 0, {"AGREES on 1,000 cases"});
  command::expect_usage_error(
      judge(object + ":n::h", quickly),
      "--symbol 'n::h': there is no such global function; choose one of n::f(int, int), "
      "n::g(int, int), int h<int>(int, int), plain");
  command::expect_usage_error(judge(object + ":f", quickly), "there is no such global function");
  command::expect_usage_error(judge(object + "x:n::f", quickly), "there is no such file");
}

TEST(CxxNames, OverloadsAreListed) {
  const ScratchFolder folder;
  const std::string object = object_with(folder, {"_ZN1n1fEii", "_ZN1n1fEss"});
  command::expect_usage_error(judge(object + ":n::f", quickly),
                              "--symbol 'n::f': there are 2 functions of that name; choose "
                              "_ZN1n1fEii for n::f(int, int), _ZN1n1fEss for n::f(short, short)");
  expect(judge(object + ":n::f(short, short)", quickly), 0, {"AGREES on 1,000 cases"});
}

TEST(CxxNames, WhatAUserMayWrite) {
  const auto is_meant = [](std::string_view wanted, std::string_view name) {
    return judge::is_meant(wanted, name);
  };
  EXPECT_TRUE(is_meant("f", "(anonymous namespace)::f(int)"));
  EXPECT_TRUE(is_meant("n::f", "n::(anonymous namespace)::f(int)"));
  EXPECT_TRUE(is_meant("fx::mul", "fx::mul(fx) const"));
  EXPECT_TRUE(is_meant("operator*", "operator*(fx, fx)"));
  EXPECT_TRUE(is_meant("f", "std::pair<int, int> f<void (*)(int)>(void (*)(int))"));
  EXPECT_TRUE(is_meant("h<int>", "int h<int>(int)"));
  EXPECT_TRUE(is_meant("fx<4>::mul", "fx<4>::mul(fx<4>, fx<(char)5>)"));
  EXPECT_FALSE(is_meant("f", "n::f(int)"));
  EXPECT_FALSE(is_meant("f", "f2(int)"));
  EXPECT_FALSE(is_meant("f(int)", "f(long)"));
  EXPECT_FALSE(is_meant("", "f(int)"));
  EXPECT_FALSE(is_meant("int", "int f<int>(int)"));
}

TEST(CxxNames, ManyKindsOfNames) {
  const std::vector<std::string> names{"_Z1fv", "f", "_Znonsense", "", "_Z1gi"};
  EXPECT_EQ(judge::as_in_source(names),
            (std::vector<std::string>{"f()", "f", "_Znonsense", "", "g(int)"}));
}

// Each S_ stands for all before it, so the text doubles with every pair.
TEST(CxxNames, ANameThatIsLongWithoutEndStaysAsItIs) {
  std::string name = "_Z1fSt4pairIiiE";
  std::string last = "S_";
  for (const char digit : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ")) {
    name += "St4pairI" + last + last + "E";
    last = std::string("S") + digit + "_";
  }
  ASSERT_LT(name.size(), 1000U);
  EXPECT_EQ(judge::as_in_source({name, "_Z1fv"}).front(), name);
}

}  // namespace

}  // namespace cxx_names_test
