#include "verify/cases/edges.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "oracle/function.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof::cases {

namespace {

/// An operand in units of the format.
using Value = std::int64_t;

/// The kinds of a result, in the order of their values.
enum class Side : std::uint8_t {
  outside,  ///< the operand is outside the domain
  below,    ///< less than the lowest word, so it saturates
  lowest,
  negative,
  zero,
  positive,
  highest,
  above,  ///< more than the highest word, so it saturates
};

/// Words on each side of an edge.
constexpr Value reach = 2;
/// Multiples of a quarter turn next to zero, and as many at each end of the format.
constexpr Value multiples = 64;

struct Range {
  explicit Range(const Format& format)
      : lowest(format.is_signed ? -format.limit() : 0),
        highest(static_cast<Value>(cases::highest(format))) {}

  [[nodiscard]] bool has(Value value) const { return value >= lowest && value <= highest; }

  Value lowest;
  Value highest;
};

Side side_of(oracle::Function function, Value x, Value y, const Format& format) {
  const auto result =
      oracle::fast::nearest(function, x, y, format.fraction_bits, oracle::Rounding::half_up);
  if (!result) return Side::outside;
  const Range range(format);
  if (*result > range.highest) return Side::above;
  if (*result == range.highest) return Side::highest;
  if (*result > 0) return Side::positive;
  if (*result == 0) return Side::zero;
  if (*result > range.lowest) return Side::negative;
  return *result == range.lowest ? Side::lowest : Side::below;
}

/// A quarter turn of the operation's angle, in its unit; 0 if the operand is no angle.
double quarter_turn_of(Operation operation) {
  switch (operation) {
    case Operation::sin:
    case Operation::cos:
    case Operation::tan:
      return std::numbers::pi / 2;
    case Operation::sin_of_degrees:
    case Operation::cos_of_degrees:
    case Operation::tan_of_degrees:
      return 90;
    case Operation::sin_of_turns:
    case Operation::cos_of_turns:
    case Operation::tan_of_turns:
      return 0.25;
    default:
      return 0;
  }
}

/// The words of boundary_lattice(), as values.
std::set<Value> lattice_values(const Format& format) {
  std::set<Value> values;
  for (const std::uint64_t word : boundary_lattice(format.word_bits)) {
    const auto value = static_cast<Value>(word);
    const bool is_negative = format.is_signed && value >= format.limit();
    values.insert(is_negative ? value - 2 * format.limit() : value);
  }
  return values;
}

/// Inserts the operands within two words of the edge between `value` and the next.
void add_edge(std::set<Value>& to, Value value, const Range& range) {
  for (Value near = value - reach; near <= value + 1 + reach; ++near) {
    if (range.has(near)) to.insert(near);
  }
}

/// Inserts the operands within two words of the chosen multiples of a quarter turn.
void add_quarter_turns(std::set<Value>& to, Operation operation, const Format& format) {
  // An operand has at most 32 bits, and the double is exact to 53. So it is in error by much less
  // than a word.
  const double quarter = std::ldexp(quarter_turn_of(operation), format.fraction_bits);
  if (quarter == 0) return;
  const Range range(format);
  const auto add = [&](Value multiple) {
    const auto floor = static_cast<Value>(std::floor(static_cast<double>(multiple) * quarter));
    add_edge(to, floor, range);
  };
  const auto first = static_cast<Value>(static_cast<double>(range.lowest) / quarter);
  const auto last = static_cast<Value>(static_cast<double>(range.highest) / quarter);
  for (Value i = 0; i <= multiples; ++i) {
    for (const Value multiple : {-i, i, first + i, last - i}) {
      if (multiple >= first && multiple <= last) add(multiple);
    }
  }
}

/// Finds the edges between two operands. `side(value)` is the kind of the result there.
template <class SideAt>
class Search {
 public:
  Search(std::set<Value>& found, const Range& range, const SideAt& side)
      : found_(found), range_(range), side_(side) {}

