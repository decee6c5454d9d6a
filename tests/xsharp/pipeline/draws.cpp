#include "tests/xsharp/pipeline/draws.hpp"

#include <rapidcheck.h>

namespace draws {

namespace {

/// A uniform generator that ignores RapidCheck's size, so early cases cover the whole range.
rc::Gen<std::int64_t> among(std::int64_t least, std::int64_t most) {
  return rc::gen::resize(rc::kNominalSize, rc::gen::inRange<std::int64_t>(least, most + 1));
}

bool hold(std::size_t count, const rc::Gen<std::int64_t>& integer, const Check& check) {
  return rc::check([&] { RC_ASSERT(check(*rc::gen::container<Integers>(count, integer))); });
}

}  // namespace

bool hold(std::size_t count, std::int64_t least, std::int64_t most, const Check& check) {
  return hold(count, among(least, most), check);
}

bool hold_for_raws(std::size_t count, const Check& check) {
  const auto whole = rc::gen::map(rc::gen::pair(among(-32767, 32767), among(-2, 2)),
                                  [](const auto& x) { return x.first * 65536 + x.second; });
  return hold(count,
              rc::gen::oneOf(
                  among(INT32_MIN, INT32_MAX), whole, among(-400000, 400000),
                  rc::gen::element<std::int64_t>(INT32_MIN, INT32_MIN + 1, -65537, -65536, -65535,
                                                 -1, 0, 1, 65536, INT32_MAX - 1, INT32_MAX)),
              check);
}

}  // namespace draws
