#include "tests/fixed/formats/batch_check.hpp"

namespace batch_formats {

Fault first(std::initializer_list<Fault> faults) {
  for (const Fault fault : faults) {
    if (fault != Fault::none) return fault;
  }
  return Fault::none;
}

std::vector<path> paths() {
  std::vector<path> there;
  for (const path p : {path::portable, path::neon, path::avx2, path::avx512}) {
    if (fixproof::batch::has(p)) there.push_back(p);
  }
  return there;
}

std::vector<integer> operands(const Type& type, std::size_t count, unsigned seed) {
  // Of every length, so that the products and quotients of some are in range.
  const auto wide = Type::of<fixproof::number<std::int64_t, 0>>();
  const auto edges = reference::operands(wide, 60);
  std::mt19937 random(seed);
  std::vector<integer> all;
  while (all.size() < count) {
    const integer edge = wide.value(edges[random() % edges.size()]);
    all.push_back(type.wrapped(random() % 3 == 0 ? type.lowest + edge % 3 : edge));
  }
  return all;
}

Column::Column(const Type& type, const std::vector<integer>& values)
    : type_(type), bytes_(values.size() * type.size) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    // Little-endian or not: from a 64-bit word of this machine.
    auto word =
        static_cast<std::uint64_t>(values[i] < 0 ? values[i] + reference::power(2, 64) : values[i]);
    if constexpr (std::endian::native == std::endian::big) word <<= 64 - type.bits();
    std::memcpy(bytes_.data() + i * type.size, &word, type.size);
  }
}

integer Column::operator[](std::size_t i) const {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes_.data() + i * type_.size, type_.size);
  if constexpr (std::endian::native == std::endian::big) word >>= 64 - type_.bits();
  return type_.wrapped(integer(word));
}

namespace {

/// One operation with its operands and results.
class Check {
 public:
  static constexpr std::size_t size = 400;

  explicit Check(const Operation& operation) : operation_(operation) {
    for (unsigned seed = 1; seed <= 3; ++seed) {
      operands_.push_back(operands(operation.type, size, seed));
    }
    for (std::size_t i = 0; i < size; ++i) {
      want_.push_back(operation.expect(operands_[0][i], operands_[1][i], operands_[2][i]));
    }
  }

  void at_every_length(path use) const {
    for (std::size_t count = 0; count <= 40; ++count) {
      part(use, 7 * count % (size - 40), count % 5, count);
    }
    part(use, 0, 3, size);
  }

  void in_place(path use) const {
    for (std::size_t which = 0; which < 3; ++which) {
      auto columns = inputs();
      const auto marks = std::make_unique<bool[]>(size);
      const Spans spans{{&columns[0], &columns[1], &columns[2], &columns[which]}, 0, 0, size};
      operation_.call(spans, {use, {marks.get(), size}});
      compare(columns[which], 0, 0, size);
    }
  }

  /// Without marks.
  void thrown(path use) const {
    std::size_t first = 0;
    while (first < size && !operation_.throws(want_[first].fault)) ++first;
    auto columns = inputs();
    Column out(operation_.type, std::vector<integer>(size));
    std::string text;
    Fault kind = Fault::none;
    try {
      const auto report =
          operation_.call({{&columns[0], &columns[1], &columns[2], &out}, 0, 0, size}, {use, {}});
      ASSERT_EQ(report, report_of(0, size));
    } catch (const fixproof::divide_error& error) {
      text = error.what();
      kind = Fault::divide_error;
    } catch (const fixproof::overflow_error& error) {
      text = error.what();
      kind = Fault::overflow;
    } catch (const fixproof::domain_error& error) {
      text = error.what();
      kind = Fault::domain_error;
    }
    compare(out, 0, 0, size);
    ASSERT_EQ(kind, first == size ? Fault::none : want_[first].fault) << text;
    if (first == size) return;
    const auto same = std::count_if(want_.begin(), want_.end(),
                                    [&](const Result& one) { return one.fault == kind; });
    const std::string place =
        "(element " + std::to_string(first) + ", " + std::to_string(same) + " in all)";
    ASSERT_NE(text.find(place), std::string::npos) << text << ", expected " << place;
  }

 private:
  [[nodiscard]] std::vector<Column> inputs() const {
    std::vector<Column> columns;
    for (const auto& values : operands_) columns.emplace_back(operation_.type, values);
    return columns;
  }

  [[nodiscard]] fixproof::batch::report report_of(std::size_t at, std::size_t count) const {
    fixproof::batch::report report;
    for (std::size_t i = 0; i < count; ++i) {
      const Fault fault = want_[at + i].fault;
      if (fault == Fault::none) continue;
      report.divide_errors += fault == Fault::divide_error ? 1U : 0U;
      report.overflows += fault == Fault::overflow ? 1U : 0U;
      report.domain_errors += fault == Fault::domain_error ? 1U : 0U;
      report.first = std::min(report.first, i);
    }
    return report;
  }

  void compare(const Column& got, std::size_t at, std::size_t at_result, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(got[at_result + i], want_[at + i].raw)
          << "element " << i << " of " << count << ", stored integers " << operands_[0][at + i]
          << ", " << operands_[1][at + i] << ", " << operands_[2][at + i];
    }
  }

  /// @param before elements before the results
  void part(path use, std::size_t at, std::size_t before, std::size_t count) const {
    const integer noise = 0x5a;
    auto columns = inputs();
    Column out(operation_.type, std::vector<integer>(before + count + 1, noise));
    const auto marks = std::make_unique<bool[]>(count + 1);
    for (std::size_t i = 0; i <= count; ++i) marks[i] = i % 3 == 0;
    // Marks of no elements are no marks.
    const auto report =
        operation_.call({{&columns[0], &columns[1], &columns[2], &out}, at, before, count},
                        {use, {marks.get(), count}});
    compare(out, at, before, count);
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_EQ(marks[i], want_[at + i].fault != Fault::none) << "mark " << i << " of " << count;
    }
    ASSERT_EQ(report, report_of(at, count)) << count << " elements";
    ASSERT_EQ(marks[count], count % 3 == 0);
    ASSERT_EQ(out[before + count], noise);
    for (std::size_t i = 0; i < before; ++i) ASSERT_EQ(out[i], noise);
  }

  const Operation& operation_;
  std::vector<std::vector<integer>> operands_;
  std::vector<Result> want_;
};

}  // namespace

void check(const Operation& operation) {
  SCOPED_TRACE(testing::Message() << operation.type);
  const Check one(operation);
  for (const path use : paths()) {
    SCOPED_TRACE("path " + std::to_string(static_cast<int>(use)));
    one.at_every_length(use);
    one.in_place(use);
    one.thrown(use);
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace batch_formats