  /// Finds the edges between neighbours of these operands.
  void between(const std::set<Value>& values) {
    if (values.empty()) return;
    Value before = *values.begin();
    Side side_before = side_(before);
    for (const Value value : values) {
      const Side side = side_(value);
      between(before, side_before, value, side);
      before = value;
      side_before = side;
    }
  }

 private:
  void between(Value a, Side side_of_a, Value b, Side side_of_b) {
    while (side_of_a != side_of_b) {
      if (b - a == 1) return add_edge(found_, a, range_);
      const Value middle = a + (b - a) / 2;
      const Side side = side_(middle);
      // A result between both has an edge on each side. That happens once for each kind at most.
      if (std::min(side_of_a, side_of_b) < side && side < std::max(side_of_a, side_of_b)) {
        between(a, side_of_a, middle, side);
      }
      if (side == side_of_b) {
        b = middle;
      } else {
        a = middle;
        side_of_a = side;
      }
    }
  }

  std::set<Value>& found_;
  const Range& range_;
  const SideAt& side_;
};

/// Operands to combine with edges in the other: 0, powers of two, three times these, and both ends.
std::set<Value> fixed_values(const Range& range) {
  std::set<Value> values{0, range.lowest, range.highest};
  for (Value power = 1; power <= range.highest; power *= 2) {
    for (const Value value : {power, -power, 3 * power, -3 * power}) {
      if (range.has(value)) values.insert(value);
    }
  }
  return values;
}

std::set<Value> edges_of_one(Operation operation, oracle::Function function, const Format& format) {
  const Range range(format);
  std::set<Value> found;
  for (const Value always : {range.lowest, Value{0}, range.highest}) {
    add_edge(found, always, range);
  }
  add_quarter_turns(found, operation, format);
  std::set<Value> visited = lattice_values(format);
  visited.insert(found.begin(), found.end());
  const auto side = [&](Value x) { return side_of(function, x, 0, format); };
  Search(found, range, side).between(visited);
  return found;
}

std::set<std::pair<Value, Value>> edges_of_two(oracle::Function function, const Format& format) {
  std::set<std::pair<Value, Value>> cases;
  const std::set<Value> lattice = lattice_values(format);
  const Range range(format);
  for (const Value fixed : fixed_values(range)) {
    std::set<Value> found;
    const auto with_first = [&](Value y) { return side_of(function, fixed, y, format); };
    Search(found, range, with_first).between(lattice);
    for (const Value y : found) cases.insert({fixed, y});
    found.clear();
    const auto with_second = [&](Value x) { return side_of(function, x, fixed, format); };
    Search(found, range, with_second).between(lattice);
    for (const Value x : found) cases.insert({x, fixed});
  }
  return cases;
}

std::vector<std::uint32_t> computed_words(Operation operation, const Format& format) {
  const oracle::Function function = oracle::function_named(name_of(operation)).value();
  std::vector<std::uint32_t> words;
  if (words_in(operation) == 1) {
    for (const Value x : edges_of_one(operation, function, format)) {
      words.push_back(format.word(x));
    }
    return words;
  }
  for (const auto& [x, y] : edges_of_two(function, format)) {
    words.push_back(format.word(x));
    words.push_back(format.word(y));
  }
  return words;
}

}  // namespace

std::span<const std::uint32_t> edge_words(Operation operation, const Format& format) {
  using Key = std::tuple<Operation, int, int, bool>;
  static std::mutex mutex;
  static std::map<Key, std::vector<std::uint32_t>> known;
  const std::lock_guard lock(mutex);
  const Key key{operation, format.word_bits, format.fraction_bits, format.is_signed};
  auto place = known.find(key);
  if (place == known.end()) place = known.emplace(key, computed_words(operation, format)).first;
  return place->second;
}

}  // namespace fixproof::cases
