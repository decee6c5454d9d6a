// The batch operations on each path. They take a whole chunk of cases at a time, and their reports
// must agree with the elements they mark.
#include "fixed/batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fixed/batch/radian.hpp"
#include "verify/parties/answer.hpp"
#include "verify/parties/parties.hpp"
#include "verify/parties/with_number.hpp"

namespace fixproof::parties {

namespace {

class Marks {
 public:
  // NOLINTNEXTLINE(*-avoid-c-arrays): std::vector<bool> is no span
  explicit Marks(std::size_t count) : size_(count), marks_(std::make_unique<bool[]>(count)) {}

  [[nodiscard]] std::span<bool> all() const { return {marks_.get(), size_}; }

  /// Tells whether the report has the number of marked elements and the first of them.
  [[nodiscard]] bool agree(const fixproof::batch::report& report) const {
    const auto first = std::find(all().begin(), all().end(), true);
    const bool none = first == all().end();
    return report.divide_errors + report.overflows + report.domain_errors ==
               static_cast<std::size_t>(std::count(all().begin(), all().end(), true)) &&
           report.first == (none ? fixproof::batch::report::nowhere
                                 : static_cast<std::size_t>(first - all().begin()));
  }

 private:
  std::size_t size_;
  // NOLINTNEXTLINE(*-avoid-c-arrays): std::vector<bool> is no span
  std::unique_ptr<bool[]> marks_;
};

template <class Number>
std::vector<Number> column(const Cases& asked, std::size_t words, std::size_t which) {
  std::vector<Number> numbers(asked.endings.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = number_of<Number>(asked.in[i * words + which]);
  }
  return numbers;
}

/// Answers all cases in one batch. All of them are broken if the report disagrees with the marks.
template <class Number>
void answer_column(cases::Operation operation, fixproof::batch::path path, const Cases& asked) {
  const std::size_t words = cases::words_in(operation);
  const auto a = column<Number>(asked, words, 0);
  std::vector<Number> results(a.size());
  const Marks marks(a.size());
  const fixproof::batch::options how{path, marks.all()};
  fixproof::batch::report report;
  if (operation == cases::Operation::mul) {
    report = fixproof::batch::multiply(a, column<Number>(asked, words, 1), results, how);
  } else if (operation == cases::Operation::div) {
    report = fixproof::batch::divide(a, column<Number>(asked, words, 1), results, how);
  } else if (operation == cases::Operation::sqrt) {
    report = fixproof::batch::sqrt(a, results, how);
  } else if (operation == cases::Operation::sin) {
    fixproof::batch::sin(a, results, path);
  } else {
    fixproof::batch::cos(a, results, path);
  }
  const bool sound = marks.agree(report);
  for (std::size_t i = 0; i < a.size(); ++i) {
    asked.out[i] = word_of(results[i]);
    const bool fault = operation == cases::Operation::div && marks.all()[i];
    asked.endings[i] = !sound ? Ending::broken : fault ? Ending::divide_error : Ending::value;
  }
}

/// A batch has one transform, but each case has its own, so each case fills a block with its vertex
/// and those of the cases after it. The place of the vertex rotates, and blocks alternate between
/// interleaved vertices and separate arrays. The policies wrap, so any report or mark is an error.
template <class Number>
void answer_transforms(fixproof::batch::path path, const Cases& asked) {
  constexpr std::size_t block = 16;  // the lanes of the widest registers
  constexpr std::size_t words = 15;
  const std::size_t cases = asked.endings.size();
  std::array<std::array<Number, 3>, block> in;
  std::array<std::array<Number, block>, 3> columns;
  const Marks marks(block);
  for (std::size_t i = 0; i < cases; ++i) {
    std::array<std::array<Number, 4>, 3> rows;
    for (std::size_t k = 0; k < 12; ++k) {
      rows[k / 4][k % 4] = number_of<Number>(asked.in[i * words + k]);
    }
    const std::size_t place = i % block;
    for (std::size_t k = 0; k < block; ++k) {
      const std::size_t other = (i + k) % cases;
      for (std::size_t c = 0; c < 3; ++c) {
        const auto x = number_of<Number>(asked.in[other * words + 12 + c]);
        in[(place + k) % block][c] = x;
        columns[c][(place + k) % block] = x;
      }
    }
    const bool interleaved = i / block % 2 == 0;
    const fixproof::batch::options how{path, marks.all()};
    fixproof::batch::report report;
    if (interleaved) {
      report = fixproof::batch::transform(rows, in, in, how);
    } else {
      auto& [x, y, z] = columns;
      report = fixproof::batch::transform(rows, x, y, z, x, y, z, how);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      asked.out[3 * i + c] = word_of(interleaved ? in[place][c] : columns[c][place]);
    }
    const bool sound = report.clean() && marks.agree(report);
    asked.endings[i] = sound ? Ending::value : Ending::broken;
  }
}

struct NamedPath {
  fixproof::batch::path path;
  const char* name;
};

constexpr std::array paths{NamedPath{fixproof::batch::path::portable, "portable"},
                           NamedPath{fixproof::batch::path::neon, "neon"},
                           NamedPath{fixproof::batch::path::avx2, "avx2"},
                           NamedPath{fixproof::batch::path::avx512, "avx512"}};

std::string_view name_of(fixproof::batch::path path) {
  return std::find_if(paths.begin(), paths.end(),
                      [path](const NamedPath& named) { return named.path == path; })
      ->name;
}

class BatchParty final : public Party {
 public:
  BatchParty(std::string name, fixproof::batch::path path) : name_(std::move(name)), path_(path) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string identity() const override {
    return fmt::format("{}, path {}", fixed_version(), name_of(path_));
  }
  [[nodiscard]] std::string absence() const override {
    return fixproof::batch::has(path_) ? "" : "this processor or this build does not have it";
  }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    using enum cases::Operation;
    return absence().empty() && cases::has_routine_format(v) &&
           (v.operation == mul || v.operation == div || v.operation == sqrt || v.operation == sin ||
            v.operation == cos || v.operation == xformvec);
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    with_number(v, [&]<class Number>(std::type_identity<Number> /*type*/) {
      if (v.operation == cases::Operation::xformvec) {
        answer_transforms<Number>(path_, asked);
      } else {
        answer_column<Number>(v.operation, path_, asked);
      }
    });
  }

 private:
  std::string name_;
  fixproof::batch::path path_;
};

}  // namespace

std::vector<std::unique_ptr<Party>> make_batch_parties() {
  std::vector<std::unique_ptr<Party>> made;
  made.push_back(std::make_unique<BatchParty>("batch", fixproof::batch::best()));
  for (const auto& [path, name] : paths) {
    made.push_back(std::make_unique<BatchParty>(fmt::format("batch-{}", name), path));
  }
  return made;
}

}  // namespace fixproof::parties
