#include "judge/desync/cause.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

namespace fixproof::desync {

namespace {

/// How far from its place the counterpart of a record may be, and how many records after the
/// difference are searched for the other values of an exchange.
constexpr std::size_t window = 64;

/// The records of both sides, and the equal record of the other side for each. The first of several
/// equal records of A belongs to the first of those of B, the second to the second.
struct Matched {
  static constexpr std::size_t none = ~std::size_t{0};

  Matched(const std::vector<Record>& side_a, const std::vector<Record>& side_b)
      : a(side_a), b(side_b), of_a(side_a.size(), none), of_b(side_b.size(), none) {
    std::map<std::vector<word>, std::vector<std::size_t>> in_a;
    for (std::size_t i = 0; i < a.size(); ++i) in_a[a[i].words].push_back(i);
    std::map<std::vector<word>, std::size_t> seen;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t turn = seen[b[j].words]++;
      const auto found = in_a.find(b[j].words);
      if (found == in_a.end() || turn >= found->second.size()) continue;
      const std::size_t i = found->second[turn];
      if (std::max(i, j) - std::min(i, j) >= window) continue;
      of_a[i] = j;
      of_b[j] = i;
    }
  }

  const std::vector<Record>& a;
  const std::vector<Record>& b;
  std::vector<std::size_t> of_a;  ///< Indices of B, or none.
  std::vector<std::size_t> of_b;  ///< Indices of A, or none.
};

/// Tells whether both sides apply the same two operations to one value in a different order, as in
/// x + a + b and x + b + a.
bool are_swapped(const Operation& a, const Operation& a_next, const Operation& b,
                 const Operation& b_next) {
  const auto is_binary = [](const Operation& o) {
    return o.operands.size() == 2 && o.results.size() == 1;
  };
  if (!is_binary(a) || !is_binary(a_next) || !is_binary(b) || !is_binary(b_next)) return false;
  const auto is_same = [](const Operation& x, const Operation& y) {
    return x.kind == y.kind && x.type == y.type && x.operands[1] == y.operands[1];
  };
  return is_same(a, b_next) && is_same(a_next, b) && a.operands[0] == b.operands[0] &&
         a_next.operands[0] == a.results[0] && b_next.operands[0] == b.results[0];
}

/// Tells whether a value is an integer, and no number of the type.
bool is_integer(const Value& value) {
  return (value.type & 0xff) == static_cast<word>(record::value_class::integer);
}

/// Tells whether an operation makes a number from something other than numbers.
bool enters(const Operation& o) {
  return o.kind == record::kind::from_raw || std::ranges::all_of(o.operands, is_integer);
}

bool are_alike(const Operation& x, const Operation& y) {
  return x.kind == y.kind && x.type == y.type && x.operands.size() == y.operands.size();
}

std::vector<Value> sorted(std::vector<Value> values) {
  std::ranges::sort(values, {}, [](const Value& v) { return std::tuple(v.type, v.bits); });
  return values;
}

/// Two values that stand in the same place, one on each side, as operands.
using Pair = std::pair<Value, Value>;

std::vector<Pair> differing_operands(const Operation& x, const Operation& y) {
  std::vector<Pair> pairs;
  for (std::size_t k = 0; k < x.operands.size(); ++k) {
    if (!(x.operands[k] == y.operands[k])) pairs.emplace_back(x.operands[k], y.operands[k]);
  }
  return pairs;
}

/// Returns the last record before `end` that makes `value` and has a counterpart, or none.
std::size_t maker_of(const Value& value, const std::vector<Record>& records,
                     const std::vector<std::size_t>& counterparts, std::size_t end) {
  for (std::size_t i = end; i-- > 0;) {
    if (counterparts[i] == Matched::none ||
        !record::is_operation(record::kind_of(records[i].words[0])))
      continue;
    const Operation maker = operation_of(records[i].words);
    if (std::ranges::find(maker.results, value) != maker.results.end()) return i;
  }
  return Matched::none;
}

/// The records that make the values of a pair, as indices.
struct Makers {
  std::size_t of_a_in_a;
  std::size_t of_a_in_b;
  std::size_t of_b_in_a;
  std::size_t of_b_in_b;

  /// Whether the sides make the two values in different orders.
  [[nodiscard]] bool are_reversed() const {
    return (of_a_in_a < of_b_in_a) != (of_a_in_b < of_b_in_b);
  }
};

/// Returns nothing unless A makes its value before the record `i`, B makes its value before the
/// record `j`, and both sides make both values.
std::optional<Makers> makers_of(const Matched& records, const Pair& pair, std::size_t i,
                                std::size_t j) {
  const std::size_t of_a = maker_of(pair.first, records.a, records.of_a, i);
  const std::size_t of_b = maker_of(pair.second, records.b, records.of_b, j);
  if (of_a == Matched::none || of_b == Matched::none) return std::nullopt;
  return Makers{of_a, records.of_a[of_a], records.of_b[of_b], of_b};
}

/// Returns the records without a counterpart among the next ones, from `first` on.
std::vector<std::size_t> unmatched(const std::vector<std::size_t>& counterparts,
                                   std::size_t first) {
  std::vector<std::size_t> found;
  const std::size_t end = std::min(counterparts.size(), first + window);
  for (std::size_t at = first; at < end; ++at) {
    if (counterparts[at] == Matched::none) found.push_back(at);
  }
  return found;
}

/// Returns the operands that differ in the records without a counterpart, from `i` and `j` on, if
/// both sides make both values. Alike operations are compared in their order. What is computed from
/// another operand differs, too, but the other side does not make it.
std::vector<Pair> later_pairs(const Matched& records, std::size_t i, std::size_t j) {
  std::vector<Pair> pairs;
  std::vector<std::size_t> rest = unmatched(records.of_b, j);
  for (const std::size_t k : unmatched(records.of_a, i)) {
    const Operation x = operation_of(records.a[k].words);
    const auto alike = std::ranges::find_if(
        rest, [&](std::size_t l) { return are_alike(x, operation_of(records.b[l].words)); });
    if (alike == rest.end()) continue;
    const std::size_t l = *alike;
    rest.erase(alike);
    for (const Pair& pair : differing_operands(x, operation_of(records.b[l].words))) {
      if (makers_of(records, pair, k, l)) pairs.push_back(pair);
    }
  }
  return pairs;
}

/// Tells whether the sides use the same values in different places: A uses the value of B for one
/// of A, in a chain of pairs that ends with the first value of A. The answer does not depend on
/// which side is A.
bool is_exchange(const Pair& pair, std::vector<Pair> others) {
  std::vector<Value> reached{pair.second};
  for (std::size_t next = 0; next < reached.size(); ++next) {
    if (reached[next] == pair.first) return true;
    const Value from = reached[next];
    std::erase_if(others, [&](const Pair& other) {
      if (!(other.first == from)) return false;
      reached.push_back(other.second);
      return true;
    });
  }
  return false;
}

/// Says why two alike operations have different operands.
Cause cause_of_operands(const Matched& records, std::size_t i, std::size_t j, const Operation& x,
                        const Operation& y) {
  const std::vector<Pair> pairs = differing_operands(x, y);
  if (std::ranges::all_of(pairs, [](const Pair& pair) {
        return is_integer(pair.first) && is_integer(pair.second);
      })) {
    return {Verdict::integer, {}};
  }
  const bool are_permuted = sorted(x.operands) == sorted(y.operands);
  std::optional<Makers> makers;
  for (const Pair& pair : pairs) {
    makers = makers_of(records, pair, i, j);
    if (!makers) continue;
    if (!are_permuted && !is_exchange(pair, later_pairs(records, i, j))) {
      return {Verdict::operands, {}};
    }
    const auto number = [](const std::vector<Record>& side, std::size_t at) {
      return side[at].operation;
    };
    const Origin origin{pair.first,
                        pair.second,
                        number(records.a, makers->of_a_in_a),
                        number(records.b, makers->of_a_in_b),
                        number(records.a, makers->of_b_in_a),
                        number(records.b, makers->of_b_in_b)};
    if (makers->are_reversed()) return {Verdict::evaluation, origin};
    return {are_permuted ? Verdict::swapped : Verdict::moved, origin};
  }
  return {are_permuted ? Verdict::swapped : Verdict::operands, {}};
}

}  // namespace

Cause cause_of(const std::vector<Record>& a, std::size_t i, const std::vector<Record>& b,
               std::size_t j) {
  const Operation x = operation_of(a[i].words);
  const Operation y = operation_of(b[j].words);
  if (!record::is_operation(x.kind) || !record::is_operation(y.kind)) return {Verdict::path, {}};
  if (x == y) return {Verdict::path, {}};  // one side has the operation more often
  const bool is_same_operation = x.kind == y.kind && x.type == y.type;
  if (is_same_operation && x.operands == y.operands) {
    if (x.kind == record::kind::accumulator_result) return {Verdict::accumulator, {}};
    const bool is_read = x.kind == record::kind::convert || x.kind == record::kind::from_text;
    return {is_read && x.operands.empty() ? Verdict::input : Verdict::arithmetic, {}};
  }
  if (i + 1 < a.size() && j + 1 < b.size() &&
      are_swapped(x, operation_of(a[i + 1].words), y, operation_of(b[j + 1].words))) {
    return {Verdict::order, {}};
  }
  if (x.kind != y.kind) return {Verdict::path, {}};
  if (x.type != y.type) return {Verdict::type, {}};
  if (enters(x) && enters(y)) return {Verdict::input, {}};
  if (!are_alike(x, y)) return {Verdict::operands, {}};
  return cause_of_operands(Matched(a, b), i, j, x, y);
}

}  // namespace fixproof::desync
